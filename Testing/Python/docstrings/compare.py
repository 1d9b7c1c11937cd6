# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""compare.py [-o FOLDER] [--part N/M] [REGEX]: draws the examples in PyVista's docstrings without and with vtkOIT.

Their pictures must be the same, but where something is translucent: a picture without translucent meshes may not
differ at all, one with them only within 2 pixels of them. FOLDER (default: docstrings) gets report.html with the
pictures that differ. --part: every Mth example, from the Nth on (1 to M). REGEX: only examples whose names have it.

Status: 1 when a picture differs elsewhere, 125 where there is no PyVista. Not part of ctest: all of it takes long.
"""

import argparse
import importlib.util
import json
import os
import re
import subprocess
import sys
import tempfile

import numpy
from vtkoit import application, picture
from vtkoit.bench import machine
from vtkoit.compare import AMPLIFIED
from vtkoit.report import page

sys.path.insert(0, os.path.dirname(sys.path[0]))
import Support  # noqa: E402 # pylint: disable=wrong-import-position

DRAW = os.path.join(os.path.dirname(os.path.abspath(__file__)), "draw.py")
CHUNK = 25  # examples a process
TIMEOUT = 300  # seconds that it may draw nothing
NEAR = 2  # pixels beside something translucent: smoothed edges
AGAIN = 5  # how often PyVista alone draws what seems wrong: some examples have chance in them
STEPS = 2  # of 255, in pictures with something translucent
SHOWN = 40  # most pictures in the report


def draw(names, folder, environment):
    """Draws examples: dict of name to what draw.py tells of it. One that ends the process is told, and left out."""
    os.makedirs(folder)
    left, found = list(names), {}
    while left:
        with open(os.path.join(folder, "results"), "w", encoding="utf-8"):
            pass
        try:
            done = subprocess.run([sys.executable, DRAW, folder, *left[:CHUNK]], env=environment, check=False,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  timeout=TIMEOUT)
            reason = "the process ended with status %d" % done.returncode
        except subprocess.TimeoutExpired:
            reason = "not done after %d s" % TIMEOUT
        begun = None
        with open(os.path.join(folder, "results"), encoding="utf-8") as file:
            for line in map(json.loads, file):
                begun = line.get("begun")
                if begun is None:
                    found[line["name"]] = line
        if begun is not None:
            found[begun] = {"stopped": reason, "pictures": []}
        elif not any(name in found for name in left):
            sys.exit("draw.py does not run: %s" % reason)
        left = [name for name in left if name not in found]
        print("%s: %d of %d examples" % (os.path.basename(folder), len(found), len(names)), flush=True)
    return found


def near(mask):
    """A mask of pixels, and those beside them."""
    grown = mask.copy()
    for _ in range(NEAR):
        for axis in (0, 1):
            for step in (-1, 1):
                moved = numpy.roll(grown, step, axis)
                edge = [slice(None)] * 2
                edge[axis] = 0 if step == 1 else -1
                moved[tuple(edge)] = False
                grown |= moved
    return grown


class Judge:
    """Compares what the two folders have of an example."""

    def __init__(self, stock, ours):
        self.folders = stock, ours
        self.counts = dict.fromkeys(("same", "differ", "wrong"), 0)
        self.rows, self.scenes = [], []

    def compare(self, name, stock, ours):
        """stock, ours: what draw.py told of an example."""
        if len(stock["pictures"]) != len(ours["pictures"]):
            self.add(name, "wrong", "%d pictures without, %d with" % (len(stock["pictures"]), len(ours["pictures"])))
            return
        for number, (before, after) in enumerate(zip(stock["pictures"], ours["pictures"])):
            self.compare_pictures("%s, %d" % (name, number + 1) if number else name, before, after)

    def compare_pictures(self, name, before, after):
        first, second = self.read(0, before["picture"]), self.read(1, after["picture"])
        if first.shape != second.shape:
            self.add(name, "wrong", "of other sizes")
            return
        difference = abs(first - second).max(axis=2)
        if not before["translucent"]:
            where, steps, what = difference > 0, 0, "nothing is translucent"
        else:
            without, opaque = (self.read(0, before[kind]) for kind in ("without", "opaque"))
            where, steps, what = difference > STEPS, STEPS, "beside what is translucent"
            where &= ~near((abs(first - without).max(axis=2) > 0) | (abs(opaque - without).max(axis=2) > 0))
        if where.any():
            self.add(name, "wrong", "%d pixels by up to %d steps, %s" % (where.sum(), difference[where].max(), what))
        elif difference.max() <= steps:
            self.counts["same"] += 1
            return
        else:
            self.add(name, "differ", "%d pixels by up to %d steps" % ((difference > STEPS).sum(), difference.max()))
        amplified = numpy.clip(difference[..., None] * AMPLIFIED, 0, 255).repeat(3, axis=2)
        self.scenes.append(page.Scene(name, [
            page.Shown("PyVista alone", png(first), None, ""),
            page.Shown("with vtkOIT", png(second), png(amplified), self.rows[-1][2])]))

    def add(self, name, kind, text):
        self.counts[kind] += 1
        self.rows.append([name, kind, text])

    def read(self, which, name):
        return numpy.load(os.path.join(self.folders[which], name)).astype(int)


def png(values):
    return picture.png_of(values.astype(numpy.uint8))


def repeated(names, folder, environment, stock):
    """Those of the names whose pictures PyVista alone draws the same each time."""
    before = os.path.join(os.path.dirname(folder), "stock")
    for number in range(AGAIN if names else 0):
        here = "%s-%d" % (folder, number + 1)
        again = draw(names, here, environment)
        names = [name for name in names if len(again[name]["pictures"]) == len(stock[name]["pictures"]) and all(
            numpy.array_equal(numpy.load(os.path.join(before, one["picture"])),
                              numpy.load(os.path.join(here, other["picture"])))
            for one, other in zip(stock[name]["pictures"], again[name]["pictures"]))]
        if not names:
            break
    return names


def report(judge, summary, output):
    lines = [summary]
    if len(judge.scenes) > SHOWN:
        lines.append("The first %d pictures that differ." % SHOWN)
    page.write(page.Page(
        "PyVista's docstrings", lines, judge.scenes[:SHOWN], "the difference, %d times" % AMPLIFIED,
        [page.Table("Pictures that differ", ["example", "", "how"], judge.rows)], machine.describe()),
        os.path.join(output, "report.html"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("-o", dest="output", default="docstrings")
    parser.add_argument("--part", default="1/1")
    parser.add_argument("regex", nargs="?", default="")
    options = parser.parse_args()
    if importlib.util.find_spec("pyvista") is None:
        print("needs PyVista (Debian testing: python3-pyvista)")
        return 125
    plain = Support.bare_environment()
    reached = {name: value for name, value in application.environment("python3").items()
               if name in plain or name.startswith(("VTK_AUTOLOAD", "VTKOIT"))}
    first, step = map(int, options.part.split("/"))
    listed = subprocess.run([sys.executable, DRAW, "--list"], env=plain, check=True, capture_output=True, text=True)
    everything = listed.stdout.split()
    names = [name for name in everything if re.search(options.regex, name)][first - 1::step]
    os.makedirs(options.output, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=options.output) as folder:
        stock, ours = (draw(names, os.path.join(folder, name), environment)
                       for name, environment in (("stock", plain), ("vtkOIT", reached)))
        usable = [name for name in names if stock[name]["pictures"]]
        trial = Judge(os.path.join(folder, "stock"), os.path.join(folder, "vtkOIT"))
        odd = []
        for name in usable:
            before = trial.counts["wrong"]
            trial.compare(name, stock[name], ours[name])
            if trial.counts["wrong"] > before:
                odd.append(name)
        certain = repeated(odd, os.path.join(folder, "again"), plain, stock)
        judge = Judge(*trial.folders)
        for name in usable:
            if name in certain or name not in odd:
                judge.compare(name, stock[name], ours[name])
        summary = ("%d examples of %d; %d cannot be drawn here, %d are drawn by chance; %d pictures are the same, %d differ where "
                   "something is translucent, %d elsewhere" % (
                       len(names), len(everything), len(names) - len(usable), len(odd) - len(certain),
                       judge.counts["same"], judge.counts["differ"], judge.counts["wrong"]))
        report(judge, summary, options.output)
    for name in names:
        if not stock[name]["pictures"]:
            print("%s: not drawn by PyVista alone: %s" % (name, stock[name]["stopped"] or "it shows nothing"))
    for row in judge.rows:
        print("%s: %s: %s" % tuple(row))
    print(summary)
    return 1 if judge.counts["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
