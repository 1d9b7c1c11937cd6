# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What each skip saves: a scene that has it to save, with the skip and without it, in turns."""

import collections

import numpy

from ..errors import Error
from . import catalogue, families, rounds, sciviz
from .document import table
from .measure import REFERENCE
from .scene import Part, Scene, facing, quads, rainbow, sphere
from .stage import Stage

PAGE = "skips.md"

Skip = collections.namedtuple("Skip", "name scene on off told turn")
Skip.__doc__ = """A row: name (str, the switch), scene (str or Scene), on and off (str, contenders; {passes} in off
stands for the geometry passes of on), told (str, what GetSkipSummary() says of the skip; empty where the pass
has no summary, then geometry passes tell, None where not even these do) and turn (float, degrees of the camera
a frame)."""

INVISIBLE = "props left out: invisible"
ORDERED = "props blended: their order is known"
REUSED = "whole frame reused"
HIDDEN = "fragments behind those of opacity 1 left out"


def skips(is_quick=False):
    """All rows, list of Skip; is_quick: one of each switch."""
    def sorting(scene):
        return Skip("SkipSorting", scene, "auto", "auto:SkipSorting=0", ORDERED, 0.5)

    def reuse(scene):
        return Skip("ReuseFrames", scene, "auto", "auto:ReuseFrames=0", REUSED, 0.0)

    def threshold(method):
        return Skip("TransmittanceThreshold", "opacity-0.5", method,
                    method + ":TransmittanceThreshold=0", "", 0.5)

    rows = [
        Skip("SkipInvisibleProps", _faded(), "auto", "auto:SkipInvisibleProps=0", INVISIBLE, 0.5),
        sorting("deep"), sorting("disjoint"), sorting("one-sphere"), sorting("crossings"),
        reuse("spheres"), reuse("small-props"),
        threshold("dual"), threshold("multilayer"),
        Skip("TransmittanceThreshold", "molecule", "auto", "auto:TransmittanceThreshold=0", None, 0.5),
        Skip("SkipHiddenFragments", _leaves(), "auto", "auto:SkipHiddenFragments=0", HIDDEN, 0.5),
        Skip("UseOcclusionQuery", "one-sphere", "dual",
             "dual:UseOcclusionQuery=0,MaximumNumberOfPeels=8", "", 0.5),
        Skip("UseOcclusionQuery: props", _corner(), "dual",
             "dual:UseOcclusionQuery=0,MaximumNumberOfPeels={passes}", None, 0.5)]
    names = [row.name for row in rows]
    return [row for i, row in enumerate(rows) if not is_quick or row.name not in names[:i]]


def _faded():
    def make():
        random = numpy.random.default_rng(5)
        balls = [sphere(p, 0.09, 16) for p in random.uniform(-1, 1, (400, 3))]
        return [Part(ball, rainbow(i / 400), 0.3 * (i % 2)) for i, ball in enumerate(balls)]

    return Scene("faded", "400 small spheres, every second one of opacity 0", make,
                 families.look_at_spheres)


def _leaves():
    def place(renderer):
        families.look_at_spheres(renderer)
        renderer.GetActiveCamera().Zoom(2.0)

    return Scene("leaves", "20000 leaves as textured quads, solid but for their edges",
                 lambda: sciviz.foliage(20000, 1.0), place)


def _corner():
    def make():
        # A deep stack in a corner, and spheres of many triangles that are peeled at once.
        stack = [[(0.5, 0.5, z), (0.7, 0.5, z), (0.7, 0.7, z), (0.5, 0.7, z)]
                 for z in (0.01 * i for i in range(48))]
        parts = [Part(quads(stack), rainbow(0.0), 0.02, "unlit")]
        for i in range(16):
            center = (-0.8 + 0.4 * (i % 4), -0.8 + 0.4 * (i // 4), 0.0)
            if center[:2] != (0.4, 0.4):
                parts.append(Part(sphere(center, 0.15, 96), rainbow(i / 16), 0.4))
        return parts

    return Scene("corner", "48 layers in a corner, beside 15 spheres of 18 k triangles", make,
                 lambda renderer: facing(renderer, 1.0))


def measure(rows, size, settings, progress):
    """The results of a list of Skip, list of dict. size: (width, height). settings: rounds.Settings, whose
    turn is that of the row. Raises Error when a frame did not skip what its row says, or did without."""
    return [_measure(row, size, settings._replace(turn=row.turn), progress) for row in rows]


def _measure(row, size, settings, progress):
    scene = catalogue.choose([row.scene])[0] if isinstance(row.scene, str) else row.scene
    stage = Stage(scene, scene.size or size)
    progress.show("%s: making the scene" % scene.name)
    off = row.off
    if "{passes}" in off:
        alone = rounds.take(stage, [row.on], settings._replace(frames=1), progress)
        off = off.format(passes=alone[row.on].statistics.passes)
    taken = rounds.take(stage, [REFERENCE, row.on, off], settings, progress)
    check(row, taken[row.on], taken[off])
    result = {"skip": row.name, "scene": scene.name, "title": scene.title, "on": row.on, "off": off,
              "summary": taken[row.on].summary, "frames": len(taken[row.on].seconds)}
    for key, name in (("on", row.on), ("off", off)):
        result["ratio_" + key] = rounds.ratio(taken[name].seconds, taken[REFERENCE].seconds)[0]
        result["passes_" + key] = taken[name].statistics.passes
        result["bytes_" + key] = taken[name].statistics.bytes
    for key in ("seconds", "cpu"):
        quotients = rounds.ratio(getattr(taken[row.on], key), getattr(taken[off], key))
        result["saved_" + key] = [100.0 * (1.0 - q) for q in quotients]
    return result


def check(row, on, off):
    """Raises Error unless the frames say themselves what was skipped. row: Skip; on, off: Taken."""
    if row.told:
        if row.told not in on.summary:
            raise Error("%s does not skip: GetSkipSummary() is \"%s\", without \"%s\""
                        % (row.on, on.summary, row.told))
        if row.told in off.summary:
            raise Error("%s skips what is switched off: %s" % (row.off, off.summary))
    elif row.told is not None and on.statistics.passes >= off.statistics.passes:
        raise Error("%s does not skip: %d geometry passes, and %d without"
                    % (row.on, on.statistics.passes, off.statistics.passes))


_HEAD = """# What each skip saves

Each skip that can be switched, in a scene that has it to save, with the skip and without it. A scene without it saves nothing. This
page was written by

```sh
{command}
```

on {machine}.

The two and unsorted blending take turns in one process, a frame each, after a warm-up; up to {frames} frames of {size} pixels, of a
camera that turns, but for `ReuseFrames`. Times are medians, as multiples of unsorted blending; the time saved is the median of the
rounds, with the quartiles. Processor time is that of all cores, which other work on the machine disturbs less. A row
is refused when the frame with the skip does not say that it skipped (`GetSkipSummary()`, or geometry passes for peeling), or
the one without it does.
"""


def page(results, where, command, settings, size):
    """The page in Markdown, str. results: list of dict of measure(). where: str, the machine."""
    rows = []
    for r in results:
        wall, cpu = r["saved_seconds"], r["saved_cpu"]
        rows.append([
            "`%s`" % r["skip"], "`%s`" % r["on"].partition(":")[0], r["scene"],
            _short(r["ratio_on"]), _short(r["ratio_off"]),
            "%.0f %% (%.0f to %.0f)" % (wall[0], wall[2], wall[1]), "%.0f %%" % cpu[0],
            "%d, %d" % (r["passes_on"], r["passes_off"]),
            "%.1f, %.1f" % (r["bytes_on"] / 2 ** 20, r["bytes_off"] / 2 ** 20)])
    head = ["skip", "method", "scene", "with", "without", "time saved", "processor time saved",
            "passes with, without", "MiB with, without"]
    told = ["- %s (%s): without it `%s`%s" % (
        r["scene"], r["title"], r["off"], "; \"%s\"" % r["summary"] if r["summary"] else "")
        for r in results]
    return "\n\n".join([
        _HEAD.format(command=command, machine=where, frames=settings.frames,
                     size="%d x %d" % size).strip("\n"),
        table(head, rows),
        "The scenes, what they were compared with, and what the frame with the skip said of itself:",
        "\n".join(told), _NOTES.strip("\n")]) + "\n"


_NOTES = """Nothing tells of the threshold in the long lists of the A-buffer (molecule) but the time.

`UseOcclusionQuery: props` is what queries of single props save, which are not drawn any more once they have no layers left: the
other frame has as many peels. `dual` has 8 peels without queries in one-sphere, what a scene of 32 layers would need.

Not switchable, and in all numbers: no translucent prop in the view costs nothing; stages run inside the props' rectangle; fragments
behind opaque geometry are rejected by the depth test; tiles of the A-buffer take the sorting network that they need.
"""


def _short(value):
    return "%.3f" % value if value < 0.1 else "%.2f" % value if value < 10.0 else "%.1f" % value
