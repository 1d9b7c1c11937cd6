# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command conform."""

import json
import os
import tempfile

import numpy

from ..bench import machine
from ..errors import Error
from ..passes import methods
from ..picture import png_of
from ..report import page
from ..windows import headless
from . import document, program
from .scenes import SCENES
from .verdict import Verdict, error_text, is_wrong

CONTENDERS = ("vtk-weighted", "vtk-dual", "vtk-peel", "abuffer")
AMPLIFIED = 16  # differences, in their pictures


def run(options, progress):
    """Does what the command line says; options: argparse.Namespace. Raises Error."""
    if options.list:
        _list()
        return
    scenes = _scenes(options.scenes)
    contenders = _contenders(options.methods)
    executable = program.find(options.program)
    if options.document and not os.path.isdir(options.document):
        raise Error("--document %s: there is no such folder" % options.document)
    try:
        headless()
        os.makedirs(options.output, exist_ok=True)
        described = machine.describe()
        with tempfile.TemporaryDirectory() as folder:
            verdict = Verdict(scenes, contenders, _draw(executable, scenes, contenders, folder, progress))
            made = _page(verdict, described)
    except RuntimeError as error:
        raise Error(str(error)) from None
    except OSError as error:
        raise Error("%s: cannot be made: %s" % (options.output, error.strerror)) from None
    page.write(made, os.path.join(options.output, "report.html"))
    _write_json(os.path.join(options.output, "conform.json"), verdict, described)
    if options.document:
        document.write(options.document, verdict, described, _command(options))
    progress.clear()
    _print(verdict, described)
    print("%s: report.html, conform.json" % options.output)


def _list():
    for number, scene in SCENES.items():
        print("%2d  %s" % (number, scene.title))
    for name in list(program.VTK) + methods():
        print("%-16s  %s" % (name, document.about(name)))


def _scenes(numbers):
    """The scenes of a list of str, numbers, as a dict; all for None."""
    unknown = [text for text in numbers or () if not text.isdigit() or int(text) not in SCENES]
    if unknown:
        raise Error("--scenes %s: no such scene; --list tells what there is" % unknown[0])
    return {int(text): SCENES[int(text)] for text in numbers} if numbers else SCENES


def _contenders(names):
    for name in names or ():
        if name not in program.VTK and name not in methods():
            raise Error("method %s: unknown; the methods are: %s" % (
                name, " ".join(list(program.VTK) + methods())))
    return list(dict.fromkeys(names or CONTENDERS))


def _draw(executable, scenes, contenders, folder, progress):
    """The comparisons of all contenders, list of dict."""
    tests = list(dict.fromkeys(test for scene in scenes.values() for test in scene.tests))
    lines = []
    for number, test in enumerate(tests):
        for contender in contenders:
            progress.show("%s (%d of %d): %s" % (test, number + 1, len(tests), contender))
            mine = os.path.join(folder, "%s-%s" % (test, contender))
            os.mkdir(mine)
            lines += program.run(executable, test, contender, mine)
    return lines


def _page(verdict, described):
    """The page.Page of a Verdict, whose pictures are still there."""
    scenes = []
    for number, scene in sorted(verdict.scenes.items()):
        lines = verdict.shown(number)
        if lines:
            what = next(iter(lines.values()))["what"]
            scenes.append(page.Scene("%d: %s (%s)" % (number, scene.title, what), _shown(lines)))
    head, rows = verdict.matrix()
    tables = [page.Table("Errors of colour and alpha, from 0 to 1", ["scene"] + head[2:],
                         [["%s: %s" % (row[0], row[1])] + row[2:] for row in rows])]
    if verdict.problems:
        tables.append(page.Table("Tests that did not end", ["test", "method", "what"], [
            [line["test"], line["contender"], line["problem"]] for line in verdict.problems]))
    return page.Page(
        "Conformance of translucent passes",
        ["%s: %s" % (name, document.about(name).replace("`", "")) for name in verdict.contenders]
        + [" ".join(document.HOW.split())], scenes,
        "Differences are %d times what is more than a step of 255; black is right." % AMPLIFIED, tables, described)


def _shown(lines):
    """The pictures of one comparison, list of page.Shown. lines: dict of contender to comparison."""
    result = []
    for contender, line in lines.items():
        right = program.read_picture(line["picture"] + "-should.ppm")
        color = program.read_picture(line["picture"] + "-is.ppm")
        if not result:
            result.append(page.Shown("right picture", png_of(right), None, "the known answer"))
        # The answer is of 8 bits here: what rounds to it is right.
        off = numpy.abs(color.astype(int) - right.astype(int))
        difference = numpy.clip(AMPLIFIED * numpy.maximum(0, off - 1), 0, 255).astype(numpy.uint8)
        note = "; ".join("%s off by up to %s, %s" % (name, error_text(line[channel]), (
            "wrong" if is_wrong(line, channel) else "right")) for channel, name in (
                ("color", "colour"), ("alpha", "alpha")))
        result.append(page.Shown(contender, png_of(color), png_of(difference), note))
    return result


def _write_json(path, verdict, described):
    lines = [{key: value for key, value in line.items() if key not in ("picture", "key")}
             for cell in verdict.by_cell.values() for line in cell]
    try:
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"machine": described, "results": lines, "problems": verdict.problems}, file, indent=1)
            file.write("\n")
    except OSError as error:
        raise Error("%s: cannot be written: %s" % (path, error.strerror)) from None


def _print(verdict, described):
    print(machine.line(described))
    print("Errors of colour and alpha from 0 to 1, and how many of the comparisons are wrong")
    head, rows = verdict.matrix()
    widths = [max(len(row[column]) for row in [head] + rows) for column in range(len(head))]
    del widths[1]
    for row in [head] + rows:
        cells = row[:1] + row[2:]
        print("  ".join("%-*s" % (width, cell) for width, cell in zip(widths, cells)) + "  " + row[1])
    for line in verdict.problems:
        print("%(test)s by %(contender)s: %(problem)s" % line)


def _command(options):
    """The command that makes the page again, str."""
    parts = ["vtkoit conform"]
    for name in ("scenes", "methods"):
        if getattr(options, name):
            parts += ["--" + name] + getattr(options, name)
    return " ".join(parts + ["--document docs"])
