# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What both fuzzers share: options, which frames may be compared, and what is left of a failure."""

import argparse
import copy
import json
import os
import re
import time

import numpy
from vtkoit import picture

# Lines that a right picture may come with: another exact method has drawn it.
HONEST = re.compile(r"^(\S+: )?Rendered by another exact method: ")


def parser(text, unit):
    """The options of both. unit: str, what --count counts."""
    result = argparse.ArgumentParser(description=text, allow_abbrev=False)
    result.add_argument("--seed", type=int, default=1, help="of the first one; each one has the next seed")
    result.add_argument("--count", type=int, help="number of %s" % unit)
    result.add_argument("--seconds", type=float, help="how long, if there is no --count; 0: without end")
    result.add_argument("--size", type=int, default=64, help="of the pictures, about, in pixels")
    result.add_argument("--folder", default=".", help="for what is left of failures")
    result.add_argument("--replay", metavar="FILE", help="a description that a failure has left")
    result.add_argument("-v", "--verbose", action="store_true", help="a line for each")
    return result


def seeds(options):
    """The seeds that the options ask for."""
    seed = options.seed
    start = time.monotonic()
    while True:
        if options.count is not None:
            if seed >= options.seed + options.count:
                return
        elif options.seconds and time.monotonic() - start > options.seconds:
            return
        elif options.seconds is None and seed >= options.seed + 10:
            return
        yield seed
        seed += 1


def complaint(frame):
    """What no frame may come with: an error of OpenGL, or lines beside a picture that is said to be
    right; str, empty for nothing."""
    if frame.gl_error:
        return "OpenGL error 0x%x" % frame.gl_error
    lines = [line for line in frame.printed if not HONEST.match(line)]
    if frame.exact and lines:
        return "printed, and exact: " + lines[0]
    # Not exact is right where the line says why.
    if not frame.exact and not lines and not frame.told:
        return "not exact, and not a word of it"
    return ""


def differ(first, second):
    """(largest difference of a component in steps of 255, number of pixels with more than one)."""
    if first.pixels.shape != second.pixels.shape:
        return 255, first.pixels.shape[0] * first.pixels.shape[1]
    steps = numpy.abs(first.pixels.astype(int) - second.pixels.astype(int)).max(axis=2)
    return int(steps.max()), int((steps > 1).sum())


def keep(folder, name, scene, frames):
    """Leaves the description and the pictures of a failure. frames: dict of str to Frame."""
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, name)
    with open(path + ".json", "w", encoding="utf-8") as file:
        json.dump(scene, file, indent=1)
    for label, frame in frames.items():
        picture.save(frame.pixels, "%s-%s.png" % (path, label))
    return path


def smaller(scene, fails):
    """The scene without what it does not need to fail. fails: a function of a description."""
    def attempt(edit):
        nonlocal scene
        candidate = copy.deepcopy(scene)
        edit(candidate)
        if candidate != scene and fails(candidate):
            scene = candidate
            return True
        return False

    for i in reversed(range(len(scene["renderers"]))):
        if len(scene["renderers"]) > 1:
            attempt(lambda s, i=i: s["renderers"].pop(i))
    for number in list(scene["props"]):
        def remove(s, number=number):
            del s["props"][number]
            for renderer in s["renderers"]:
                renderer["props"] = [n for n in renderer["props"] if n != number]
        attempt(remove)
    plain = {"matrix": None, "texture": None, "planes": [], "selection": None}
    look = {"opacity": 0.5, "ambient": 0.0, "specular": 0.0, "shading": "flat", "lighting": False,
            "representation": "surface", "edges": False, "vertices": False, "culling": "none", "line": 1.0,
            "back": None, "force": None, "tubes": False, "balls": False, "point": 1.0}
    for number in scene["props"]:
        for name, value in plain.items():
            attempt(lambda s: s["props"][number].update({name: value}))
        attempt(lambda s: s["props"][number]["colors"].update(kind="none"))
        attempt(lambda s: s["props"][number]["shape"].update(kind="plane", at=[0.0] * 3))
        for name, value in look.items():
            attempt(lambda s: s["props"][number]["look"].update({name: value}))
    for i in range(len(scene["renderers"])):
        attempt(lambda s: s["renderers"][i].update(lights=[], background2=None))
        attempt(lambda s: s["renderers"][i].update(viewport=[0.0, 0.0, 1.0, 1.0]))
        attempt(lambda s: s["renderers"][i].update(background=[0.0, 0.0, 0.0, 1.0]))
        attempt(lambda s: s["renderers"][i]["camera"].update(parallel=True))
        attempt(lambda s: s["renderers"][i]["camera"].update(focal=[0.0] * 3))
        attempt(lambda s: s["renderers"][i]["camera"].update(position=[0.0, 0.0, 5.0]))
        attempt(lambda s: s["renderers"][i]["camera"].update(range=[0.1, 20.0]))
    return scene
