# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Image data drawn as volumes: what is seen of them, and how."""

import collections
import math

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkVolume, vtkVolumeProperty

from . import colors
from .errors import Error
from .labels import looks_like_labels
from .otsu import thresholds
from .read import leaves
from .surfaces import field, is_volume

Volume = collections.namedtuple("Volume", "name data opacities length shade nearest")
Volume.__doc__ = """name (str, for messages), data (vtkImageData whose active scalars are drawn), opacities (list of
(value, opacity), float, ascending), length (float, of a path that has these opacities), shade (bool, lit by
the gradient) and nearest (bool: labels, which have nothing in between)."""

Request = collections.namedtuple("Request", "array opacities length shade")
Request.__doc__ = """What to make of image data: array (str, its name, or None for the active scalars), opacities (list
of (value, opacity), or None for a choice by the histogram), length (float, or None for a hundredth of the
diagonal), shade (bool)."""

# Along a ray, of the smallest spacing: a hair more than 2, or rays along an axis lose their last sample to rounding.
SAMPLES_PER_VOXEL = 2.0002

# Of the middle one of Otsu's three classes, and of the largest values: half a diagonal through the former lets a
# third of the light through, a tenth of it through the latter none.
_MIDDLE, _HIGHEST = 0.02, 0.2
_LABELS = 0.05

_HELP = "give VALUE:OPACITY in ascending order of the values, opacities from 0 to 1, such as 500:0 1150:0.2"


def parse_opacities(texts):
    """The points of --opacity-function, list of (value, opacity), float, of a list of str. Raises Error."""
    result = []
    for text in ",".join(texts).split(","):
        try:
            value, opacity = (float(part) for part in text.split(":"))
        except ValueError:
            raise Error("--opacity-function: %r is not VALUE:OPACITY; %s" % (text, _HELP)) from None
        if not math.isfinite(value) or not 0.0 <= opacity <= 1.0:
            raise Error("--opacity-function %s: %s" % (text, _HELP))
        if result and value <= result[-1][0]:
            raise Error("--opacity-function %s: comes after %g; %s" % (text, result[-1][0], _HELP))
        result.append((value, opacity))
    return result


def make_volumes(inputs, request):
    """The volumes of what was read: (list of Volume, list of str with what was chosen for the user).

    inputs: list of read.Input. Raises Error when none holds image data, or nothing of it could be seen.
    """
    result, notes, others = [], [], []
    for item in inputs:
        for name, leaf in leaves(item.data, item.name):
            if leaf.IsA("vtkImageData") and is_volume(leaf):
                result.append(_make(name, leaf, request, notes))
            else:
                others.append("%s holds a %s" % (name, leaf.GetClassName()))
    if not result:
        raise Error("--volume is for image data with samples in three dimensions; %s" % others[0])
    return result, notes


def _make(name, data, request, notes):
    data, array = field(name, data, request.array)
    array = _finite(name, array, notes)
    data.GetPointData().SetScalars(array)
    low, high = array.GetRange(0)
    length = request.length or data.GetLength() / 100.0
    nearest = looks_like_labels(array)
    opacities = request.opacities
    if opacities is None:
        opacities, how = _choose(name, array, nearest)
        notes.append("%s: a volume with the opacities %s for every %.3g of length, %s (%s ranges from %g to %g); "
                     "--opacity-function sets them"
                     % (name, " ".join("%g:%g" % point for point in opacities), length, how,
                        array.GetName(), low, high))
    volume = Volume(name, data, opacities, length, request.shade, nearest)
    if visible_range(volume) is None:
        raise Error("%s: nothing of it would be seen: all opacities are 0 where %s is, from %g to %g"
                    % (name, array.GetName(), low, high))
    return volume


def _finite(name, array, notes):
    """The vtkDataArray, or a copy whose values that are not numbers are the smallest."""
    values = vtk_to_numpy(array)
    if values.dtype.kind != "f":
        return array
    finite = numpy.isfinite(values)
    if finite.all():
        return array
    if not finite.any():
        raise Error("%s: the array %s holds no finite number" % (name, array.GetName()))
    notes.append("%s: %d values of %s are not finite, drawn as the smallest one"
                 % (name, (~finite).sum(), array.GetName()))
    result = numpy_to_vtk(numpy.where(finite, values, values[finite].min()), deep=True)
    result.SetName(array.GetName())
    return result


def _choose(name, array, is_labels):
    """(points of the opacity function, how they were chosen) when the user gives none."""
    low, high = array.GetRange(0)
    if is_labels and high > 0:
        return [(0.0, 0.0), (1.0, _LABELS)], "all labels but 0 alike"
    found = [float("%.4g" % value) for value in thresholds(vtk_to_numpy(array))]
    if not found:
        raise Error("%s: all values of %s are %g; give --opacity-function" % (name, array.GetName(), low))
    middle = float("%.4g" % (0.5 * (found[0] + found[1])))
    points = [(found[0], 0.0), (middle, _MIDDLE), (found[1], _MIDDLE), (high, _HIGHEST)]
    # Thresholds may be the same when they are rounded, or the largest value.
    points = [point for i, point in enumerate(points) if i == 0 or point[0] > points[i - 1][0]]
    return points, "chosen by Otsu's method"


def visible_range(volume):
    """(low, high): the values of a Volume between which some have an opacity above 0; None where none has."""
    low, high = volume.data.GetPointData().GetScalars().GetRange(0)
    values = sorted({low, high, *(value for value, _ in volume.opacities if low < value < high)})
    function = _opacity_function(volume)
    seen = [i for i, value in enumerate(values) if function.GetValue(value) > 0.0]
    if not seen:
        return None
    return values[max(0, seen[0] - 1)], values[min(len(values) - 1, seen[-1] + 1)]


def _opacity_function(volume):
    function = vtkPiecewiseFunction()
    for value, opacity in volume.opacities:
        function.AddPoint(value, opacity)
    return function


def actor_of(volume, colormap, limits=None, distance=None):
    """A new vtkVolume for a Volume. colormap: str. limits: (low, high), the values at the colour map's two
    ends, or None for those that are seen. distance: float, between samples along a ray, or None for
    SAMPLES_PER_VOXEL."""
    import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401, registers the mapper of OpenGL
    from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

    # Not a vtkSmartVolumeMapper, which takes samples as far apart as it likes.
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(volume.data)
    mapper.SetBlendModeToComposite()
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(distance or min(volume.data.GetSpacing()) / SAMPLES_PER_VOXEL)
    material = vtkVolumeProperty()
    material.SetScalarOpacity(_opacity_function(volume))
    material.SetColor(colors.transfer_function(colormap, *(limits or visible_range(volume))))
    material.SetScalarOpacityUnitDistance(volume.length)
    material.SetShade(volume.shade)
    material.SetAmbient(0.2)
    material.SetDiffuse(0.8)
    material.SetSpecular(0.1)
    if not volume.nearest:
        material.SetInterpolationTypeToLinear()
    actor = vtkVolume()
    actor.SetMapper(mapper)
    actor.SetProperty(material)
    return actor
