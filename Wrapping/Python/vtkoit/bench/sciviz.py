# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as they are drawn in practice, made by formulas: isosurfaces, tubes and glyphs, a molecule, a
hull, foliage, a scan."""

import math

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk

from .families import look_at_spheres, spheres, stack
from .scene import Part, Scene, append, facing, impostors, mesh, rainbow, sphere


def scenes():
    """All of them, list of Scene."""
    return [
        Scene("spheres", "16 overlapping spheres", spheres, look_at_spheres),
        Scene("isosurfaces", "10 nested isosurfaces of vtkRTAnalyticSource",
              lambda: isosurfaces(10, 50), _look_at_isosurfaces),
        Scene("deep", "64 planes behind each other over the whole window",
              lambda: stack(64), lambda r: facing(r, 0.95)),
        Scene("crossings", "64 planes over the whole window, of which every seventh pair crosses",
              _crossings, lambda r: facing(r, 0.95)),
        Scene("small-props", "800 small spheres, each a prop", _small_props, look_at_spheres),
        Scene("one-sphere", "one sphere", lambda: [Part(sphere(), (0.2, 0.5, 0.8), 0.4)],
              look_at_spheres),
        Scene("disjoint", "64 discs side by side: no pixel has two layers", _disjoint,
              lambda r: facing(r, 1.0)),
        Scene("hull", "a translucent hull around opaque parts", _hull, _look_at_hull),
        Scene("tubes", "40 overlapping tubes and 200 arrows", _tubes, _look_at_tubes),
        Scene("molecule", "300 atoms and bonds as impostors of spheres and sticks", _molecule,
              look_at_spheres),
        Scene("grass", "3000 blades of grass as quads with an opacity gradient", _grass,
              _look_at_grass),
        Scene("foliage", "4000 leaves as textured quads",
              lambda: foliage(4000, 0.8), look_at_spheres),
        Scene("scan", "a knot of 200 k triangles seen through itself", lambda: knot(0.4),
              look_at_spheres),
    ]


def isosurfaces(count, half):
    """Isosurfaces of the wavelet of -half to half samples, list of Part."""
    from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

    wavelet = vtkRTAnalyticSource()
    wavelet.SetWholeExtent(-half, half, -half, half, -half, half)
    result = []
    for i in range(count):
        contour = vtkFlyingEdges3D()
        contour.SetInputConnection(wavelet.GetOutputPort())
        contour.ComputeScalarsOff()
        contour.SetValue(0, 60.0 + 200.0 * i / count)
        contour.Update()
        result.append(Part(contour.GetOutput(), rainbow(i / count), 0.3))
    return result


def _look_at_isosurfaces(renderer):
    renderer.ResetCamera()
    camera = renderer.GetActiveCamera()
    camera.Azimuth(30.0)
    camera.Elevation(20.0)
    camera.Zoom(1.4)
    renderer.ResetCameraClippingRange()


def _crossings():
    """The planes of a pair lean to either side, but not as far as to the next ones."""
    result = stack(64)
    for i, part in enumerate(sorted(result, key=lambda part: part.data.GetBounds()[4])):
        if i % 7 < 2:
            points = part.data.GetPoints()
            for n in range(points.GetNumberOfPoints()):
                x, y, z = points.GetPoint(n)
                points.SetPoint(n, x, y, z + 0.016 * x * (1 if i % 7 else -1))
            points.Modified()
            part.data.Modified()
    return result


def _small_props():
    places = numpy.random.default_rng(5).uniform(-1, 1, (800, 3))
    return [Part(sphere(place, 0.12, 12), rainbow(i / 800), 0.4) for i, place in enumerate(places)]


def _disjoint():
    angles = numpy.linspace(0, 2 * math.pi, 48, endpoint=False)
    circle = 0.1 * numpy.c_[numpy.cos(angles), numpy.sin(angles), 0 * angles]
    result = []
    for i in range(64):
        center = numpy.array([0.24 * (i % 8 - 3.5), 0.24 * (i // 8 - 3.5), 0.1 * math.sin(i)])
        result.append(Part(mesh(circle + center, [range(48)]), rainbow(i / 64), 0.5, "unlit"))
    return result


def _hull():
    from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource

    result = [Part(sphere((0, 0, 0), 1.2, 96), (0.6, 0.75, 0.85), 0.25),
              Part(sphere((0, 0, 0), 1.1, 96), (0.8, 0.7, 0.5), 0.2)]
    random = numpy.random.default_rng(11)
    for i in range(24):
        source = vtkCubeSource() if i % 2 else vtkCylinderSource()
        center = random.uniform(-0.55, 0.55, 3)
        source.SetCenter(*center)
        if i % 2:
            for set_length in (source.SetXLength, source.SetYLength, source.SetZLength):
                set_length(0.15 + 0.2 * random.random())
        else:
            source.SetRadius(0.1)
            source.SetHeight(0.4)
            source.SetResolution(32)
        source.Update()
        result.append(Part(source.GetOutput(), rainbow(i / 24), 1.0))
    return result


def _look_at_hull(renderer):
    renderer.ResetCamera()
    renderer.GetActiveCamera().Elevation(25.0)
    renderer.GetActiveCamera().Zoom(1.3)
    renderer.ResetCameraClippingRange()


def _tube(points, radius, sides):
    """A tube around a line, array n x 3, as (points, quads, normals)."""
    tangent = numpy.gradient(points, axis=0)
    tangent /= numpy.linalg.norm(tangent, axis=1)[:, None]
    # Any direction that is not along the line, made perpendicular to it at each point.
    helper = numpy.where(numpy.abs(tangent[:, 2:]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    first = numpy.cross(tangent, helper)
    first /= numpy.linalg.norm(first, axis=1)[:, None]
    second = numpy.cross(tangent, first)
    angle = numpy.linspace(0, 2 * math.pi, sides, endpoint=False)
    normals = numpy.cos(angle)[None, :, None] * first[:, None] \
        + numpy.sin(angle)[None, :, None] * second[:, None]
    ring, side = numpy.meshgrid(numpy.arange(len(points) - 1), numpy.arange(sides), indexing="ij")
    here, beside = ring * sides + side, ring * sides + (side + 1) % sides
    cells = numpy.stack([here, beside, beside + sides, here + sides], axis=-1).reshape(-1, 4)
    places = points[:, None] + radius * normals
    return mesh(places.reshape(-1, 3), cells, normals.reshape(-1, 3))


def _tubes():
    from vtkmodules.vtkCommonTransforms import vtkTransform
    from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
    from vtkmodules.vtkFiltersSources import vtkArrowSource

    random = numpy.random.default_rng(2)
    t = numpy.linspace(0, 1, 160)[:, None]
    result = []
    for i in range(40):
        a, b, c = random.uniform(-1, 1, (3, 3))
        line = a * (1 - t) ** 2 + 2.0 * b * t * (1 - t) + c * t ** 2 \
            + 0.08 * numpy.sin(20 * t + random.uniform(0, 6, 3))
        result.append(Part(_tube(line, 0.05, 16), rainbow(i / 40), 0.45))
    arrow = vtkArrowSource()
    arrow.SetTipResolution(16)
    arrow.SetShaftResolution(12)
    arrows = []
    for _ in range(200):
        place = vtkTransform()
        place.Translate(*random.uniform(-0.9, 0.9, 3))
        place.RotateWXYZ(random.uniform(0, 360), *random.uniform(-1, 1, 3))
        place.Scale(0.3, 0.3, 0.3)
        placed = vtkTransformPolyDataFilter()
        placed.SetTransform(place)
        placed.SetInputConnection(arrow.GetOutputPort())
        placed.Update()
        arrows.append(placed.GetOutput())
    result.append(Part(append(arrows), (0.85, 0.4, 0.2), 0.4))
    return result


def _look_at_tubes(renderer):
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(20.0)
    renderer.GetActiveCamera().Zoom(1.3)
    renderer.ResetCameraClippingRange()


def _molecule():
    """A chain that coils, with side groups: atoms of three elements, a bond to each."""
    random = numpy.random.default_rng(9)
    steps = random.normal(size=(300, 3))
    steps *= 0.15 / numpy.linalg.norm(steps, axis=1)[:, None]
    atoms = [numpy.zeros(3)]
    for step in steps[1:]:
        start = atoms[random.integers(max(0, len(atoms) - 4), len(atoms))]
        atoms.append((start + step) * (0.98 if numpy.linalg.norm(start) > 0.8 else 1.0))
    atoms = numpy.array(atoms)
    result = []
    for element, (color, radius) in enumerate(
            (((0.35, 0.35, 0.4), 0.17), ((0.85, 0.2, 0.2), 0.15), ((0.25, 0.4, 0.9), 0.155))):
        result.append(Part(impostors(atoms[element::3], color), color, 0.35, "spheres", radius))
    middle = 0.5 * (atoms[1:] + atoms[:-1])
    direction = atoms[1:] - atoms[:-1]
    length = numpy.linalg.norm(direction, axis=1)
    gray = (0.7, 0.7, 0.7)
    bonds = impostors(middle, gray)
    for name, values in (("direction", direction / length[:, None]),
                         ("radius", numpy.c_[length, 0.03 + 0 * length, 0.03 + 0 * length])):
        array = numpy_to_vtk(values.astype(numpy.float32), deep=True)
        array.SetName(name)
        bonds.GetPointData().AddArray(array)
    result.append(Part(bonds, gray, 0.6, "sticks"))
    return result


def _grass():
    """Blades as thin quads on a meadow, opaque at their foot: opacity by a texture."""
    random = numpy.random.default_rng(4)
    count = 3000
    foot = numpy.c_[random.uniform(-1.5, 1.5, (count, 2)), numpy.zeros(count)]
    angle = random.uniform(0, math.pi, count)
    wide = 0.012 * numpy.c_[numpy.cos(angle), numpy.sin(angle), 0 * angle]
    tip = foot + numpy.c_[0.12 * random.normal(size=(count, 2)), random.uniform(0.25, 0.5, count)]
    corners = numpy.stack([foot - wide, foot + wide, tip + 0.3 * wide, tip - 0.3 * wide], axis=1)
    coordinates = numpy.tile([(0, 0), (1, 0), (1, 1), (0, 1)], (count, 1))
    ground = mesh([(-1.6, -1.6, 0), (1.6, -1.6, 0), (1.6, 1.6, 0), (-1.6, 1.6, 0)], [(0, 1, 2, 3)])
    blades = mesh(corners.reshape(-1, 3), numpy.arange(4 * count).reshape(-1, 4),
                  coordinates=coordinates)
    return [Part(ground, (0.45, 0.35, 0.2), 1.0, "unlit"),
            Part(blades, (1.0, 1.0, 1.0), 1.0, "unlit", 0.0, _blade_texture)]


def _look_at_grass(renderer):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, -3.2, 1.2)
    camera.SetFocalPoint(0, 0, 0.15)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCameraClippingRange()


def foliage(count, opacity):
    """A tree's crown of leaves: textured quads with soft edges, in all directions; list of Part. opacity:
    float, of what is no edge."""
    random = numpy.random.default_rng(6)
    center = random.normal(size=(count, 3)) * [0.45, 0.45, 0.5]
    axes = random.normal(size=(count, 2, 3))
    first = axes[:, 0] / numpy.linalg.norm(axes[:, 0], axis=1)[:, None]
    second = numpy.cross(first, axes[:, 1])
    second /= numpy.linalg.norm(second, axis=1)[:, None]
    first, second = 0.07 * first, 0.05 * second
    corners = numpy.stack([center - first - second, center + first - second,
                           center + first + second, center - first + second], axis=1)
    coordinates = numpy.tile([(0, 0), (1, 0), (1, 1), (0, 1)], (count, 1))
    leaves = mesh(corners.reshape(-1, 3), numpy.arange(4 * count).reshape(-1, 4),
                  coordinates=coordinates)
    return [Part(leaves, (1.0, 1.0, 1.0), 1.0, "unlit", 0.0,
                 lambda: _leaf_texture(opacity))]


def _texture(pixels):
    """A vtkTexture of an array height x width x 4, float in [0, 1]."""
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkRenderingCore import vtkTexture

    height, width, _ = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    values = numpy.rint(255 * numpy.clip(pixels, 0, 1)).astype(numpy.uint8).reshape(-1, 4)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    return texture


def _blade_texture():
    v, u = numpy.mgrid[0:64, 0:16] / [[[63.0]], [[15.0]]]
    edge = numpy.clip(3.0 * (1.0 - numpy.abs(2 * u - 1)), 0, 1)
    return _texture(numpy.dstack([0.15 + 0.3 * v, 0.35 + 0.5 * v, 0.1 + 0.15 * v,
                                  edge * (1.0 - 0.8 * v)]))


def _leaf_texture(opacity):
    v, u = numpy.mgrid[0:64, 0:64] / 31.5 - 1.0
    inside = 1.0 - u * u - (v / numpy.maximum(0.15, 1.0 - u * u)) ** 2
    vein = numpy.exp(-(v / 0.06) ** 2)
    return _texture(numpy.dstack([0.2 + 0.3 * vein, 0.5 + 0.2 * vein, 0.15 + 0.1 * vein,
                                  opacity * numpy.clip(4.0 * inside, 0, 1)]))


def knot(opacity):
    """A knotted surface, list of Part."""
    t = numpy.linspace(0, 2 * math.pi, 1001)
    line = numpy.c_[(2 + numpy.cos(3 * t)) * numpy.cos(2 * t),
                    (2 + numpy.cos(3 * t)) * numpy.sin(2 * t), numpy.sin(3 * t)] / 3.0
    tube = _tube(line, 0.22, 100)
    return [Part(tube, (0.85, 0.75, 0.55), opacity)]
