# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes whose picture is known, drawn by every method: prints JSON, a line for the context and one
for each method and scene.

    KnownScenes.py [METHOD...]

For TestMissingExtensions.py, which runs it in contexts that lack something.
"""

import json
import sys

import Support
import numpy
import vtkoit
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkoit.errors import capture
from vtkoit.picture import grab
from vtkoit.windows import context_of, make_window

SIZE = (24, 20)
BACKGROUND = (0.2, 0.4, 0.6)
ALPHA = 0.4
FRAMES = 4  # an automatic pass keeps a layer in the second and reuses it from the third on

# z, colour, opacity.
QUADS = [(0.75, (0.9, 0.2, 0.1), 0.4), (0.0, (0.2, 0.8, 0.3), 0.6), (-0.75, (0.3, 0.3, 0.9), 0.5)]
# z at the left and at the right border, colour, opacity: they cross, between the quads.
RAMPS = [((0.5, -0.5), (0.8, 0.8, 0.1), 0.5), ((-0.5, 0.5), (0.1, 0.7, 0.9), 0.3)]
OPAQUE = (-0.6, (0.5, 0.1, 0.4))  # behind all but one, in the upper half

# Source, factor and result of a layer are each rounded to a step of 255 where a window blends.
TOLERANCE = 1.5 / 255
# Halves of the sums of several layers, see ReferenceCompositor::RoundingBoundOfAnyStack().
HALVES = 5 * 2.0 ** -11


def add_ramp(renderer, left, right, color, opacity, bottom=-1.0):
    plane = vtkPlaneSource()
    plane.SetOrigin(-1.2, bottom, left)
    plane.SetPoint1(1.2, bottom, right)
    plane.SetPoint2(-1.2, 1, left)
    return Support.add_actor(renderer, plane, color, opacity, lighting=False)


def make_scene(crosses):
    """A renderer and its picture, height x width x 4, premultiplied, top row first."""
    renderer = Support.quad_renderer(BACKGROUND, ALPHA)
    renderer.GetActiveCamera().SetParallelScale(1.0)
    layers = [((z, z), color, opacity) for z, color, opacity in QUADS] + (RAMPS if crosses else [])
    for (left, right), color, opacity in layers:
        add_ramp(renderer, left, right, color, opacity)
    add_ramp(renderer, OPAQUE[0], OPAQUE[0], OPAQUE[1], 1.0, bottom=0.0)
    width, height = SIZE
    picture = numpy.zeros((height, width, 4))
    for y in range(height):
        for x in range(width):
            side = (x + 0.5) / width
            here = [(left + (right - left) * side, color, opacity)
                    for (left, right), color, opacity in layers]
            behind = (*BACKGROUND, ALPHA)
            if y < height // 2:
                here = [layer for layer in here if layer[0] > OPAQUE[0]]
                behind = (*OPAQUE[1], 1.0)
            here.sort(key=lambda layer: -layer[0])
            picture[y, x] = Support.compose([color for _, color, _ in here],
                                            [opacity for _, _, opacity in here], behind)
    return renderer, picture


def find_fault(instance, pixels, truth):
    """None, or what is wrong with a frame: that it says to be right, and is not."""
    difference = abs(pixels / 255.0 - truth).max()
    if difference <= TOLERANCE + HALVES:
        return None
    if instance.GetExact():
        return "off by %.0f steps, and exact" % (255 * difference)
    if difference > TOLERANCE + HALVES + instance.GetErrorBound():
        return "off by %.0f steps, beyond its bound of %g" % (255 * difference, instance.GetErrorBound())
    return None


def draw(method, crosses, samples):
    renderer, truth = make_scene(crosses)
    instance = vtkoit.install(renderer, method, TransmittanceThreshold=0.0)
    window = make_window(renderer, SIZE, samples)
    faults = []
    lines = []
    exact = True
    for frame in range(FRAMES):
        with capture() as captured:
            window.Render()
            pixels = grab(window)
        lines += captured.lines()
        exact = exact and instance.GetExact()
        fault = find_fault(instance, pixels, truth)
        if fault:
            faults.append("frame %d is %s" % (frame, fault))
    if not exact and not method.startswith("weighted") and not lines:
        faults.append("not exact, and does not say why")
    if len(lines) > 1:
        faults.append("more than one line: " + "; ".join(lines))
    window.Finalize()
    return {"method": method,
            "scene": "%s, %d samples" % ("crossing" if crosses else "ordered", samples),
            "fault": "; ".join(faults) or None, "exact": exact,
            "by": instance.GetAlgorithmName(), "lines": lines}


def main(names):
    vtkoit.headless()
    window = make_window(None, (8, 8))
    window.Render()
    context = context_of(window)
    print(json.dumps({"version": context.version, "extensions": sorted(context.extensions)}), flush=True)
    for method in names or vtkoit.methods():
        for crosses, samples in ((True, 0), (False, 0), (True, 4)):
            print(json.dumps(draw(method, crosses, samples)), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
