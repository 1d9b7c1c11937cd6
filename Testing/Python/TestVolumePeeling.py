# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of the kind that VTK tests its depth peeling of volumes with (TestGPURayCastDepthPeeling*): a shaded vase with
spheres through it, clipped, by a widget too, with an opaque sphere, with opacity 0, see-through in two viewports, and
other blend modes than composite. At VTK's own distance between samples vtkOIT must not be further than VTK's dual depth
peeling from what that draws with fine samples.
"""

import itertools
import unittest

import numpy
import Support
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkPiecewiseFunction,
    vtkPlane,
    vtkPlaneCollection,
)
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersModeling import vtkOutlineFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkVolume
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper
from VolumeScene import VTK_DUAL, install
from vtkoit import picture
from vtkoit.windows import make_window

SIZE = (90, 80)
DISTANCE, FINE = 0.4, 0.05  # of samples, in voxels
WAYS = ("auto", "abuffer")
SIDE = 33  # samples of the vase in each direction


def vase():
    """The vtkImageData of a hollow vase: 0 to 130 across its wall, whose radius changes with height."""
    axis = numpy.linspace(-1, 1, SIDE)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    wall = 0.5 + 0.25 * numpy.sin(3.0 * y + 0.5)
    values = 130 * numpy.exp(-((numpy.hypot(x, z) - wall) / 0.14) ** 2) * (abs(y) < 0.9)
    image = vtkImageData()
    image.SetDimensions(SIDE, SIDE, SIDE)
    image.GetPointData().SetScalars(numpy_to_vtk(values.astype(numpy.uint8).ravel(), deep=True))
    return image


class Scene:
    """A vtkRenderer with the vase and two spheres through it."""

    def __init__(self, distance, opacity=1.0, color=(0.6, 0.6, 0.6), background=(0, 0, 0)):
        """distance: float, between samples. opacity: float, of the vase's wall."""
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(*background)
        self.image = vase()
        self.mapper = vtkOpenGLGPUVolumeRayCastMapper()
        self.mapper.SetInputData(self.image)
        self.mapper.SetAutoAdjustSampleDistances(False)
        self.mapper.SetSampleDistance(distance)
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        opacities, colors = vtkPiecewiseFunction(), vtkColorTransferFunction()
        opacities.AddPoint(50, 0.0)
        opacities.AddPoint(75, opacity)
        colors.AddRGBPoint(0, *color)
        material = self.volume.GetProperty()
        material.SetScalarOpacity(opacities)
        material.SetColor(colors)
        material.SetInterpolationTypeToLinear()
        material.ShadeOn()
        self.renderer.AddVolume(self.volume)
        middle = SIDE / 2.0
        self.spheres = [self.add_sphere(3 * [middle], SIDE / 3.0, (0.5, 0.9, 0.7), 0.3),
                        self.add_sphere(3 * [middle + 5.0], SIDE / 3.0, (0.9, 0.4, 0.1), 0.3)]

    def add_sphere(self, center, radius, color, opacity):
        sphere = vtkSphereSource()
        sphere.SetCenter(*center)
        sphere.SetRadius(radius)
        sphere.SetThetaResolution(24)
        sphere.SetPhiResolution(24)
        return self.add(sphere, color, opacity)

    def add_outline(self):
        outline = vtkOutlineFilter()
        outline.SetInputData(self.image)
        return self.add(outline, (1, 1, 1), 1.0)

    def add(self, source, color, opacity):
        return Support.add_actor(self.renderer, source, color, opacity)

    def look(self, azimuth=-55.0, elevation=35.0, zoom=1.0):
        self.renderer.ResetCamera()
        camera = self.renderer.GetActiveCamera()
        camera.Azimuth(azimuth)
        camera.Elevation(elevation)
        camera.OrthogonalizeViewUp()
        camera.Zoom(zoom)
        self.renderer.ResetCameraClippingRange()
        return self

    def clip(self, planes):
        """Clips the volume by planes, list of (origin, normal)."""
        collection = vtkPlaneCollection()
        for origin, normal in planes:
            plane = vtkPlane()
            plane.SetOrigin(*origin)
            plane.SetNormal(*normal)
            collection.AddItem(plane)
        self.mapper.SetClippingPlanes(collection)


def through(distance):
    """Two translucent spheres through a nearly opaque vase, in an outline."""
    scene = Scene(distance)
    scene.add_outline()
    return [scene.look()]


def opaque(distance):
    """One of the spheres is opaque."""
    scene = Scene(distance)
    scene.spheres[1].GetProperty().SetOpacity(1.0)
    scene.add_outline()
    return [scene.look()]


def see_through(distance):
    """A see-through vase over white, and in another viewport with a sphere of opacity 0 alone."""
    left = Scene(distance, 0.06, (0.9, 0.4, 0.9), (1, 1, 1))
    left.renderer.SetViewport(0, 0, 0.5, 1)
    right = Scene(distance, 0.06, (0.9, 0.4, 0.9), (1, 1, 1))
    right.renderer.SetViewport(0.5, 0, 1, 1)
    right.spheres[0].GetProperty().SetOpacity(0.0)
    right.renderer.RemoveActor(right.spheres[1])
    return [left.look(), right.look()]


def invisible(distance):
    """Both spheres have opacity 0, close up: no trace of them may be seen."""
    scene = Scene(distance, 0.05)
    for sphere in scene.spheres:
        sphere.GetProperty().SetOpacity(0.0)
    scene.add_outline()
    return [scene.look(0.0, 0.0, 2.0)]


def clipped(distance):
    """Two planes cut the vase open."""
    scene = Scene(distance)
    scene.add_outline()
    scene.clip([((0.45 * SIDE, 0, 0), (0.8, 0, 0)), ((0.45 * SIDE, 0.35 * SIDE, 0), (0.2, -0.2, 0))])
    return [scene.look(0.0, 0.0)]


def boxed(distance):
    """The six planes of a box that is turned, as a box widget sets them."""
    scene = Scene(distance)
    scene.add_outline()
    turn = vtkTransform()
    turn.RotateWXYZ(30.0, 0.3, 1.0, 0.2)
    planes = []
    for axis, side in itertools.product(range(3), (-1, 1)):
        normal = numpy.array(turn.TransformVector(*(side * float(i == axis) for i in range(3))))
        planes.append((0.5 * SIDE - 0.42 * SIDE * normal, normal))
    scene.clip(planes)
    return [scene.look()]


def moved(distance):
    """The volume is turned, moved and stretched against its surfaces."""
    scene = Scene(distance, 0.3)
    scene.volume.SetOrigin(3 * [0.5 * SIDE])
    scene.volume.RotateZ(25.0)
    scene.volume.SetPosition(3.0, -2.0, 4.0)
    scene.volume.SetScale(1.2, 0.8, 1.0)
    return [scene.look()]


SCENES = (through, opaque, see_through, invisible, clipped, boxed, moved)


def draw(scenes, way, size=SIZE):
    """(picture, array of float; the passes) of a list of Scene in one window."""
    passes = [install(scene.renderer, way) for scene in scenes]
    window = make_window(scenes[0].renderer, size)
    for scene in scenes[1:]:
        window.AddRenderer(scene.renderer)
    window.Render()
    window.Render()
    pixels = picture.grab(window)[..., :3].astype(float)
    for scene in scenes:
        window.RemoveRenderer(scene.renderer)
    window.Finalize()
    return pixels, passes


_fine = {}


def fine_picture(make):
    """What VTK's dual depth peeling draws of a scene with fine samples; drawn once."""
    if make not in _fine:
        _fine[make], _ = draw(make(FINE), VTK_DUAL)
    return _fine[make]


class TestScenes(unittest.TestCase):
    def test_not_further_off_than_vtk(self):
        for make in SCENES:
            fine = fine_picture(make)
            theirs = numpy.abs(draw(make(DISTANCE), VTK_DUAL)[0] - fine)
            self.assertGreater(fine.std(), 5.0, make.__name__)
            for way in WAYS:
                with self.subTest("%s, %s" % (make.__name__, way)):
                    pixels, passes = draw(make(DISTANCE), way)
                    ours = numpy.abs(pixels - fine)
                    for one in passes:  # up to the default TransmittanceThreshold, half a step
                        self.assertLessEqual(one.GetErrorBound(), 1 / 512)
                    self.assertLessEqual(ours.max(), theirs.max() + 1.0)
                    # VTK's own picture with fine samples is rounded at each layer, in steps of 8 bits.
                    self.assertLessEqual((ours ** 2).mean() ** 0.5, (theirs ** 2).mean() ** 0.5 + 0.1)

    def test_fine_samples_agree(self):
        """Where samples are fine, VTK's way and ours are the same."""
        for make in SCENES:
            fine = fine_picture(make)
            pixels, _ = draw(make(FINE), "auto")
            self.assertLessEqual(numpy.abs(pixels - fine).mean(), 0.3, make.__name__)


class TestBlendModes(unittest.TestCase):
    """A projection has no order along a ray: it is one layer, where the ray enters the volume."""

    MODES = ("MaximumIntensity", "MinimumIntensity", "AverageIntensity", "Additive")
    SHIFTS = {"in front": 44.0, "inside": 0.0, "behind": -56.0}  # of the spheres, towards the camera

    def make(self, mode, shift, surfaces=True):
        """A Scene seen along the z axis, in parallel projection."""
        scene = Scene(DISTANCE, 0.4)
        scene.volume.GetProperty().ShadeOff()
        if mode == "MinimumIntensity":  # the smallest value is that of the air
            opacities = vtkPiecewiseFunction()
            opacities.AddPoint(0, 0.4)
            opacities.AddPoint(130, 0.1)
            scene.volume.GetProperty().SetScalarOpacity(opacities)
        getattr(scene.mapper, "SetBlendModeTo" + mode)()
        for actor in scene.spheres:
            actor.SetPosition(0, 0, shift)
            actor.GetProperty().SetLighting(False)
            actor.SetVisibility(surfaces)
        camera = scene.renderer.GetActiveCamera()
        camera.SetPosition(16, 16, 150)
        camera.SetFocalPoint(16, 16, 16)
        camera.SetParallelProjection(True)
        camera.SetParallelScale(20)
        camera.SetClippingRange(1, 300)
        return scene

    def test_one_layer_where_the_ray_enters(self):
        for mode, (name, shift) in itertools.product(self.MODES, self.SHIFTS.items()):
            with self.subTest("%s, %s" % (mode, name)):
                projection = self.projection(self.make(mode, shift, surfaces=False))
                self.assertGreater(projection[1].max(), 0.1)
                layers = sorted_layers(self.faces(shift) + [(numpy.full(SIZE[::-1], SIDE - 1.0), *projection)])
                expected, left = numpy.zeros((*SIZE[::-1], 3)), 1.0
                for color, alpha in layers:
                    expected = expected + left * color
                    left = left * (1.0 - alpha)
                pixels, _ = draw([self.make(mode, shift)], "auto")
                off = numpy.abs(pixels - 255.0 * expected).max(axis=2)
                # Triangles have other outlines and heights than spheres, in few pixels.
                self.assertLessEqual(numpy.percentile(off, 90), 1.5)

    @staticmethod
    def projection(scene):
        """(premultiplied colour, opacity), arrays in [0, 1], of what a volume alone shows."""
        scene.renderer.SetBackgroundAlpha(0.0)
        window = make_window(scene.renderer, SIZE)
        window.Render()
        pixels = picture.grab(window) / 255.0
        window.RemoveRenderer(scene.renderer)
        window.Finalize()
        return pixels[..., :3], pixels[..., 3:]

    @staticmethod
    def faces(shift):
        """The four faces of the spheres, list of (height, premultiplied colour, opacity), arrays."""
        row, column = numpy.mgrid[0:SIZE[1], 0:SIZE[0]]
        y = 16 + 20 * (1 - 2 * (row + 0.5) / SIZE[1])
        x = 16 + 20 * (2 * (column + 0.5) / SIZE[0] - 1) * SIZE[0] / SIZE[1]
        result = []
        for center, color in ((SIDE / 2, (0.5, 0.9, 0.7)), (SIDE / 2 + 5, (0.9, 0.4, 0.1))):
            square = (SIDE / 3) ** 2 - (x - center) ** 2 - (y - center) ** 2
            alpha = numpy.where(square > 0, 0.3, 0.0)[..., None]
            for sign in (1, -1):
                height = center + shift + sign * numpy.sqrt(numpy.maximum(square, 0))
                result.append((height, alpha * numpy.array(color), alpha))
        return result


def sorted_layers(layers):
    """Layers, list of (height, colour, opacity), arrays, as a list of (colour, opacity), the highest first at each pixel."""
    order = numpy.argsort([-height for height, _, _ in layers], axis=0)[..., None]
    colors, alphas = (numpy.take_along_axis(numpy.array([layer[part] for layer in layers]), order, axis=0)
                      for part in (1, 2))
    return list(zip(colors, alphas))


if __name__ == "__main__":
    unittest.main()
