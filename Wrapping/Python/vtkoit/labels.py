# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""One closed surface for each label of a label volume."""

import numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, VTK_DOUBLE
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkWindowedSincPolyDataFilter
from vtkmodules.vtkFiltersGeneral import vtkDiscreteFlyingEdges3D
from vtkmodules.vtkImagingCore import vtkExtractVOI, vtkImageConstantPad
from vtkmodules.util.numpy_support import vtk_to_numpy

from .errors import Error

# More labels than this are a volume of measured values, not of labels.
MOST_LABELS = 256


def looks_like_labels(array):
    """Whether a vtkDataArray of a volume holds few distinct whole numbers, most often in runs."""
    if array.GetNumberOfComponents() != 1 or array.GetDataType() in (VTK_FLOAT, VTK_DOUBLE):
        return False
    values = vtk_to_numpy(array)
    if len(numpy.unique(values)) > 40:
        return False
    # Neighbours differ little in a measurement, and jump or are equal in a segmentation.
    return float(numpy.mean(values[1:] == values[:-1])) > 0.9


def label_values(array):
    """The labels of a vtkDataArray without the background 0, sorted list of int. Raises Error."""
    if array.GetNumberOfComponents() != 1:
        raise Error("--labels: the array %s has %d components, labels have one"
                    % (array.GetName(), array.GetNumberOfComponents()))
    values = vtk_to_numpy(array)
    if values.dtype.kind == "f" and not numpy.array_equal(values, numpy.rint(values)):
        raise Error("--labels: the array %s holds fractions, labels are whole numbers; "
                    "use --isosurface" % array.GetName())
    found = [int(value) for value in numpy.unique(values) if value != 0]
    if len(found) > MOST_LABELS:
        raise Error("--labels: the array %s has %d different values, more than %d labels; "
                    "name some: --labels 1 2 3, or use --isosurface"
                    % (array.GetName(), len(found), MOST_LABELS))
    return found


def label_surface(image, array, label, smoothing, progress):
    """The surface between a label and everything else, vtkPolyData with normals.

    image: vtkImageData with array (vtkDataArray of its points). label: int. smoothing: int,
    iterations of a windowed sinc filter, which moves no point by more than about a voxel; 0 for
    the voxels' own steps.
    """
    dimensions = image.GetDimensions()
    inside = (vtk_to_numpy(array) == label).reshape(dimensions[::-1])
    if not inside.any():
        return None
    extent = _extent(inside, image.GetExtent())
    crop = vtkExtractVOI()
    crop.SetInputData(image)
    crop.SetVOI(*extent)
    # A label at the border of the volume is closed there.
    pad = vtkImageConstantPad()
    pad.SetInputConnection(crop.GetOutputPort())
    pad.SetConstant(label + 1 if label + 1 <= array.GetDataTypeMax() else label - 1)
    pad.SetOutputWholeExtent(*[n + (1 if i % 2 else -1) for i, n in enumerate(extent)])
    contour = vtkDiscreteFlyingEdges3D()
    contour.SetInputConnection(pad.GetOutputPort())
    contour.SetInputArrayToProcess(0, 0, 0, 0, array.GetName())
    contour.ComputeNormalsOff()
    contour.ComputeGradientsOff()
    contour.ComputeScalarsOff()
    contour.SetValue(0, label)
    last = contour
    if smoothing > 0:
        smooth = vtkWindowedSincPolyDataFilter()
        smooth.SetInputConnection(last.GetOutputPort())
        smooth.SetNumberOfIterations(smoothing)
        smooth.SetPassBand(0.05)
        smooth.FeatureEdgeSmoothingOff()
        smooth.NonManifoldSmoothingOn()
        smooth.NormalizeCoordinatesOn()
        last = smooth
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(last.GetOutputPort())
    normals.SetFeatureAngle(60 if smoothing == 0 else 120)
    normals.ConsistencyOff()
    progress.begin("surface of label %d" % label)
    progress.watch(contour, "surface of label %d" % label)
    normals.Update()
    return normals.GetOutput()


def _extent(inside, whole):
    """The extent of the True samples of an array (z, y, x), one sample wider where there are."""
    result = []
    for axis in range(3):
        other = tuple(n for n in range(3) if n != 2 - axis)
        where = numpy.nonzero(inside.any(axis=other))[0]
        low = whole[2 * axis]
        result += [max(low, low + int(where[0]) - 1),
                   min(whole[2 * axis + 1], low + int(where[-1]) + 1)]
    return result
