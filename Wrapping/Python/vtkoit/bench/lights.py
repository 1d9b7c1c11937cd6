# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What lights cost: methods side by side, and the table of passes by lights that deferred depth peeling was presented with.

Times are processor time of this process, threads of a software renderer included, so a loaded machine changes them little.
With a GPU they say nothing.
"""

import colorsys
import math
import time

from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

from ..lookup import render_pass
from ..windows import make_window
from . import contenders

PASSES = (4, 8, 12, 16)
LIGHTS = (16, 32, 64, 128)

# Frames a second by passes and lights, on an RTX 2070 SUPER at 1920 x 1080: little overlap, and much.
PAPER = {"little": ((410, 287, 180, 103), (310, 229, 150, 88), (256, 196, 135, 82), (217, 173, 123, 78)),
         "much": ((205, 145, 91, 54), (146, 107, 70, 41), (119, 91, 62, 38), (102, 80, 56, 35))}


def _add(renderer, source, color, opacity):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetOpacity(opacity)
    renderer.AddActor(actor)


def add_lights(renderer, number, positional=True):
    """Coloured lights on a spiral around the origin, as bright together however many they are."""
    for i in range(number):
        light = vtkLight()
        light.SetPosition(4 * math.cos(2.4 * i), 3 + i % 3, 4 * math.sin(2.4 * i))
        light.SetPositional(positional)
        light.SetConeAngle(180.0)
        light.SetAttenuationValues(1.0, 0.05, 0.01)
        light.SetColor(*colorsys.hsv_to_rgb(0.17 * i % 1.0, 0.5, 1.0))
        light.SetIntensity(2.0 / number)
        renderer.AddLight(light)


def make_scene(number, positional=True, overlap="little"):
    """A vtkRenderer: two rows of translucent balls of three shells each on an opaque floor, in front of each other or
    (overlap "much") through each other, under that many lights."""
    renderer = vtkRenderer()
    step = 0.9 if overlap == "little" else 0.3
    for row in range(2):
        for column in range(5):
            for radius in (0.45, 0.35, 0.25):
                ball = vtkSphereSource()
                ball.SetRadius(radius)
                ball.SetCenter(step * (column - 2), 0.5, step * row)
                ball.SetThetaResolution(40)
                ball.SetPhiResolution(30)
                _add(renderer, ball, colorsys.hsv_to_rgb(0.1 * column, 0.4, 0.9), 0.4)
    floor = vtkPlaneSource()
    floor.SetOrigin(-3.0, 0.0, -2.0)
    floor.SetPoint1(3.0, 0.0, -2.0)
    floor.SetPoint2(-3.0, 0.0, 2.0)
    _add(renderer, floor, (0.8, 0.8, 0.8), 1.0)
    add_lights(renderer, number, positional)
    renderer.GetActiveCamera().SetPosition(0.0, 2.0, 4.0)
    renderer.GetActiveCamera().SetFocalPoint(0.0, 0.3, 0.0)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Zoom(1.8)
    return renderer


def measure(method, renderer, size=(480, 270), frames=3):
    """(first, steady): processor seconds of the first frame, which compiles, and the least of later ones."""
    steps = render_pass("vtkRenderStepsPass")()
    steps.SetTranslucentPass(contenders.make_pass(method)[0])
    renderer.SetPass(steps)
    window = make_window(renderer, size)
    times = []
    for _ in range(1 + frames):
        start = time.process_time()
        window.Render()
        window.WaitForCompletion()
        times.append(time.process_time() - start)
        renderer.GetActiveCamera().Azimuth(3.0)
    renderer.SetPass(None)
    window.RemoveRenderer(renderer)
    window.Finalize()
    return times[0], min(times[1:])


def passes_by_lights(overlap="little", passes=PASSES, lights=LIGHTS, **options):
    """Steady times of `deferred` with that many peels, as multiples of the least passes and lights: tuple of rows, one for
    each number of passes. The same of the paper: paper(overlap)."""
    rows = [[measure("deferred:MaximumNumberOfPeels=%d,TransmittanceThreshold=0" % peels,
                     make_scene(number, overlap=overlap), **options)[1] for number in lights] for peels in passes]
    return tuple(tuple(value / rows[0][0] for value in row) for row in rows)


def paper(overlap="little"):
    """What passes_by_lights() is there."""
    rates = PAPER[overlap]
    return tuple(tuple(rates[0][0] / rate for rate in row) for row in rates)


def methods_by_lights(methods, lights=LIGHTS, positional=True, **options):
    """(first, steady) of each method as multiples of the first method's steady time with the same lights: dict of
    (method, number) to tuple of two floats."""
    result = {}
    for number in lights:
        base = None
        for method in methods:
            first, steady = measure(method, make_scene(number, positional), **options)
            base = base or steady
            result[method, number] = first / base, steady / base
    return result


def markdown(rows, theirs, passes=PASSES, lights=LIGHTS):
    """A table of passes_by_lights() next to paper(), str."""
    lines = ["| passes | " + " | ".join("%d lights" % number for number in lights) + " |",
             "|---" * (len(lights) + 1) + "|"]
    for peels, row, their in zip(passes, rows, theirs):
        lines.append("| %d | " % peels + " | ".join("%.2f (%.2f)" % pair for pair in zip(row, their)) + " |")
    return "\n".join(lines) + "\n"
