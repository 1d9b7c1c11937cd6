# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command showcase: procedural scenes, drawn by VTK's methods and ours, against the truth."""

import os
import statistics
import time

from . import picture
from .bench import accuracy, truth
from .bench.stage import SurfaceStage
from .errors import Error, capture
from .hook import install, uninstall
from .showcase_scenes import SCENES
from .values import parse_size
from .windows import headless, make_window

FRAMES = 5  # timed frames of each method; fewer when they take long
LONGEST = 3.0  # seconds of timed frames of a method


def _default(renderer):
    renderer.UseDepthPeelingOff()


def _peeling(renderer):
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(1000)
    renderer.SetOcclusionRatio(0.0)


def _vtkoit(renderer):
    # Each frame is to be drawn: the camera does not move, and a frame shown again is no measure.
    return install(renderer, ReuseFrames=False)


# (name in the file, title, what switches it on)
METHODS = [
    ("vtk-default", "VTK's default", _default),
    ("vtk-peeling", "VTK's dual depth peeling", _peeling),
    ("vtkoit", "vtkOIT auto", _vtkoit),
]


def run(folder, size, progress):
    """Draws all scenes into folder (str); size: str such as 500x500. Raises Error."""
    size = parse_size(size)
    try:
        headless()
        os.makedirs(folder, exist_ok=True)
    except RuntimeError as error:
        raise Error(str(error)) from None
    except OSError as error:
        raise Error("%s: cannot be made: %s" % (folder, error.strerror)) from None
    for number, (name, make) in enumerate(SCENES):
        if number:
            print()
        _show(name, make, folder, size, progress)


def _show(name, make, folder, size, progress):
    progress.begin("%s: truth" % name)
    progress.show("%s: truth" % name)
    right = truth.find(SurfaceStage(name, name, make, [], size), cross_check=False)
    renderer = make()
    results = []
    for key, title, switch_on in METHODS:
        progress.show("%s: %s" % (name, title))
        path = os.path.join(folder, "%s-%s.png" % (name, key))
        with capture() as captured:
            switch_on(renderer)
            pixels, seconds = _time(renderer, size)
            uninstall(renderer)
        if captured.errors(1):
            raise Error("%s by %s: %s" % (name, title, captured.errors(1)))
        picture.save(pixels, path)
        error = accuracy.measure(pixels[..., :3], right.color, right.covered)
        results.append((title, path, seconds, error))
    progress.clear()
    _print(name, renderer, size, right, results)


def _time(renderer, size):
    """(pixels, seconds of a frame): the median of some frames after the first, which compiles."""
    window = make_window(renderer, size)
    window.Render()
    times = []
    while len(times) < FRAMES and (not times or sum(times) < LONGEST):
        start = time.perf_counter()
        window.Render()
        pixels = picture.grab(window)
        times.append(time.perf_counter() - start)
    window.RemoveRenderer(renderer)
    window.Finalize()
    return pixels, statistics.median(times)


def _print(name, renderer, size, right, results):
    triangles = 0
    actors = renderer.GetActors()
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        triangles += actors.GetNextActor().GetMapper().GetInput().GetNumberOfPolys()
    print("%s: %dx%d, %s triangles, %s fragments, up to %d layers; error of the colours in 1/255" % (
        name, *size, format(triangles, ","), format(right.fragments, ","), right.layers))
    width = max(len(path) for _, path, _, _ in results)
    print("  %-25s %-*s %9s %7s %10s %11s" % (
        "method", width, "picture", "ms/frame", "ratio", "error max", "error RMS"))
    for title, path, seconds, error in results:
        print("  %-25s %-*s %9.0f %7.2f %10.1f %11.3f" % (
            title, width, path, 1000.0 * seconds, seconds / results[0][2], error.max, error.rmse))
