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


def place(renderer, spec="iso", up=(0, 0, 1), zoom=1.0, parallel=False):
    """Places the camera of a vtkRenderer so that all its props are in the picture.

    spec: as from parse(). up: axis that points up in the picture. zoom: float, above 1 for closer.
    parallel: bool, parallel projection.
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
        # ResetCamera() fits the sphere around the bounds into the picture, with room to spare.
        camera.Zoom(1.25)
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()


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
