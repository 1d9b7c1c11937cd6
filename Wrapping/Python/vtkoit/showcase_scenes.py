# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of the showcase: procedural, with a headlight."""

import math

from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import (
    vtkCubeSource,
    vtkParametricFunctionSource,
    vtkSphereSource,
)
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

from . import camera, colors


def _renderer():
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetBackgroundAlpha(1.0)
    # One headlight: the colour of a fragment depends on its normal alone.
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    renderer.AddLight(light)
    renderer.SetAutomaticLightCreation(False)
    return renderer


def _add(renderer, algorithm, color, opacity):
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(algorithm.GetOutputPort())
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(triangles.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    material = actor.GetProperty()
    material.SetInterpolationToPhong()
    material.SetAmbient(0.15)
    material.SetDiffuse(0.85)
    material.SetColor(*color)
    material.SetOpacity(opacity)
    renderer.AddActor(actor)


def isosurfaces():
    """Ten nested isosurfaces of vtkRTAnalyticSource, each less see-through further in."""
    renderer = _renderer()
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-25, 25, -25, 25, -25, 25)
    # Half the waves of the source's own setting: fewer, larger folds.
    source.SetXFreq(30.0)
    source.SetYFreq(15.0)
    source.SetZFreq(20.0)
    for i in range(10):
        contour = vtkFlyingEdges3D()
        contour.SetInputConnection(source.GetOutputPort())
        contour.ComputeScalarsOff()
        contour.SetValue(0, 70.0 + 18.0 * i)
        _add(renderer, contour, colors.sequential_color(0.1 + 0.09 * i, "viridis"), 0.18 + 0.02 * i)
    camera.place(renderer, (-50.0, 25.0))
    return renderer


def spheres():
    """Sixteen overlapping spheres around an opaque one."""
    renderer = _renderer()
    for i in range(16):
        angle = 2.0 * math.pi * i / 16.0
        sphere = vtkSphereSource()
        sphere.SetCenter(math.cos(angle), math.sin(angle), 0.35 * math.sin(3.0 * angle))
        sphere.SetRadius(0.55)
        sphere.SetThetaResolution(64)
        sphere.SetPhiResolution(64)
        _add(renderer, sphere, colors.palette_color(i % 8), 0.4)
    core = vtkSphereSource()
    core.SetRadius(0.45)
    core.SetThetaResolution(64)
    core.SetPhiResolution(64)
    _add(renderer, core, (0.75, 0.75, 0.75), 1.0)
    camera.place(renderer, (-70.0, 50.0))
    return renderer


def rings():
    """Linked rings that pass through each other and through a glass box."""
    from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus

    renderer = _renderer()
    for i in range(5):
        torus = vtkParametricTorus()
        torus.SetRingRadius(1.0)
        torus.SetCrossSectionRadius(0.22)
        source = vtkParametricFunctionSource()
        source.SetParametricFunction(torus)
        source.SetUResolution(96)
        source.SetVResolution(32)
        turn = vtkTransform()
        turn.Translate(0.85 * (i - 2), 0.0, 0.0)
        turn.RotateX(90.0 * (i % 2) + 20.0)
        placed = vtkTransformPolyDataFilter()
        placed.SetTransform(turn)
        placed.SetInputConnection(source.GetOutputPort())
        _add(renderer, placed, colors.palette_color(i), 0.45)
    box = vtkCubeSource()
    box.SetXLength(2.2)
    box.SetYLength(1.5)
    box.SetZLength(1.5)
    _add(renderer, box, (0.45, 0.6, 0.7), 0.25)
    camera.place(renderer, (-65.0, 28.0))
    return renderer


SCENES = [
    ("isosurfaces", isosurfaces),
    ("spheres", spheres),
    ("rings", rings),
]
