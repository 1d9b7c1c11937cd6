# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a scene of the laboratory is made of: parts, a camera, and how they come into a renderer.

Each method draws into a window of its own, so actors and mappers are made once for each; the geometry
is made once and shared.
"""

import collections

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

from .. import volumes

Part = collections.namedtuple("Part", "data color opacity kind radius texture")
Part.__doc__ = """One prop: data (vtkPolyData), color ((r, g, b) in [0, 1]), opacity (float), kind ("surface",
"unlit", "spheres" or "sticks": impostors around points or lines), radius (float, of impostors), texture
(vtkTexture maker: a function without arguments, or None)."""
Part.__new__.__defaults__ = ("surface", 0.0, None)

Cloud = collections.namedtuple("Cloud", "volume colormap limits distance")
Cloud.__doc__ = """One prop: volume (volumes.Volume), colormap (str), limits ((low, high), the values at the colour map's two
ends, or None for those that are seen) and distance (float, between samples along a ray, or None for what the
command render takes)."""

Scene = collections.namedtuple("Scene", "name title make place size family value")
Scene.__doc__ = """A scene: name (str), title (str, one line), make (function without arguments that returns a
list of Part and Cloud), place (function of a vtkRenderer that places its camera), size ((width, height) in pixels, or
None for the user's), family (str, the thing that changes from scene to scene, or None) and value (float, of
that thing)."""
Scene.__new__.__defaults__ = (None, None, None)

BACKGROUND = (1.0, 1.0, 1.0)


def fill(scene, parts):
    """A new vtkRenderer with a prop for each of the parts, list of Part and Cloud, and the scene's camera."""
    renderer = vtkRenderer()
    renderer.SetBackground(*BACKGROUND)
    renderer.SetBackgroundAlpha(1.0)
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    renderer.AddLight(light)
    renderer.SetAutomaticLightCreation(False)
    for part in parts:
        if isinstance(part, Cloud):
            renderer.AddVolume(volumes.actor_of(*part))
        else:
            renderer.AddActor(actor_of(part))
    scene.place(renderer)
    return renderer


def actor_of(part):
    """A new vtkActor for a Part."""
    actor = vtkActor()
    actor.SetMapper(_mapper(part))
    material = actor.GetProperty()
    material.SetColor(*part.color)
    material.SetOpacity(part.opacity)
    material.SetAmbient(0.15)
    material.SetDiffuse(0.85)
    if part.kind == "unlit":
        material.SetLighting(False)
    if part.texture is not None:
        actor.SetTexture(part.texture())
        actor.ForceTranslucentOn()
    return actor


def _mapper(part):
    if part.kind == "spheres":
        from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

        mapper = vtkOpenGLSphereMapper()
        mapper.SetRadius(part.radius)
    elif part.kind == "sticks":
        from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLStickMapper

        mapper = vtkOpenGLStickMapper()
        mapper.SetScaleArray("radius")
        mapper.SetOrientationArray("direction")
    else:
        mapper = vtkPolyDataMapper()
    mapper.SetInputData(part.data)
    # Impostors of VTK 9.1 crash without a colour of each point.
    mapper.SetScalarVisibility(part.kind in ("spheres", "sticks"))
    return mapper


def impostors(points, color):
    """A vtkPolyData of points for the kinds "spheres" and "sticks". points: array n x 3. color:
    (r, g, b) in [0, 1]."""
    data = mesh(points, numpy.zeros((0, 3), int))
    number = data.GetNumberOfPoints()
    cells = vtkCellArray()
    cells.SetData(_ids(numpy.arange(number + 1)), _ids(numpy.arange(number)))
    data.SetVerts(cells)
    bytes_ = numpy.rint(255.0 * numpy.array(color)).astype(numpy.uint8)
    colors = numpy_to_vtk(numpy.tile(bytes_, (number, 1)), deep=True)
    colors.SetName("colors")
    data.GetPointData().SetScalars(colors)
    return data


def surfaces_of(parts):
    """The Parts in a list of Part and Cloud, list."""
    return [part for part in parts if isinstance(part, Part)]


def triangles_of(parts):
    """The number of triangles of a list of Part and Cloud, int; impostors count as two."""
    number = 0
    for part in surfaces_of(parts):
        if part.kind in ("spheres", "sticks"):
            number += 2 * part.data.GetNumberOfPoints()
        else:
            connectivity = part.data.GetPolys().GetNumberOfConnectivityIds()
            number += connectivity - 2 * part.data.GetNumberOfPolys()
            strips = part.data.GetStrips()
            number += strips.GetNumberOfConnectivityIds() - 2 * strips.GetNumberOfCells()
    return number


def mesh(points, triangles, normals=None, coordinates=None):
    """A vtkPolyData. points: array n x 3. triangles: int array m x k, polygons of k points.
    normals: array n x 3, coordinates: array n x 2, of textures; or None."""
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=numpy.float32), deep=True))
    data.SetPoints(places)
    triangles = numpy.asarray(triangles, dtype=numpy.int64)
    cells = vtkCellArray()
    offsets = numpy.arange(len(triangles) + 1, dtype=numpy.int64) * triangles.shape[1]
    cells.SetData(_ids(offsets), _ids(triangles.ravel()))
    data.SetPolys(cells)
    for values, setter in ((normals, data.GetPointData().SetNormals),
                           (coordinates, data.GetPointData().SetTCoords)):
        if values is not None:
            setter(numpy_to_vtk(numpy.ascontiguousarray(values, dtype=numpy.float32), deep=True))
    return data


def _ids(values):
    from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray

    return numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(values), deep=True)


def quads(corners):
    """A vtkPolyData of separate quads. corners: array n x 4 x 3."""
    corners = numpy.asarray(corners, dtype=float).reshape(-1, 4, 3)
    return mesh(corners.reshape(-1, 3), numpy.arange(4 * len(corners)).reshape(-1, 4))


def sphere(center=(0, 0, 0), radius=1.0, resolution=64):
    """The vtkPolyData of a sphere with point normals; resolution: around, and from pole to pole."""
    from vtkmodules.vtkFiltersSources import vtkSphereSource

    source = vtkSphereSource()
    source.SetCenter(*center)
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    return source.GetOutput()


def append(data_sets):
    """Several vtkPolyData as one."""
    from vtkmodules.vtkFiltersCore import vtkAppendPolyData

    filter_ = vtkAppendPolyData()
    for data in data_sets:
        filter_.AddInputData(data)
    filter_.Update()
    return filter_.GetOutput()


def facing(renderer, scale=1.0, clip=(0.1, 100.0), distance=10.0):
    """Looks down the z axis in parallel projection: scale is half the height of the window."""
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(scale)
    camera.SetPosition(0, 0, distance)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 1, 0)
    camera.SetClippingRange(*clip)


def rainbow(fraction):
    """A colour of the rainbow, (r, g, b), for a float."""
    import math

    return tuple(0.55 + 0.45 * math.cos(6.2831853 * (fraction - i / 3.0)) for i in range(3))
