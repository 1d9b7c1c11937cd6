# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What volumes and translucent surfaces look like together, by the definition, in double precision on the CPU. Nothing of
it is VTK's or vtkOIT's: rays are made of the camera's numbers, surfaces are formulas, and light is integrated between
one surface and the next, not at the places where a mapper takes samples.

    dC/dt = T kappa(s) c(s),   dT/dt = -T kappa(s),   kappa = -log(1 - opacity(s)) / unit

with the value s interpolated linearly between samples of the volume, and opacity and colour linearly between the points
of their functions. At a surface of opacity a: C += T a c, T *= 1 - a.
"""

import collections
import itertools

import numpy

Camera = collections.namedtuple("Camera", "position focal up parallel scale angle near far")
Camera.__doc__ = """position, focal, up: (x, y, z). parallel: bool. scale: float, half the picture's height, parallel.
angle: float, degrees of the picture's height, in perspective. near, far: float, along the line of sight."""

Cloud = collections.namedtuple("Cloud", "values origin spacing opacity color unit")
Cloud.__doc__ = """A volume. values: array, z x y x x. origin, spacing: (x, y, z). opacity: list of (value, opacity of a path of
length unit). color: list of (value, red, green, blue)."""

Square = collections.namedtuple("Square", "center normal half color opacity")
Square.__doc__ = """A square. center: (x, y, z). normal: (x, y, z), of length 1. half: float, half the length of a side. Its sides
are those of side_directions()."""

Ball = collections.namedtuple("Ball", "center radius color opacity")
Ball.__doc__ = "The surface of a ball, seen from both sides. center: (x, y, z). radius: float."


def side_directions(normal):
    """The directions of a Square's sides, two arrays."""
    normal = numpy.asarray(normal, dtype=float)
    helper = numpy.array([0.0, 1.0, 0.0] if abs(normal[1]) < 0.9 else [1.0, 0.0, 0.0])
    first = numpy.cross(helper, normal)
    first /= numpy.linalg.norm(first)
    return first, numpy.cross(normal, first)


def picture(camera, size, cloud, surfaces, background=(0, 0, 0, 1), opaque=(), samples=400):
    """(pixels, certain): array, height x width x 4, premultiplied, top row first; and bool array, height x width, False where the outline of a surface, or a line where two of them cross, is in a pixel or beside it.

    size: (width, height). cloud: Cloud or None. background: (r, g, b, a), premultiplied. surfaces, opaque: lists of Square or Ball; opacities of the latter do not
    count. samples: int, of a ray between one surface and the next.
    """
    start, direction, first, last = _rays(camera, size)
    number = len(start)
    depths, colors, opacities, faces = _hits(start, direction, [*surfaces], first, last)
    closest, behind, opaque_faces = _closest(start, direction, opaque, first, last, background)
    # Near the line where two surfaces cross, triangles and formulas may differ in which is in front.
    before = [one < other for one, other in itertools.combinations([*depths, closest], 2)]
    hidden = depths >= closest
    depths = numpy.where(hidden, numpy.inf, depths)
    order = numpy.argsort(depths, axis=0, kind="stable")
    depths = numpy.take_along_axis(depths, order, axis=0)
    opacities = numpy.take_along_axis(opacities, order, axis=0)
    colors = numpy.take_along_axis(colors, order[..., None], axis=0)
    color, transmittance = numpy.zeros((number, 4)), numpy.ones(number)
    end = numpy.minimum(closest, last)
    here = first
    for i in range(len(depths) + 1):
        until = numpy.minimum(depths[i], end) if i < len(depths) else end
        if cloud is not None:
            color, transmittance = _march(cloud, start, direction, here, until, color, transmittance, samples)
        if i < len(depths):
            share = numpy.where(numpy.isfinite(depths[i]), opacities[i], 0.0)
            color = color + (transmittance * share)[:, None] * colors[i]
            transmittance = transmittance * (1.0 - share)
            here = numpy.where(numpy.isfinite(depths[i]), depths[i], end)
    color = color + transmittance[:, None] * behind
    shape = (size[1], size[0])
    certain = _certain([*faces, *opaque_faces, *before], shape)
    return color.reshape(*shape, 4), certain


def _rays(camera, size):
    """(start, direction, distance of the near and of the far plane) of the rays through the pixels' centres."""
    width, height = size
    position, focal, up = (numpy.array(v, dtype=float) for v in (camera.position, camera.focal, camera.up))
    ahead = focal - position
    ahead /= numpy.linalg.norm(ahead)
    right = numpy.cross(ahead, up)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(right, ahead)
    row, column = numpy.mgrid[0:height, 0:width]
    y = (1.0 - 2.0 * (row + 0.5) / height).ravel()[:, None]
    x = ((2.0 * (column + 0.5) / width - 1.0) * width / height).ravel()[:, None]
    if camera.parallel:
        start = position + camera.scale * (x * right + y * up)
        direction = numpy.broadcast_to(ahead, start.shape)
    else:
        half = numpy.tan(numpy.radians(0.5 * camera.angle))
        direction = ahead + half * (x * right + y * up)
        direction = direction / numpy.linalg.norm(direction, axis=1)[:, None]
        start = numpy.broadcast_to(position, direction.shape)
    along = direction @ ahead
    return start, direction, camera.near / along, camera.far / along


def _hits(start, direction, surfaces, first, last):
    """(distances, colours, opacities, bool: hit) of all surfaces, arrays with a row each hit; inf for none."""
    depths, colors, opacities, faces = [], [], [], []
    for surface in surfaces:
        for distance in _ball(start, direction, surface) if isinstance(surface, Ball) \
                else [_square(start, direction, surface)]:
            distance = numpy.where((distance >= first) & (distance <= last), distance, numpy.inf)
            depths.append(distance)
            faces.append(numpy.isfinite(distance))
            colors.append(numpy.tile([*map(float, surface.color), 1.0], (len(direction), 1)))
            opacities.append(numpy.full(len(direction), float(surface.opacity)))
    number = len(direction)
    return (numpy.array(depths).reshape(-1, number), numpy.array(colors).reshape(-1, number, 4),
            numpy.array(opacities).reshape(-1, number), numpy.array(faces, dtype=bool).reshape(-1, number))


def _square(start, direction, square):
    with numpy.errstate(divide="ignore", invalid="ignore"):
        distance = ((numpy.asarray(square.center) - start) @ numpy.asarray(square.normal)) / (direction @ numpy.asarray(square.normal))
        place = start + distance[:, None] * direction - numpy.asarray(square.center)
        inside = [abs(place @ side) <= square.half for side in side_directions(square.normal)]
        return numpy.where(inside[0] & inside[1] & numpy.isfinite(distance), distance, numpy.inf)


def _ball(start, direction, ball):
    away = start - numpy.asarray(ball.center)
    along = (away * direction).sum(axis=1)
    square = along ** 2 - (away ** 2).sum(axis=1) + ball.radius ** 2
    root = numpy.sqrt(numpy.maximum(square, 0.0))
    return [numpy.where(square > 0.0, -along + sign * root, numpy.inf) for sign in (-1, 1)]


def _closest(start, direction, opaque, first, last, background):
    """(distance, colour, faces) of the first opaque surface; inf and the background for none."""
    depths, colors, _, faces = _hits(start, direction, [*opaque], first, last)
    closest = numpy.full(len(direction), numpy.inf)
    behind = numpy.tile(numpy.array(background, dtype=float), (len(direction), 1))
    for depth, color in zip(depths, colors):
        behind = numpy.where((depth < closest)[:, None], color, behind)
        closest = numpy.minimum(closest, depth)
    return closest, behind, faces


def _march(cloud, start, direction, begin, end, color, transmittance, samples):
    """(colour, transmittance) after the way from begin to end through a Cloud, arrays of distances."""
    low = numpy.asarray(cloud.origin, dtype=float)
    high = low + numpy.asarray(cloud.spacing) * (numpy.array(cloud.values.shape[::-1]) - 1)
    with numpy.errstate(divide="ignore"):
        to_low, to_high = (low - start) / direction, (high - start) / direction
    enter = numpy.fmax(begin, numpy.minimum(to_low, to_high).max(axis=1))
    leave = numpy.fmin(end, numpy.maximum(to_low, to_high).min(axis=1))
    length = numpy.maximum(leave - enter, 0.0)
    crossed = numpy.nonzero(length > 0.0)[0]
    if not len(crossed):
        return color, transmittance
    color, transmittance = color.copy(), transmittance.copy()
    part, left = numpy.zeros((len(crossed), 4)), transmittance[crossed].copy()
    step = length[crossed] / samples
    for i in range(samples):
        place = start[crossed] + (enter[crossed] + (i + 0.5) * step)[:, None] * direction[crossed]
        value = _interpolate(cloud, place)
        opacity = numpy.interp(value, *numpy.array(cloud.opacity, dtype=float).T)
        points = numpy.array(cloud.color, dtype=float).T
        there = [numpy.interp(value, points[0], points[1 + c]) for c in range(3)]
        there = numpy.stack([*there, numpy.ones(len(value))], axis=1)
        through = (1.0 - opacity) ** (step / cloud.unit)
        part += (left * (1.0 - through))[:, None] * there
        left *= through
    color[crossed] += part
    transmittance[crossed] = left
    return color, transmittance


def _interpolate(cloud, place):
    """The values of a Cloud at places, array n x 3, linear in each direction between the samples."""
    shape = numpy.array(cloud.values.shape[::-1])
    index = (place - numpy.asarray(cloud.origin)) / numpy.asarray(cloud.spacing)
    index = numpy.clip(index, 0.0, shape - 1.0)
    cell = numpy.minimum(index.astype(int), shape - 2)
    weight = index - cell
    result = numpy.zeros(len(place))
    for corner in numpy.ndindex(2, 2, 2):
        x, y, z = (cell + corner).T
        share = numpy.where(corner, weight, 1.0 - weight).prod(axis=1)
        result += share * cloud.values[z, y, x]
    return result


def _certain(faces, shape):
    """Where all pixels around a pixel are alike. faces: list of bool arrays, of pixels."""
    result = numpy.ones(shape, dtype=bool)
    for face in faces:
        face = numpy.pad(face.reshape(shape), 1, mode="edge")
        around = [face[i:i + shape[0], j:j + shape[1]] for i in range(3) for j in range(3)]
        result &= numpy.all(around, axis=0) | ~numpy.any(around, axis=0)
    return result
