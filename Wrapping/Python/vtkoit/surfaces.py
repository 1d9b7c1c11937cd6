# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""From any VTK data to the surfaces that are drawn."""

import collections

from vtkmodules.vtkFiltersCore import (
    vtkCellDataToPointData,
    vtkContourFilter,
    vtkFlyingEdges3D,
    vtkPolyDataNormals,
)
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.util.numpy_support import vtk_to_numpy

from .errors import Error, capture
from .read import Input, leaves

Surface = collections.namedtuple("Surface", "name data kind value")
Surface.__doc__ = """name (str, for messages), data (vtkPolyData), kind ("mesh", "isosurface" or
"label"), value (float: isovalue or label; None for a mesh)."""

Request = collections.namedtuple("Request", "isovalues contour labels smoothing")
Request.__doc__ = """What to make of volumes: isovalues (list of float or None), contour (str, name of
the array or None), labels (None, or list of int, empty for all), smoothing (int, iterations)."""


def make_surfaces(inputs, request, progress, are_volumes=False):
    """The surfaces of what was read: (list of Surface, list of str with what was chosen for the user).

    inputs: list of read.Input. are_volumes: bool, whether image data is drawn as volumes already, and gives
    surfaces only where the request has some. Raises Error when nothing comes out.
    """
    if are_volumes and request.isovalues is None and request.labels is None:
        inputs = [Input(name, leaf) for item in inputs for name, leaf in leaves(item.data, item.name)
                  if not (leaf.IsA("vtkImageData") and is_volume(leaf))]
        if not inputs:
            return [], []
    surfaces = []
    notes = []
    for item in inputs:
        for label, leaf in leaves(item.data, item.name):
            surfaces += _of_leaf(label, leaf, request, notes, progress)
    surfaces = [surface for surface in surfaces if surface.data.GetNumberOfCells()]
    if not surfaces:
        raise Error(_why_empty(inputs, request))
    return surfaces, notes


def _of_leaf(name, data, request, notes, progress):
    if data.IsA("vtkHyperTreeGrid"):
        from vtkmodules.vtkFiltersHyperTree import vtkHyperTreeGridGeometry

        data = _run(vtkHyperTreeGridGeometry(), data, name, progress)
    if not data.IsA("vtkDataSet"):
        raise Error("%s: holds a %s, which has no surface" % (name, data.GetClassName()))
    if data.IsA("vtkPolyData"):
        return [Surface(name, _with_normals(data, name, progress), "mesh", None)]
    if request.labels is not None and not is_volume(data):
        notes.append("%s: not a volume, drawn as it is; --labels is for volumes" % name)
    elif request.labels is not None:
        return _labels(name, data, request, progress)
    if request.isovalues is not None:
        return _isosurfaces(name, data, request, request.isovalues, progress)
    if is_volume(data) and data.GetPointData().GetNumberOfArrays() + \
            data.GetCellData().GetNumberOfArrays() > 0:
        return _default(name, data, request, notes, progress)
    return [Surface(name, _with_normals(_outside(data, name, progress), name, progress),
                    "mesh", None)]


def is_volume(data):
    """Whether a vtkDataSet is a grid of samples in three dimensions along the axes."""
    return (data.IsA("vtkImageData") or data.IsA("vtkRectilinearGrid")) and \
        min(data.GetDimensions()) > 1


def _default(name, data, request, notes, progress):
    """What is drawn of a volume when the user does not say."""
    from .labels import label_values, looks_like_labels
    from .otsu import thresholds

    prepared, array = field(name, data, request.contour)
    if data.IsA("vtkImageData") and looks_like_labels(array):
        notes.append("%s: few whole numbers, drawn as the %d labels of %s (--isosurface V draws "
                     "isosurfaces)" % (name, len(label_values(array)), array.GetName()))
        return _labels(name, data, request._replace(labels=[]), progress)
    isovalues = thresholds(vtk_to_numpy(array))
    if not isovalues:
        raise Error("%s: all values of %s are %g, there is no isosurface"
                    % (name, array.GetName(), array.GetRange()[0]))
    isovalues = [float("%.4g" % value) for value in isovalues]
    notes.append("%s: isosurfaces at %s, chosen by Otsu's method (%s ranges from %g to %g); "
                 "--isosurface V sets them"
                 % (name, " and ".join("%g" % v for v in isovalues), array.GetName(),
                    *array.GetRange()))
    return _isosurfaces(name, data, request, isovalues, progress)


def _labels(name, data, request, progress):
    from .labels import label_surface, label_values

    if not data.IsA("vtkImageData"):
        raise Error("%s: --labels needs a volume with constant spacing, not a %s"
                    % (name, data.GetClassName()))
    prepared, array = field(name, data, request.contour, points_only=False)
    found = label_values(array) if not request.labels else request.labels
    result = []
    for label in found:
        surface = label_surface(prepared, array, label, request.smoothing, progress)
        if surface is None:
            raise Error("%s: no sample has the label %d; there are: %s" % (
                name, label, " ".join(str(value) for value in label_values(array))))
        result.append(Surface("%s label %d" % (name, label), surface, "label", float(label)))
    return result


def _isosurfaces(name, data, request, isovalues, progress):
    prepared, array = field(name, data, request.contour)
    result = []
    for value in isovalues:
        fast = data.IsA("vtkImageData") and min(data.GetDimensions()) > 1
        contour = vtkFlyingEdges3D() if fast else vtkContourFilter()
        if fast:
            contour.InterpolateAttributesOn()
        contour.SetInputArrayToProcess(0, 0, 0, 0, array.GetName())
        contour.SetComputeScalars(True)
        contour.SetComputeNormals(fast)
        contour.SetValue(0, value)
        text = "isosurface %g of %s" % (value, name)
        surface = _run(contour, prepared, text, progress)
        surface = _with_normals(surface, text, progress, feature_angle=180)
        result.append(Surface(text, surface, "isosurface", value))
    return result


def field(name, data, contour, points_only=True):
    """(data with point arrays, the vtkDataArray of its points to contour), vectors as magnitudes."""
    prepared = data.NewInstance()
    prepared.ShallowCopy(data)
    wanted = contour
    if wanted is None:
        wanted = _first_array(data)
    if wanted is None:
        raise Error("%s: has no scalars to draw isosurfaces of" % name)
    if not prepared.GetPointData().HasArray(wanted):
        if not prepared.GetCellData().HasArray(wanted):
            raise Error("%s: has no array %s; it has: %s" % (name, wanted, array_list([data])))
        to_points = vtkCellDataToPointData()
        to_points.PassCellDataOn()
        prepared = _run(to_points, prepared, name, None)
    array = prepared.GetPointData().GetArray(wanted)
    if array is None:
        raise Error("%s: the array %s holds no numbers" % (name, wanted))
    if array.GetNumberOfComponents() > 1:
        array = _magnitude(array)
        prepared.GetPointData().AddArray(array)
    prepared.GetPointData().SetActiveScalars(array.GetName())
    return prepared, array


def _first_array(data):
    """The name of the array that a data set offers first: active scalars, points before cells."""
    for attributes in (data.GetPointData(), data.GetCellData()):
        if attributes.GetScalars() is not None:
            array = attributes.GetScalars()
            if array.GetName() is None:
                array.SetName("scalars")
            return array.GetName()
    for attributes in (data.GetPointData(), data.GetCellData()):
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetArray(i)
            if array is not None and array.GetName():
                return array.GetName()
    return None


def _magnitude(array):
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk

    values = vtk_to_numpy(array).astype(float)
    result = numpy_to_vtk(numpy.sqrt((values ** 2).sum(axis=1)), deep=True)
    result.SetName("magnitude of %s" % array.GetName())
    return result


def array_list(data_sets):
    """The names of all arrays of data sets as one str, "none" without any."""
    names = []
    for data in data_sets:
        for attributes in (data.GetPointData(), data.GetCellData()):
            for i in range(attributes.GetNumberOfArrays()):
                names.append(attributes.GetArrayName(i))
    return ", ".join(dict.fromkeys(n for n in names if n)) or "none"


def _outside(data, name, progress):
    return _run(vtkDataSetSurfaceFilter(), data, "surface of " + name, progress)


def _with_normals(data, name, progress, feature_angle=60):
    """The vtkPolyData with point normals; those that it has are kept. feature_angle: degrees."""
    if data.GetPointData().GetNormals() is not None or \
            data.GetNumberOfPolys() + data.GetNumberOfStrips() == 0:
        return data
    normals = vtkPolyDataNormals()
    normals.SetFeatureAngle(feature_angle)
    normals.SetSplitting(feature_angle < 180)
    return _run(normals, data, "normals of " + name, progress)


def _run(algorithm, data, text, progress):
    """The output of an algorithm for data, kept when the algorithm goes. Raises Error."""
    algorithm.SetInputData(data)
    if progress is not None:
        progress.watch(algorithm, text)
    with capture() as captured:
        algorithm.Update()
    if captured.errors(1):
        raise Error("%s: %s" % (text, captured.errors(1)))
    return algorithm.GetOutput()


def _why_empty(inputs, request):
    names = ", ".join(item.name for item in inputs)
    ranges = []
    for item in inputs:
        for _, leaf in leaves(item.data):
            if request.isovalues is not None and leaf.IsA("vtkDataSet"):
                wanted = request.contour or _first_array(leaf)
                array = leaf.GetPointData().GetArray(wanted) or leaf.GetCellData().GetArray(wanted)
                if array is not None:
                    low, high = array.GetRange(0 if array.GetNumberOfComponents() == 1 else -1)
                    ranges.append("%s ranges from %g to %g" % (wanted, low, high))
    if ranges:
        return "%s: no surface at the isovalues given; %s" % (names, ranges[0])
    return "%s: holds nothing that can be drawn" % names
