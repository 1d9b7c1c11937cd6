# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page docs/reproducing-the-seeds.md: numbers of the documents next to those of seeds.py."""

import statistics

from . import lights, seeds
from .document import table

PAGE = "reproducing-the-seeds.md"

# Frames a second of multi-layer peeling and of depth peeling, GeForce 6800; triangles, layers.
MULTILAYER = {"grass": (384, 20, 2.11, 1.09), "tree": (384, 20, 2.23, 1.18),
              "courtyard": (15472, 31, 4.51, 2.62), "cathedral": (14780, 23, 4.72, 3.15)}
# Percent of erroneous pixels.
BUCKETS = {"bucket": (0.3, 0.9), "bucket-pairs": (0.05, 0.15), "bucket-adaptive": (0.01, 0.01)}
# Fragments processed by depth peeling, pixels changed by dual depth peeling, percent of the screen.
FRAGMENTS, CHANGED = (135, 96, 56), (39, 21, 5.7)

_HEAD = """# The documents' results, reproduced

What this project implements was published in five documents. Here are their experiments, repeated with scenes like theirs, next to
their numbers. Their scenes are not published: scanned meshes, isosurfaces and procedural buildings stand in for them. This page
was written by

```sh
{command}
```

on {machine}.

Geometry passes are exact numbers. Times are those of frames of {size} pixels with a turning camera, as ratios of medians of up to
{frames} frames in turns, by processor time where the renderer is software. `TransmittanceThreshold` is 0 where a table says so;
otherwise layers that cannot be seen may be skipped, for all of our methods alike.
"""

_DEFERRED = """## Deferred peeling with many lights

Rapetta, *OpenGL 4.6 deferred renderer with deferred depth peeling*, at 1920 x 1080 on a GeForce RTX 2070 Super. Time of a frame by peels
and lights, as multiples of the least of both; in brackets theirs, from frames a second. Here `deferred`, %d x %d pixels. In their usual
scene, here balls that overlap little:

%s
In their scene of nothing but overlapping translucent objects, here balls through each other:

%s
`deferred-abuffer` takes one geometry pass whatever the number of layers ([vtkOITDeferredPeelingPass](vtkOITDeferredPeelingPass.md)).
"""



def page(results, machine, command, settings, size):
    """The page, str. results: as from seeds.measure(). machine: str. settings: rounds.Settings."""
    return "\n".join([
        _HEAD.format(command=command, machine=machine, frames=settings.frames, size="%d x %d" % size),
        _multilayer(results["multilayer"]), buckets(results["buckets"]), _dual(results["dual"]),
        _weighted(results["weighted"]), _peels(results["peels"][0]), _deferred(results["lights"])])


def _number(value, digits=2):
    return "%.*f" % (digits, value)


def _multilayer(rows):
    head = ["scene", "triangles, layers: theirs", "here", "speed-up: theirs, K = 8"] + [
        "here, K = %d" % k for k in (4, 8, 16)] + ["with hazards, K = 4", "K = 8",
                                                   "passes: `peel`, K = 8, with hazards"]
    cells = []
    for row in rows:
        triangles, layers, ours, everitt = MULTILAYER[row["scene"]]
        methods = row["methods"]
        names = [seeds.MULTILAYER % k for k in (4, 8, 16)] + [seeds.HAZARDS % k for k in (4, 8)]
        passes = [methods[n]["passes"] if n in methods else None
                  for n in (seeds.PEEL, seeds.MULTILAYER % 8, seeds.HAZARDS % 8)]
        cells.append([row["scene"], "%s, %d" % (format(triangles, ","), layers),
                      "%s, %d" % (format(row["triangles"], ","), row["layers"]), _number(ours / everitt)] +
                     [_number(methods[n]["speed"]) if n in methods else "" for n in names] +
                     [", ".join("%d" % p if p is not None else "–" for p in passes)])
    best = max((row["methods"].get(seeds.MULTILAYER % 8, {"speed": 0.0})["speed"] for row in rows), default=0.0)
    text = """## Multi-layer depth peeling

Liu, Wei and Xu, *Multi-layer depth peeling via fragment sort*, 2006, on a GeForce 6800: grass and tree of quads, a courtyard and a
cathedral. How many times as fast as depth peeling, here `peel` to the end (`TransmittanceThreshold` 0):

%s

**Claim: "up to 8 times faster".** Their own table has 1.5 to 1.94: reads and writes of one pixel overtake each other, and the passes
are repeated until nothing changes. Here shaders read the framebuffer in order, so K layers take one pass, and with K = 8 the
speed-up is up to %s. It is less than K because a fragment that is sorted into K layers costs more than one whose depth is
compared, and because the later passes of `peel` are cheaper than the first: few pixels are left. With hazards (`Synchronization`
`texture_barrier`: nothing between the fragments of a draw, as on their card) passes are repeated until nothing changes, each with all
buffers, and on this renderer that takes longer than depth peeling.
"""
    return text % (table(head, cells), _number(best, 1))


def buckets(rows):
    """The part about bucket peeling, str. rows: list of dict."""
    head = ["mesh", "triangles, layers"] + ["`%s`, %%" % name for name in seeds.BUCKETS] + [
        "more than 8 steps", "passes", "`vtk-dual` / shot", "`peel` / shot", "`peel` / to the end",
        "adaptive / pairs"]
    cells = []
    for row in rows:
        methods = row["methods"]
        shots = [methods[seeds.SHOT % name] for name in seeds.BUCKETS]
        plain = [methods[name + ":MaximumNumberOfPeels=1"] for name in seeds.BUCKETS]
        cells.append(
            [row["scene"], "%s, %d" % (format(row["triangles"], ","), row["layers"])] +
            [_number(mine["over1"], 3) for mine in shots] +
            [", ".join(_number(mine["over8"], 3) for mine in shots),
             ", ".join("%d" % mine["passes"] for mine in plain),
             ", ".join(_number(mine["against_dual"], 1) for mine in plain),
             ", ".join(_number(mine["speed"], 1) for mine in plain),
             ", ".join(_number(methods[name]["speed"], 1) for name in seeds.BUCKETS),
             _number(methods["bucket-pairs"]["speed"] / methods["bucket-adaptive"]["speed"])])
    medians = [statistics.median(row["methods"][seeds.SHOT % name]["over1"] for row in rows)
               for name in seeds.BUCKETS]
    cells.append(["**median**", ""] + ["**%s**" % _number(value, 3) for value in medians] + [""] * 6)
    theirs = ["%g to %g" % BUCKETS[name] if BUCKETS[name][0] < BUCKETS[name][1] else "%g" % BUCKETS[name][0]
              for name in seeds.BUCKETS]
    cells.append(["theirs", ""] + theirs + ["", "1, 1, 2", "", "up to N for N layers", "", ""])
    held = [value <= BUCKETS[name][1] for name, value in zip(seeds.BUCKETS, medians)]
    return """## Bucket depth peeling

Liu, Huang, Liu and Wu, *Bucket depth peeling*, 2009, on a GeForce 8800 GTX: one scanned mesh seen through itself, in a single shot. Share
of erroneous pixels, EPR; they give no threshold, here a pixel is erroneous that is more than one step of 255 off, of the pixels that
the mesh covers, of opacity 0.3 (`DepthRange` exact, which costs one geometry pass more):

%s

"Shot" is the single shot without exact ranges, of the three modes; "to the end" takes further peels until the picture is exact.
`bucket` keeps 24 buckets rather than 32: the other channels are sums over the pixel.

**EPR.** %s.

What decides it: fragments that share a bucket, where surfaces meet at silhouettes; more buckets alone
do not cure that. Three things do: sums tell which buckets the lost fragments were in, and their colour; the place in a bucket is
in the topmost bits of a word, so that its order is known; and adaptive buckets start from exact depths, two for each of 12, so only
the fourth fragment of a bucket can be lost. Logarithmic depth was not needed: eye depth, divided evenly, is. For such buckets the meshes
here are harder than theirs may be: with 32 plain buckets of exact colours the median is 2.6 %%.

**Speed: "up to N times for depth complexity N".** The column `peel` / shot. It is less, as few pixels have N layers, and a pass that blends into
eight float32 buffers costs a software renderer several of those that blend into one, most of all with small triangles. "Performance
degrades for small models": so it does here.
""" % (table(head, cells), "; ".join(
        "`%s`: %s %%, theirs %s: %s" % (name, _number(value, 3), their, "holds" if good else "does not hold")
        for name, value, their, good in zip(seeds.BUCKETS, medians, theirs, held)))


def _dual(rows):
    names = [seeds.PEEL, seeds.DUAL, "dual:TransmittanceThreshold=0"]
    cells = [["%d" % row["layers"], "%d, %d" % (row["layers"], row["layers"] // 2 + 1)] +
             ["%d" % row["passes"][name] for name in names] + [_number(row["speed"])] for row in rows]
    return """## Dual depth peeling: geometry passes

Bavoil and Myers, *Order independent transparency with dual depth peeling*, 2008: N passes become N/2 + 1. Here for N planes, to
the end:

%s

**Claim: N/2 + 1, twice as fast where geometry decides.** With float colours `dual` keeps one layer from each side in a pass, and
needs no first pass for depths alone where shaders read the framebuffer; with half floats it keeps three from each side. `peel` has a
first pass that finds depths, as our count has it: N + 1.
""" % table(["layers", "theirs: peeling, dual", "`peel`", "`dual`, float colours", "`dual`", "`peel` / `dual`, float, time"],
            cells)


def _weighted(rows):
    cells = []
    for row in rows:
        mine = [row["methods"][name] for name in ("weighted-average", "weighted-sum")]
        cells.append([", ".join("%g" % o for o in row["opacities"])] +
                     [_number(m[key], 1) for m in mine for key in ("rmse", "mean")])
    return """## Weighted average and weighted sum

The same document: plausible pictures of the average for low and high opacity, a sum that becomes too dark or too bright above 20 to
30 %%. Error in steps of 255 of a mesh seen through itself (the last row: three, of different opacity), RMSE and the mean
difference, which is below 0 where a picture is too dark:

%s

**Claims.** That the sum is too dark above 20 %% holds, and already below. That the average suits low opacity holds. For high opacity
it does not: its error grows with opacity, as the nearest layer decides then, and the average does not know which that is.
""" % table(["opacity", "average: RMSE", "mean", "sum: RMSE", "mean"], cells)


def _peels(row):
    cells = [["fragments left for depth peeling, % of the screen", ", ".join("%g" % x for x in FRAGMENTS),
              ", ".join(_number(x, 1) for x in row["fragments"])],
             ["pixels changed by dual depth peeling, % of the screen", ", ".join("%g" % x for x in CHANGED),
              ", ".join(_number(x, 1) for x in row["changed"])],
             ["geometry passes of depth peeling, dual depth peeling", "17, 9 + 1",
              ", ".join("%d" % row["passes"][name] for name in (seeds.PEEL, seeds.DUAL))],
             ["frames a second, dual against single", "\"nearly doubled\"",
              "%s (VTK's own passes: %s)" % (_number(row["speed"]), _number(row["vtk_speed"]))]]
    return """## VTK's dual depth peeling

*VTK technical highlight: dual depth peeling*, Kitware, 2016: three dragons, up to 17 layers. Here three meshes, up to %d layers:

%s

Their numbers agree with each other: what the first peel takes away, 135 - 96 = 39 %%, is the share of the screen that the dragons cover,
which the first dual peel changes. The same holds of ours.
""" % (row["layers"], table(["peel 1, 2, 3", "theirs", "here"], cells))


def _deferred(rows):
    tables = [lights.markdown(row["here"], [their[:len(row["lights"])] for their in lights.paper(row["overlap"])],
                              row["passes"], row["lights"]) for row in rows]
    return _DEFERRED % (*seeds.LIGHTS_SIZE, tables[0], tables[-1])
