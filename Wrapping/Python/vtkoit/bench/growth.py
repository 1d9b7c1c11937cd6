# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""How the cost of a frame grows with layers, triangles, pixels and props: each step of a family of scenes
against the step before it."""

import os

import numpy

from . import catalogue, families, plots, rounds
from .document import PICTURES, table
from .measure import REFERENCE
from .stage import Stage

PAGE = "growth.md"
METHODS = ("auto", "auto:SkipSorting=0")
FAMILIES = ("layers", "triangles", "pixels", "crowd")
QUICK_VALUES = {"layers": 4, "triangles": 1e4, "pixels": 512, "crowd": 100}  # the largest ones


def measure(size, settings, is_quick, progress):
    """The results of all scenes, list of dict. size: (width, height). settings: rounds.Settings."""
    results = []
    for scene in catalogue.choose(FAMILIES):
        if is_quick and scene.value > QUICK_VALUES[scene.family]:
            continue
        progress.show("%s: making the scene" % scene.name)
        stage = Stage(scene, scene.size or size)
        taken = rounds.take(stage, [REFERENCE, *METHODS], settings, progress)
        for method, mine in taken.items():
            told = mine.statistics
            results.append({
                **stage.facts(), "method": method, "ms": float(1000.0 * numpy.median(mine.seconds)),
                "cpu_ms": float(1000.0 * numpy.median(mine.cpu)),
                "passes": None if told is None else told.passes,
                "fragments": None if told is None else told.fragments,
                "bytes": None if told is None else told.bytes})
    return results


def amount(result):
    """What grows in a result's family, float: of pixels their number, not the side."""
    return result["value"] ** 2 if result["family"] == "pixels" else result["value"]


def steps(results, family, method):
    """(value, processor time in ms, time per growth) of a family in ascending order: list of (float, float,
    float or None). The last one is the factor by which the time grows, divided by the factor by which the
    value does: 1 for linear, None for the first."""
    mine = sorted((r for r in results if r["family"] == family and r["method"] == method),
                  key=lambda r: r["value"])
    result = []
    for before, now in zip([None, *mine], mine):
        factor = None if before is None else \
            now["cpu_ms"] / before["cpu_ms"] / (amount(now) / amount(before))
        result.append((now["value"], now["cpu_ms"], factor))
    return result


_HEAD = """# How the cost grows

With layers, triangles, pixels and props, one at a time. This page was written by

```sh
{command}
```

on {machine}.

Processor time of all cores in ms of a frame, medians of up to {frames} frames, of unsorted blending (`blend`), the automatic pass, and the
automatic pass that sorts all. {size} pixels where pixels are not what grows. In parentheses the factor by which the time grew since
the line before, divided by the factor by which the number did: 1 is linear growth, and less is slower growth.
"""

_TITLES = {"layers": "Layers", "triangles": "Triangles", "pixels": "Pixels of a side, squared",
           "crowd": "Props, each of 96 triangles"}


def page(results, where, command, settings, size):
    """The page in Markdown, str. results: list of dict of measure(). where: str, the machine."""
    parts = [_HEAD.format(command=command, machine=where, frames=settings.frames,
                          size="%d x %d" % size)]
    for family in FAMILIES:
        methods = (REFERENCE, *METHODS)
        columns = [steps(results, family, m) for m in methods]
        rows = [[families.short(line[0][0])] + [
            "%.1f" % ms + ("" if factor is None else " (%.2f)" % factor) for _, ms, factor in line]
            for line in zip(*columns)]
        parts += ["## " + _TITLES[family], table([family] + ["`%s`" % m for m in methods], rows),
                  "![Cost growing with %s](%s/%s)" % (family, PICTURES, picture(family))]
    return "\n\n".join(part.strip("\n") for part in parts) + "\n"


def picture(family):
    """The name of a family's picture, str."""
    return "bench-growth-%s.png" % family


def draw(folder, results):
    """Writes the pictures of the page, of processor time, into the folder of pictures in a folder, str."""
    results = [{**result, "ms": result["cpu_ms"]} for result in results]
    os.makedirs(os.path.join(folder, PICTURES), exist_ok=True)
    for family in FAMILIES:
        plots.cost(os.path.join(folder, PICTURES, picture(family)), results, family, dpi=70)
