# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes that two builds draw: the procedural ones of `vtkoit bench`, from the source tree that this file is in
and not from the build, so that both get the same; and those of the baselines (Testing/Cxx/TestScenes.cxx)."""

import collections
import fnmatch
import importlib
import math
import pathlib
import sys
import types

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPlane, vtkPolyData
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkTexture

BENCH = pathlib.Path(__file__).resolve().parents[2] / "Wrapping" / "Python" / "vtkoit" / "bench"
SOURCES = ("scene.py", "families.py", "sciviz.py")

# Left out unless asked for: millions of triangles, thousands of props and hundreds of layers take minutes with a
# method that draws them once a layer; the sizes in pixels are those of the window here; and what resembles another one.
REST = ("isosurfaces", "small-props", "pixels-*", "triangles-1*M", "triangles-4M", "triangles-1k", "props-800", "props-2k", "props-1",
        "crowd-400", "crowd-800", "crowd-1600", "crowd-3200", "layers-2", "layers-4", "layers-16", "layers-64",
        "layers-128", "layers-256", "coverage-0.01", "coverage-0.5", "opacity-0.1", "opacity-0.5", "coincident-0",
        "coincident-0.5", "depth-range-10", "depth-range-100k")

# Drawn in windows of a fraction of the width, for the same reason.
SMALLER = {"deep": 4, "layers-32": 2, "scan": 2}

Drawn = collections.namedtuple("Drawn", "name make")
Drawn.__doc__ = """A scene: name (str), and make: a function that returns a function without arguments, which makes
new renderers, list of vtkRenderer, each time; what they share is made once."""


def bench_scenes():
    """The procedural Scenes of vtkoit.bench, without the rest of these packages."""
    for name, path in (("source", BENCH.parent), ("source.bench", BENCH)):
        package = types.ModuleType(name)
        package.__path__ = [str(path)]
        sys.modules.setdefault(name, package)
    scene, families, sciviz = (
        importlib.import_module("source.bench." + source[:-3]) for source in SOURCES)

    def make(item):
        parts = item.make()
        return lambda: [scene.fill(item, parts)]

    every = sciviz.scenes() + families.scenes()
    iso = next(item for item in every if item.name == "isosurfaces")
    # A fortieth of the triangles.
    every.append(iso._replace(name="isosurfaces-coarse", make=lambda: sciviz.isosurfaces(10, 10)))
    return [Drawn(item.name, lambda item=item: make(item)) for item in every]


def choose(patterns=None):
    """Scenes by names or patterns (list of str), list of Drawn; None for all but the REST. Raises ValueError."""
    every = bench_scenes() + [Drawn("baseline-" + make.__name__.strip("_"), lambda make=make: make)
                              for make in BASELINES]
    if not patterns:
        return [scene for scene in every
                if not any(fnmatch.fnmatchcase(scene.name, pattern) for pattern in REST)]
    result = []
    for pattern in patterns:
        found = [scene for scene in every if fnmatch.fnmatchcase(scene.name, pattern)]
        if not found:
            raise ValueError("no scene is called %s; there are: %s" % (
                pattern, " ".join(scene.name for scene in every)))
        result += [scene for scene in found if scene not in result]
    return result


def _renderer(x0=0.0, x1=1.0):
    renderer = vtkRenderer()
    renderer.SetBackground(0.95, 0.95, 0.9)
    renderer.SetBackgroundAlpha(1.0)
    renderer.SetViewport(x0, 0.0, x1, 1.0)
    return renderer


def _add(renderer, source, hue, opacity):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    _color(actor, hue, opacity)
    renderer.AddActor(actor)
    return actor


def _color(actor, hue, opacity):
    actor.GetProperty().SetColor(*[0.5 + 0.4 * math.cos(2.0 * math.pi * (hue - i / 3.0)) for i in range(3)])
    actor.GetProperty().SetOpacity(opacity)


def _add_spheres(renderer, count, opacity):
    source = vtkSphereSource()
    source.SetThetaResolution(48)
    source.SetPhiResolution(32)
    for i in range(count):
        actor = _add(renderer, source, i / count, opacity)
        actor.SetPosition(0.4 * math.cos(2.4 * i), 0.4 * math.sin(2.4 * i), 0.25 * math.sin(1.7 * i) + 0.01 * i)
    return actor


def _framed(renderer, azimuth, elevation):
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(azimuth)
    renderer.GetActiveCamera().Elevation(elevation)
    renderer.GetActiveCamera().Zoom(1.3)
    renderer.ResetCameraClippingRange()
    return renderer


def _isosurfaces():
    renderer = _renderer()
    wavelet = vtkRTAnalyticSource()
    wavelet.SetWholeExtent(-20, 20, -20, 20, -20, 20)
    for i in range(6):
        contour = vtkContourFilter()
        contour.SetInputConnection(wavelet.GetOutputPort())
        contour.SetValue(0, 90.0 + 25.0 * i)
        _add(renderer, contour, i / 6.0, 0.3)
    return [_framed(renderer, 30.0, 25.0)]


def _spheres():
    renderer = _renderer()
    _add_spheres(renderer, 10, 0.35).GetProperty().SetOpacity(1.0)
    return [_framed(renderer, 20.0, 15.0)]


def _impostors():
    from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

    renderer = _renderer()
    for part in range(2):
        points, vertices = vtkPoints(), vtkCellArray()
        for i in range(9):
            vertices.InsertNextCell(1)
            vertices.InsertCellPoint(points.InsertNextPoint(
                i % 3 - 1.0 + 0.5 * part, i // 3 - 1.0, 0.3 * math.sin(5.0 * i)))
        cloud = vtkPolyData()
        cloud.SetPoints(points)
        cloud.SetVerts(vertices)
        mapper = vtkOpenGLSphereMapper()
        mapper.SetInputData(cloud)
        mapper.SetRadius(0.35 if part else 0.6)
        actor = vtkActor()
        actor.SetMapper(mapper)
        _color(actor, 0.4 * part + 0.1, 1.0 if part else 0.4)
        renderer.AddActor(actor)
    plane = vtkPlaneSource()
    plane.SetOrigin(-1.8, -1.8, 0.1)
    plane.SetPoint1(1.8, -1.8, 0.1)
    plane.SetPoint2(-1.8, 1.8, 0.1)
    _add(renderer, plane, 0.8, 0.5)
    return [_framed(renderer, 35.0, 20.0)]


def _clipping_planes():
    renderer = _renderer()
    for i in range(4):
        sphere = vtkSphereSource()
        sphere.SetRadius(1.0 - 0.2 * i)
        sphere.SetThetaResolution(64)
        sphere.SetPhiResolution(64)
        plane = vtkPlane()
        plane.SetNormal(-0.6, -0.3 * i, -0.5)
        plane.SetOrigin(0.3 - 0.05 * i, 0.0, 0.2)
        _add(renderer, sphere, i / 4.0, 1.0 if i == 3 else 0.4).GetMapper().AddClippingPlane(plane)
    return [_framed(renderer, 40.0, 20.0)]


def _textures():
    renderer = _renderer()
    y, x = numpy.mgrid[0:16, 0:16]
    for i in range(3):
        alpha = numpy.where((x // 4 + y // 4) % 2 == 0, 0, numpy.where((x + y) % 5 == 0, 255, 140))
        texels = numpy.dstack([x * 0 + 230 if i == 0 else 16 * x, x * 0 + 200 if i == 1 else 12 * y,
                               x * 0 + (240 if i == 2 else 30), alpha]).astype(numpy.uint8)
        image = vtkImageData()
        image.SetDimensions(16, 16, 1)
        image.GetPointData().SetScalars(numpy_to_vtk(texels.reshape(-1, 4), deep=True))
        texture = vtkTexture()
        texture.SetInputData(image)
        texture.InterpolateOff()
        texture.SetColorModeToDirectScalars()
        actor = _add(renderer, vtkPlaneSource(), 0.0, 1.0)
        actor.GetProperty().SetColor(1.0, 1.0, 1.0)
        actor.SetTexture(texture)
        actor.RotateY(60.0 * i)
        actor.RotateX(20.0 * i)
        actor.GetProperty().LightingOff()
    return [_framed(renderer, 25.0, 20.0)]


def _cylinders():
    renderer = _renderer()
    cylinder = vtkCylinderSource()
    cylinder.SetResolution(24)
    cylinder.SetHeight(2.5)
    cylinder.SetRadius(0.25)
    for i in range(6):
        actor = _add(renderer, cylinder, i / 6.0, 1.0 if i == 2 else 0.4)
        actor.RotateZ(30.0 * i + 7.0)
        actor.RotateX(11.0 * i)
    return [_framed(renderer, 10.0, 10.0)]


def _transparent_background():
    renderer = _renderer()
    renderer.SetBackground(0.0, 0.0, 0.0)
    renderer.SetBackgroundAlpha(0.0)
    _add_spheres(renderer, 5, 0.3)
    return [_framed(renderer, 0.0, 30.0)]


def _viewports():
    left, right, top = _renderer(0.0, 0.45), _renderer(0.45, 1.0), _renderer(0.2, 0.8)
    right.SetBackground(0.1, 0.1, 0.3)
    top.SetLayer(1)
    _add_spheres(left, 6, 0.4)
    _add_spheres(right, 9, 0.25)
    _add_spheres(top, 3, 0.5)
    return [_framed(left, 0.0, 0.0), _framed(right, 50.0, 20.0), _framed(top, 0.0, 70.0)]


BASELINES = (_isosurfaces, _spheres, _impostors, _clipping_planes, _textures, _cylinders,
             _transparent_background, _viewports)
