# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where the camera stands, from what the user says."""

import math
import re

from .errors import Error

_AXES = {"x": (1, 0, 0), "-x": (-1, 0, 0), "y": (0, 1, 0), "-y": (0, -1, 0), "z": (0, 0, 1),
         "-z": (0, 0, -1)}
_AXES.update({"+" + name: axis for name, axis in list(_AXES.items()) if len(name) == 1})

HELP = ("from where to look: x, -x, y, -y, z, -z (along an axis), iso, AZIMUTH,ELEVATION in degrees, "
        "a direction X,Y,Z, or nine numbers: position, focal point, view up")


def axis(text):
    """The unit vector of a str such as x or -z, tuple of int. Raises Error."""
    if text not in _AXES:
        raise Error("--up %s: give one of %s" % (text, " ".join(sorted(_AXES))))
    return _AXES[text]


def parse(text):
    """What --camera says: a str such as iso, or a tuple of 2, 3 or 9 floats. Raises Error."""
    if text == "iso" or text in _AXES:
        return text
    try:
        numbers = tuple(float(part) for part in re.split(r"[,/]", text))
    except ValueError:
        numbers = ()
    if len(numbers) not in (2, 3, 9) or not all(math.isfinite(n) for n in numbers) or \
            (len(numbers) == 3 and not any(numbers)):
        raise Error("--camera %s: give x, -x, y, -y, z, -z, iso, AZIMUTH,ELEVATION, X,Y,Z or nine "
                    "numbers" % text)
    if len(numbers) == 9 and (numbers[:3] == numbers[3:6] or not any(numbers[6:])):
        raise Error("--camera %s: position and focal point are the same, or view up is zero" % text)
    return numbers


def place(renderer, spec="iso", up=(0, 0, 1), zoom=1.0, parallel=False, aspect=1.0):
    """Places the camera of a vtkRenderer so that all its props fill the picture.

    spec: as from parse(). up: axis that points up in the picture. zoom: float, above 1 for closer.
    parallel: bool, parallel projection. aspect: float, width of the picture by its height.
    """
    camera = renderer.GetActiveCamera()
    camera.SetParallelProjection(parallel)
    if isinstance(spec, tuple) and len(spec) == 9:
        camera.SetPosition(*spec[:3])
        camera.SetFocalPoint(*spec[3:6])
        camera.SetViewUp(*spec[6:])
        renderer.ResetCameraClippingRange()
    else:
        direction, view_up = _direction(spec, up)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetPosition(*direction)
        camera.SetViewUp(*view_up)
        renderer.ResetCamera()
        _fit(renderer, aspect)
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()


def _fit(renderer, aspect, margin=0.05):
    """Moves and zooms so that the box around all props fills the picture up to a margin."""
    camera = renderer.GetActiveCamera()
    bounds = renderer.ComputeVisiblePropBounds()
    if bounds[0] > bounds[1]:
        return
    for _ in range(4):  # moving changes the perspective a little
        matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)
        places = [_project(matrix, bounds[i], bounds[2 + j], bounds[4 + k])
                  for i in (0, 1) for j in (0, 1) for k in (0, 1)]
        low = [min(place[axis] for place in places) for axis in (0, 1)]
        high = [max(place[axis] for place in places) for axis in (0, 1)]
        inverse = matrix.NewInstance()
        inverse.DeepCopy(matrix)
        inverse.Invert()
        # The point of the focal plane in the middle of the box's picture becomes the focal point.
        depth = _project(matrix, *camera.GetFocalPoint())[2]
        center = _project(inverse, 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), depth)
        shift = [c - f for c, f in zip(center, camera.GetFocalPoint())]
        camera.SetFocalPoint(*center)
        camera.SetPosition(*[p + s for p, s in zip(camera.GetPosition(), shift)])
        size = max(0.5 * (high[0] - low[0]), 0.5 * (high[1] - low[1])) / (1.0 - margin)
        if camera.GetParallelProjection():
            camera.SetParallelScale(camera.GetParallelScale() * size)
        else:
            half = math.tan(math.radians(camera.GetViewAngle()) / 2.0) * size
            camera.SetViewAngle(math.degrees(2.0 * math.atan(half)))


def _project(matrix, x, y, z):
    """A point through a vtkMatrix4x4, divided by its fourth coordinate."""
    result = matrix.MultiplyPoint((x, y, z, 1.0))
    return [value / result[3] for value in result[:3]]


def _direction(spec, up):
    """(direction towards the camera, view up)."""
    if spec == "iso":
        spec = (-60.0, 25.0)
    if isinstance(spec, str):
        direction = _AXES[spec]
    elif len(spec) == 2:
        direction = _turned(math.radians(spec[0]), math.radians(spec[1]), up)
    else:
        direction = spec
    # Of any length: squares of what is very long or short are not numbers of the computer.
    longest = max(abs(d) for d in direction)
    direction = tuple(d / longest for d in direction)
    # Looking along the axis that points up, another one must.
    length = math.sqrt(sum(d * d for d in direction))
    along = abs(sum(d * u for d, u in zip(direction, up))) / length
    if along > 0.999:
        up = (0, 1, 0) if abs(up[1]) == 0 else (0, 0, -up[1])
    return direction, up


def _turned(azimuth, elevation, up):
    """The direction at an azimuth around the axis up, and an elevation above its plane."""
    # The two axes that follow up in the cycle x, y, z.
    third = max(range(3), key=lambda i: abs(up[i]))
    result = [0.0, 0.0, 0.0]
    result[(third + 1) % 3] = math.cos(elevation) * math.cos(azimuth)
    result[(third + 2) % 3] = math.cos(elevation) * math.sin(azimuth) * up[third]
    result[third] = math.sin(elevation) * up[third]
    return tuple(result)
