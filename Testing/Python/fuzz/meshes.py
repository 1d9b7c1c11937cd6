# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkPolyData and tables of colours from descriptions."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkIdList, vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData, vtkPolyDataNormals, vtkStripper, vtkTriangleFilter, vtkTubeFilter)
from vtkmodules.vtkFiltersSources import (
    vtkConeSource, vtkCubeSource, vtkDiskSource, vtkLineSource, vtkParametricFunctionSource, vtkPlaneSource,
    vtkSphereSource)


def make_mesh(shape, colors):
    """The mesh of a description's shape, with the arrays of its colours."""
    mesh = _SHAPES[shape["kind"]](shape, numpy.random.RandomState(shape["seed"]))
    if shape["kind"] not in ("lines", "vertices", "strips", "empty"):
        if shape["normals"]:
            filter_ = vtkPolyDataNormals()
            filter_.SetInputData(mesh)
            filter_.Update()
            mesh = filter_.GetOutput()
        else:
            mesh.GetPointData().SetNormals(None)
    mesh = _alone(mesh)
    if mesh.GetNumberOfPoints():
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        points += numpy.asarray(shape["at"], dtype=points.dtype)
        if shape["jitter"]:
            noise = numpy.random.RandomState(shape["jitter"])
            points += noise.uniform(-0.08, 0.08, points.shape).astype(points.dtype)
    _add_texture_coordinates(mesh)
    _add_colors(mesh, colors)
    return mesh


def make_table(colors):
    """Of opacities too; not a number gets a colour of its own, and values beyond the ends too."""
    random = numpy.random.RandomState(colors["table"])
    table = vtkLookupTable()
    table.SetNumberOfTableValues(random.choice([2, 5, 64]))
    table.SetRange(0.0, 1.0)
    table.Build()
    for i in range(table.GetNumberOfTableValues()):
        opacity = random.uniform() if random.uniform() < 0.5 else colors["opacity"]
        table.SetTableValue(i, *random.uniform(size=3), opacity)
    table.SetNanColor(*random.uniform(size=3), colors["opacity"])
    table.SetUseBelowRangeColor(bool(random.randint(2)))
    table.SetBelowRangeColor(*random.uniform(size=4))
    return table


def make_image(texture):
    random = numpy.random.RandomState(texture["seed"])
    values = random.randint(0, 256, (36, texture["components"]), dtype=numpy.uint8)
    image = vtkImageData()
    image.SetDimensions(6, 6, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    return image


def _alone(mesh):
    """A copy that shares nothing with the filter that made it, its points in float32."""
    copy = vtkPolyData()
    copy.DeepCopy(mesh)
    if copy.GetPoints():
        points = vtkPoints()
        points.SetData(numpy_to_vtk(vtk_to_numpy(copy.GetPoints().GetData()).astype(numpy.float32), deep=True))
        copy.SetPoints(points)
    return copy


def _add_texture_coordinates(mesh):
    count = mesh.GetNumberOfPoints()
    if count and not mesh.GetPointData().GetTCoords():
        xyz = vtk_to_numpy(mesh.GetPoints().GetData())
        tcoords = numpy_to_vtk(numpy.ascontiguousarray(0.5 + xyz[:, :2]), deep=True)
        tcoords.SetName("coordinates")
        mesh.GetPointData().SetTCoords(tcoords)


def _add_colors(mesh, colors):
    data = mesh.GetCellData() if colors["by"] == "cell" else mesh.GetPointData()
    count = mesh.GetNumberOfCells() if colors["by"] == "cell" else mesh.GetNumberOfPoints()
    random = numpy.random.RandomState(colors["seed"])
    if colors["kind"] in ("rgba", "rgb"):
        values = random.randint(0, 256, (count, 4), dtype=numpy.uint8)
        if random.randint(2):
            values[:, 3] = random.choice([0, 1, 100, 255], count)
        if colors["kind"] == "rgb":
            values = numpy.ascontiguousarray(values[:, :3])
    elif colors["kind"] == "table":
        values = random.uniform(-0.1, 1.1, count).astype(numpy.float32)
        if colors["nan"]:
            values[::3] = numpy.nan
    else:
        return
    array = numpy_to_vtk(values, deep=True)
    array.SetName("colors")
    data.SetScalars(array)


def _output(source, **values):
    for name, value in values.items():
        getattr(source, "Set" + name)(value)
    source.Update()
    return source.GetOutput()


def _sphere(shape, _random):
    return _output(vtkSphereSource(), Radius=shape["size"], ThetaResolution=shape["resolution"],
                   PhiResolution=shape["resolution"])


def _quad(size, z, resolution=1):
    return _output(vtkPlaneSource(), Origin=(-size, -size, z), Point1=(size, -size, z), Point2=(-size, size, z),
                   XResolution=resolution, YResolution=resolution)


def _coincident(shape, random):
    """Quads in one plane, and some so near that depths may be equal."""
    append = vtkAppendPolyData()
    for _ in range(random.randint(2, 5)):
        append.AddInputData(_quad(shape["size"], random.choice([0.0, 0.0, 1e-8, 1e-7, 1e-6, 1e-3])))
    return _output(append)


def _torus(shape, _random):
    torus = vtkParametricTorus()
    torus.SetRingRadius(shape["size"])
    torus.SetCrossSectionRadius(0.4 * shape["size"])
    return _output(vtkParametricFunctionSource(), ParametricFunction=torus, UResolution=2 * shape["resolution"],
                   VResolution=shape["resolution"], WResolution=3)


def _cells(random, points, lengths, setter):
    mesh = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(points.astype(numpy.float32), deep=True))
    mesh.SetPoints(coordinates)
    cells = vtkCellArray()
    for length in lengths:
        ids = vtkIdList()
        for point in random.choice(len(points), length, replace=False):
            ids.InsertNextId(int(point))
        cells.InsertNextCell(ids)
    getattr(mesh, setter)(cells)
    return mesh


def _soup(shape, random):
    """Triangles through each other, some without an area."""
    points = random.uniform(-shape["size"], shape["size"], (12, 3))
    points[3] = points[2]
    return _cells(random, points, [3] * random.randint(1, 20), "SetPolys")


def _lines(shape, random):
    points = random.uniform(-shape["size"], shape["size"], (10, 3))
    return _cells(random, points, random.randint(2, 6, random.randint(1, 8)), "SetLines")


def _vertices(shape, random):
    points = random.uniform(-shape["size"], shape["size"], (20, 3))
    points[5] = points[4]
    return _cells(random, points, [1] * 18, "SetVerts")


def _tube(shape, random):
    ends = random.uniform(-shape["size"], shape["size"], (2, 3))
    line = _output(vtkLineSource(), Point1=ends[0], Point2=ends[1])
    return _output(vtkTubeFilter(), InputData=line, Radius=0.15, NumberOfSides=shape["resolution"],
                   Capping=bool(random.randint(2)))


def _strips(shape, random):
    triangles = _output(vtkTriangleFilter(), InputData=_sphere(shape, random))
    return _output(vtkStripper(), InputData=triangles)


_SHAPES = {
    "sphere": _sphere,
    "plane": lambda shape, random: _quad(shape["size"], 0.0, random.randint(1, 4)),
    "grid": lambda shape, random: _quad(shape["size"], 0.0, 12),
    "coincident": _coincident,
    "cube": lambda shape, random: _output(vtkCubeSource(), XLength=shape["size"], YLength=shape["size"],
                                          ZLength=1.5 * shape["size"]),
    "cone": lambda shape, random: _output(vtkConeSource(), Radius=0.5, Height=shape["size"],
                                          Resolution=shape["resolution"]),
    "torus": _torus,
    "soup": _soup,
    "lines": _lines,
    "vertices": _vertices,
    "tube": _tube,
    "disc": lambda shape, random: _output(vtkDiskSource(), OuterRadius=shape["size"], InnerRadius=0.1,
                                          CircumferentialResolution=shape["resolution"]),
    "strips": _strips,
    "empty": lambda shape, random: vtkPolyData(),
}
