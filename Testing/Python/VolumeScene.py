# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of VolumeMarcher.py in VTK, drawn by a method of vtkOIT or by VTK's own, in a window that is kept."""

import numpy
import vtkoit
import VolumeMarcher
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkVolume,
)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper
from vtkoit import picture
from vtkoit.windows import make_window

# "METHOD" in the renderer's own pipeline, "chain-METHOD" in a chain of passes.
VTK_DEFAULT, VTK_DUAL = "vtk-default", "vtk-dual"
PEELS = 300  # more than any scene here has


def volume_of(cloud, distance):
    """A vtkVolume of a VolumeMarcher.Cloud, with samples at a distance of each other."""
    image = vtkImageData()
    image.SetDimensions(*cloud.values.shape[::-1])
    image.SetOrigin(*cloud.origin)
    image.SetSpacing(*cloud.spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(cloud.values.ravel(), deep=True))
    mapper = vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(distance)
    mapper.SetUseJittering(False)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    material = volume.GetProperty()
    opacity, color = vtkPiecewiseFunction(), vtkColorTransferFunction()
    for point in cloud.opacity:
        opacity.AddPoint(*point)
    for point in cloud.color:
        color.AddRGBPoint(*point)
    material.SetScalarOpacity(opacity)
    material.SetColor(color)
    material.SetScalarOpacityUnitDistance(cloud.unit)
    material.SetInterpolationTypeToLinear()
    material.ShadeOff()
    return volume


def actor_of(surface, opaque=False):
    """An unlit vtkActor of a VolumeMarcher.Square or Ball."""
    source = _ball(surface) if isinstance(surface, VolumeMarcher.Ball) else _square(surface)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    material = actor.GetProperty()
    material.SetColor(*surface.color)
    material.SetOpacity(1.0 if opaque else surface.opacity)
    material.SetLighting(False)
    if not opaque:
        actor.ForceTranslucentOn()
    return actor


def _square(square):
    center = numpy.array(square.center, dtype=float)
    first, second = (square.half * side for side in VolumeMarcher.side_directions(square.normal))
    plane = vtkPlaneSource()
    plane.SetOrigin(*(center - first - second))
    plane.SetPoint1(*(center + first - second))
    plane.SetPoint2(*(center - first + second))
    return plane


def _ball(ball):
    sphere = vtkSphereSource()
    sphere.SetCenter(*ball.center)
    sphere.SetRadius(ball.radius)
    sphere.SetThetaResolution(128)
    sphere.SetPhiResolution(128)
    return sphere


def place(renderer, camera):
    """Gives a vtkRenderer a VolumeMarcher.Camera."""
    own = renderer.GetActiveCamera()
    own.SetPosition(*camera.position)
    own.SetFocalPoint(*camera.focal)
    own.SetViewUp(*camera.up)
    own.SetParallelProjection(camera.parallel)
    own.SetParallelScale(camera.scale)
    own.SetViewAngle(camera.angle)
    own.SetClippingRange(camera.near, camera.far)


def install(renderer, way):
    """Draws the translucent props and the volumes of a vtkRenderer by VTK_DEFAULT, VTK_DUAL, a method, or "chain-METHOD"; the
    vtkOITPass, or None."""
    if way == VTK_DUAL:
        renderer.UseDepthPeelingOn()
        renderer.UseDepthPeelingForVolumesOn()
        renderer.SetMaximumNumberOfPeels(PEELS)
        renderer.SetOcclusionRatio(0.0)
        return None
    if way == VTK_DEFAULT:
        return None
    if not way.startswith("chain-"):
        return vtkoit.install(renderer, way)
    from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkVolumetricPass

    steps = vtkRenderStepsPass()
    instance = vtkoit.create(way[len("chain-"):])
    instance.SetVolumetricPass(vtkVolumetricPass())
    steps.SetTranslucentPass(instance)
    steps.SetVolumetricPass(None)
    renderer.SetPass(steps)
    return instance


class Window:
    """Draws scenes by one of the ways of install(), all in one OpenGL context."""

    def __init__(self, way, size):
        self.renderer = vtkRenderer()
        self.instance = install(self.renderer, way)
        self.window = make_window(self.renderer, size)

    def draw(self, camera, props, background=(0, 0, 0), alpha=1.0):
        """What the window shows of a VolumeMarcher.Camera and vtkProps, as picture.grab(), in float. Rendered twice: the second
        frame knows how many layers there are."""
        self.renderer.RemoveAllViewProps()
        for prop in props:
            self.renderer.AddViewProp(prop)
        self.renderer.SetBackground(*background)
        self.renderer.SetBackgroundAlpha(alpha)
        place(self.renderer, camera)
        self.window.Render()
        self.window.Render()
        return picture.grab(self.window).astype(float)

    def close(self):
        """Frees the OpenGL context."""
        self.renderer.RemoveAllViewProps()
        self.renderer.SetPass(None)
        self.window.RemoveRenderer(self.renderer)
        self.window.Finalize()
