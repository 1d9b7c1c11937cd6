# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of volumes and translucent surfaces: a flow field with isosurfaces, smoke around a mesh, and layers inside a
volume, whose number is all that changes."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from ..volumes import Volume
from .families import short, stack
from .scene import Cloud, Part, Scene, facing
from .sciviz import knot

LAYERS = (0, 2, 4, 8, 16, 64)
# (name of the family, samples of a ray, whether the volume is shaded)
VARIANTS = (("volumes-60", 60, False), ("volumes-60-shaded", 60, True),
            ("volumes-240", 240, False), ("volumes-240-shaded", 240, True))
# (name of the family, places of the middle of the layers along the line of sight)
OUTSIDE = (("volumes-front", 0.9), ("volumes-behind", -0.9))
OUTSIDE_LAYERS = (2, 8)


def scenes():
    """Those that are as in practice, list of Scene."""
    return [Scene("flow", "speed around a ring of vortices, 3 isosurfaces of the vorticity", _flow, _look),
            Scene("smoke", "smoke around a knot of 200 k triangles", _smoke, _look)]


def family_scenes():
    """Those of the families "volumes-...", list of Scene, each in ascending order of the number of layers."""
    inside = [_layers(family, samples, shade, count) for family, samples, shade in VARIANTS for count in LAYERS]
    return inside + [_layers(family, 60, False, count, place) for family, place in OUTSIDE for count in OUTSIDE_LAYERS]


def image_of(values, low, high):
    """A vtkImageData of an array z x y x x between two corners, (x, y, z)."""
    image = vtkImageData()
    size = numpy.array(values.shape[::-1])
    image.SetDimensions(*[int(n) for n in size])
    image.SetOrigin(*low)
    image.SetSpacing(*((numpy.array(high) - low) / (size - 1)))
    scalars = numpy_to_vtk(numpy.ascontiguousarray(values, dtype=numpy.float32).ravel(), deep=True)
    scalars.SetName("values")
    image.GetPointData().SetScalars(scalars)
    return image


def grid(low, high, count):
    """(z, y, x), arrays of the places of count samples in each direction between two corners."""
    return numpy.meshgrid(*[numpy.linspace(low[i], high[i], count) for i in (2, 1, 0)], indexing="ij")


def _look(renderer):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2.2, -3.6, 2.1)
    camera.SetFocalPoint(0, 0, 0.1)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(35)
    renderer.ResetCameraClippingRange()


def _layers(family, samples, shade, count, middle=0.0):
    half = 0.4

    def make():
        low, high = (-0.7, -0.7, -half), (0.7, 0.7, half)
        z, y, x = grid(low, high, 64)
        values = numpy.sin(7 * x + 2 * z) * numpy.cos(6 * y - z) + 0.5 * numpy.sin(9 * z + 3 * x)
        # About a tenth of the light gets through: no ray ends early.
        volume = Volume(family, image_of(values, low, high), [(-1.5, 0.0), (1.5, 0.95)], 1.0, shade, False)
        layers = stack(count, 0.7, 0.7, 0.05, 2.0 * half / (count + 1), middle) if count else []
        return [Cloud(volume, "viridis", None, 2.0 * half / samples), *layers]

    where = "inside" if not middle else "in front of" if middle > 0 else "behind"
    title = "%d layer%s %s a volume, %d samples a ray%s" % (
        count, "s"[:count != 1], where, samples, ", shaded" if shade else "")
    return Scene("%s-%s" % (family, short(count)), title, make, lambda r: facing(r, 0.8), None, family, float(count))


def _flow():
    """The speed of air around a ring of eight vortices of either sense, and where it turns fastest."""
    from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

    low, high = (-1.1, -1.1, -0.7), (1.1, 1.1, 0.7)
    z, y, x = grid(low, high, 72)
    velocity = numpy.zeros((3, *x.shape))
    vorticity = numpy.zeros(x.shape)
    for i in range(8):
        angle = 2 * numpy.pi * i / 8
        tilt = 0.25 * numpy.cos(2 * angle)
        axis = numpy.array([0.5 * numpy.cos(angle), 0.5 * numpy.sin(angle), 1.0])
        axis /= numpy.linalg.norm(axis)
        away = numpy.stack([x - 0.65 * numpy.cos(angle), y - 0.65 * numpy.sin(angle), z - tilt])
        away -= numpy.einsum("izyx,i->zyx", away, axis) * axis[:, None, None, None]
        core = numpy.exp(-(away ** 2).sum(axis=0) / 0.018 - (z - tilt) ** 2 / 0.25)
        velocity += (-1) ** i * numpy.cross(axis, away, axisb=0, axisc=0) * core / 0.1
        vorticity += core
    speed = numpy.sqrt((velocity ** 2).sum(axis=0))
    volume = Volume("speed", image_of(speed, low, high), [(0.05, 0.0), (0.3, 0.12), (0.7, 0.5)], 0.1, False, False)
    parts = [Cloud(volume, "inferno", None, None)]
    field = image_of(vorticity, low, high)
    for value, color, opacity in ((0.15, (0.3, 0.6, 0.9), 0.2), (0.4, (0.4, 0.8, 0.6), 0.3), (0.7, (1.0, 0.9, 0.6), 0.5)):
        contour = vtkFlyingEdges3D()
        contour.SetInputData(field)
        contour.ComputeScalarsOff()
        contour.SetValue(0, value)
        contour.Update()
        parts.append(Part(contour.GetOutput(), color, opacity))
    return parts


def _smoke():
    """Smoke that rises in billows around a knot."""
    low, high = (-1.2, -1.2, -0.7), (1.2, 1.2, 1.2)
    z, y, x = grid(low, high, 80)
    random = numpy.random.default_rng(3)
    density = numpy.zeros(x.shape)
    for _ in range(36):
        height, angle = random.uniform(-0.45, 0.95), random.uniform(0, 2 * numpy.pi)
        away = random.uniform(0.1, 0.85)
        width = random.uniform(0.16, 0.24) + 0.08 * (height + 0.5)
        density += numpy.exp(-((x - away * numpy.cos(angle)) ** 2 + (y - away * numpy.sin(angle)) ** 2
                               + (z - height) ** 2) / width ** 2)
    billows = numpy.zeros(x.shape)
    for octave in range(1, 4):
        wave, shift = random.normal(size=3) * 4.0 * octave, random.uniform(0, 6)
        billows += numpy.sin(wave[0] * x + wave[1] * y + wave[2] * z + shift) / octave
    density = numpy.clip(density * (1.0 + 0.45 * billows) - 0.12, 0.0, 1.5)
    volume = Volume("smoke", image_of(density, low, high), [(0.02, 0.0), (0.5, 0.15), (1.5, 0.35)], 0.1, False, False)
    return [Cloud(volume, "gray", (-0.4, 2.0), None), *knot(0.5)]
