# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Rasterisation of triangles in double precision by the rules of OpenGL, on the CPU: fragments that no
graphics library has touched, to check those that the A-buffer captures.

A fragment is where a pixel's centre is inside a triangle; a centre on an edge belongs to one of the
triangles that share it. Depth is interpolated in window space, normals in perspective.
"""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

# Centres tested at once: bounds the memory, about 200 bytes each.
_CHUNK = 1000000


# Graphics hardware rounds the corners of triangles to 1/256 of a pixel. So triangles thinner than
# this many pixels may come out turned over, and silhouettes on either side of a centre this close.
_DOUBT = 1.0 / 64.0

# Two fragments closer than this in window depth may swap: some units of a 24-bit depth.
_DEPTH_TOLERANCE = 5e-7


def rasterize(renderer, size):
    """(fragments, certain) of a vtkRenderer, which should have no other light than a headlight.

    size: (width, height), pixels. Drawn are its visible actors with vtkPolyDataMapper and
    triangles: their colour, opacity, ambient and diffuse coefficients, with point normals where
    they have them. Not scalars, textures, lines, specular light or clipping by the near plane.
    fragments: float array, n x 7, as for vtkoit.reference.composite(). certain: bool array, height x
    width: False where rounding decides what is seen: with the pixel's centre within 1/64 pixel of a
    silhouette or an open edge, on triangles thinner than that, and where two unlike fragments are
    too close to tell their order.
    """
    width, height = size
    none = numpy.zeros(0, dtype=int)
    parts = [(none, numpy.zeros(0), numpy.zeros((0, 3)), numpy.zeros(0), none)]
    actors = renderer.GetActors()
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        actor = actors.GetNextActor()
        if actor.GetVisibility() and actor.GetProperty().GetOpacity() > 0.0:
            parts.append(_of_actor(actor, renderer.GetActiveCamera(), size))
    pixel, depth, color, alpha, doubtful = [numpy.concatenate(part) for part in zip(*parts)]
    certain = numpy.ones(height * width, dtype=bool)
    certain[doubtful] = False
    order = numpy.lexsort((depth, pixel))
    both = numpy.c_[color, alpha][order]
    close = (numpy.diff(pixel[order]) == 0) & (numpy.diff(depth[order]) < _DEPTH_TOLERANCE)
    unlike = numpy.abs(numpy.diff(both, axis=0)).max(axis=1, initial=0.0) > 0.01
    certain[pixel[order][1:][close & unlike]] = False
    row = height - 1 - pixel // width
    return (numpy.c_[pixel % width, row, depth, color, alpha], certain.reshape(height, width))


def _of_actor(actor, camera, size):
    """(pixel, depth, color, alpha, doubtful) of a vtkActor: pixel (int array, n; row * width + column,
    rows from the top), depth (float array, n; smaller is closer), color (float array, n x 3) and alpha
    (float array, n) of its fragments, and doubtful (int array), the pixels that rounding decides.
    """
    points, normals, triangles = _geometry(actor)
    if not len(triangles):
        none = numpy.zeros(0, dtype=int)
        return none, numpy.zeros(0), numpy.zeros((0, 3)), numpy.zeros(0), none
    view, clip = _matrices(camera, size[0] / size[1])
    eye = numpy.c_[points, numpy.ones(len(points))] @ view.T
    position = eye @ clip.T
    w = position[:, 3]
    window = numpy.c_[(position[:, 0] / w + 1.0) * 0.5 * size[0],
                      (position[:, 1] / w + 1.0) * 0.5 * size[1],
                      (position[:, 2] / w + 1.0) * 0.5]
    triangle, column, row, weights = _cover(window, triangles, size)
    lines = numpy.concatenate([triangles[_thickness(window, triangles) < _DOUBT],
                               _silhouettes(window, triangles)])
    _, near_column, near_row, _ = _cover(window, lines, size, _DOUBT)
    doubtful = (size[1] - 1 - near_row) * size[0] + near_column
    corners = triangles[triangle]
    depth = (weights * window[corners, 2]).sum(axis=1)
    inside = (depth >= 0.0) & (depth <= 1.0)
    triangle, column, row = triangle[inside], column[inside], row[inside]
    weights, corners, depth = weights[inside], corners[inside], depth[inside]

    # Perspective: what is linear on the triangle, divided by w, is linear in the window.
    weights = weights / w[corners]
    weights /= weights.sum(axis=1)[:, None]
    color = _shade(actor.GetProperty(), _normals(normals, eye, view, triangles, triangle,
                                                 corners, weights), window, triangles, triangle)
    pixel = (size[1] - 1 - row) * size[0] + column
    alpha = numpy.full(len(pixel), actor.GetProperty().GetOpacity())
    return pixel, depth, color, alpha, doubtful


def _geometry(actor):
    """(points n x 3 in the world, normals n x 3 or None, triangles m x 3 of point numbers)."""
    mapper = actor.GetMapper()
    mapper.Update()
    data = mapper.GetInput()
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float) \
        if data.GetNumberOfPoints() else numpy.zeros((0, 3))
    normals = data.GetPointData().GetNormals()
    normals = None if normals is None else vtk_to_numpy(normals).astype(float)
    polys = data.GetPolys()
    connectivity = vtk_to_numpy(polys.GetConnectivityArray())
    offsets = vtk_to_numpy(polys.GetOffsetsArray())
    # Polygons of n points are n - 2 triangles around their first point, as VTK draws convex ones.
    sizes = numpy.diff(offsets)
    number = numpy.maximum(sizes - 2, 0)
    polygon = numpy.repeat(numpy.arange(len(sizes)), number)
    local = numpy.arange(number.sum()) - numpy.repeat(numpy.cumsum(number) - number, number)
    start = offsets[:-1][polygon]
    triangles = numpy.stack([connectivity[start], connectivity[start + local + 1],
                             connectivity[start + local + 2]], axis=1) \
        if len(polygon) else numpy.zeros((0, 3), dtype=int)
    matrix = _array(actor.GetMatrix())
    points = points @ matrix[:3, :3].T + matrix[:3, 3]
    if normals is not None:
        normals = normals @ numpy.linalg.inv(matrix[:3, :3])
    return points, normals, triangles


def _array(matrix):
    """A vtkMatrix4x4 as an array."""
    return numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def _matrices(camera, aspect):
    view = _array(camera.GetViewTransformMatrix())
    return view, _array(camera.GetProjectionTransformMatrix(aspect, -1.0, 1.0))


def _thickness(window, triangles):
    """The smallest height of triangles in pixels, float array; 0 for a triangle without area."""
    corners = window[triangles][:, :, :2]
    sides = numpy.roll(corners, -1, axis=1) - corners
    area = numpy.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    longest = numpy.linalg.norm(sides, axis=2).max(axis=1)
    return area / numpy.where(longest > 0, longest, 1.0)


def _front(window, triangles):
    """Which triangles are seen from their front, bool array."""
    a, b, c = (window[triangles[:, i], :2] for i in range(3))
    return (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) > (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])


def _silhouettes(window, triangles):
    """The edges of one triangle only, or between front and back: n x 3, triangles without area."""
    edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    key = edges[:, 0].astype(numpy.int64) * len(window) + edges[:, 1]
    _, first, number, count = numpy.unique(
        key, return_index=True, return_inverse=True, return_counts=True)
    fronts = numpy.bincount(number.ravel(), weights=numpy.repeat(_front(window, triangles), 3))
    found = edges[first[(count == 1) | ((fronts > 0) & (fronts < count))]]
    return found[:, [0, 1, 1]]


def _cover(window, triangles, size, around=0.0):
    """Which centres are in which triangles: (triangle, column, row, weights n x 3), rows from the
    bottom. around: float, pixels; above 0 centres outside by less count too."""
    corners = window[triangles][:, :, :2]
    low = numpy.ceil(corners.min(axis=1) - 0.5 - around).astype(int)
    high = numpy.floor(corners.max(axis=1) - 0.5 + around).astype(int)
    low = numpy.maximum(low, 0)
    high = numpy.minimum(high, numpy.array(size) - 1)
    extent = numpy.maximum(high - low + 1, 0)
    number = extent[:, 0] * extent[:, 1]
    candidates = numpy.nonzero(number)[0]
    parts = []
    for chosen in _chunks(candidates, number[candidates]):
        count = number[chosen]
        triangle = numpy.repeat(chosen, count)
        local = numpy.arange(count.sum()) - numpy.repeat(numpy.cumsum(count) - count, count)
        column = low[triangle, 0] + local % extent[triangle, 0]
        row = low[triangle, 1] + local // extent[triangle, 0]
        weights, inside = _weights(corners[triangle], column + 0.5, row + 0.5)
        if around > 0.0:
            inside = _near(corners[triangle], column + 0.5, row + 0.5, around)
        parts.append((triangle[inside], column[inside], row[inside], weights[inside]))
    if not parts:
        none = numpy.zeros(0, dtype=int)
        return none, none, none, numpy.zeros((0, 3))
    return tuple(numpy.concatenate(values) for values in zip(*parts))


def _chunks(candidates, number):
    """The candidates in groups of about _CHUNK centres."""
    if not len(candidates):
        return []
    group = numpy.cumsum(number) // _CHUNK
    return numpy.split(candidates, numpy.nonzero(numpy.diff(group))[0] + 1)


def _weights(corners, x, y):
    """Barycentric weights (n x 3) of points in triangles (n x 3 x 2), and which are inside."""
    edges = numpy.stack([_edge(corners[:, (i + 1) % 3], corners[:, (i + 2) % 3], x, y)
                         for i in range(3)], axis=1)
    area = edges.sum(axis=1)
    sign = numpy.where(area < 0, -1.0, 1.0)
    edges *= sign[:, None]
    # A centre on an edge is inside when the edge runs up, or is horizontal and runs to the left:
    # of the two triangles that share the edge this holds for one.
    vectors = (numpy.roll(corners, -2, axis=1) - numpy.roll(corners, -1, axis=1)) \
        * sign[:, None, None]
    owned = (vectors[..., 1] > 0) | ((vectors[..., 1] == 0) & (vectors[..., 0] < 0))
    inside = ((edges > 0) | ((edges == 0) & owned)).all(axis=1) & (area != 0)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        return edges / numpy.abs(area)[:, None], inside


def _edge(start, end, x, y):
    """Twice the signed area of (start, end, point); of opposite sign, to the bit, from end to start."""
    swap = (end[:, 0] < start[:, 0]) | ((end[:, 0] == start[:, 0]) & (end[:, 1] < start[:, 1]))
    first = numpy.where(swap[:, None], end, start)
    second = numpy.where(swap[:, None], start, end)
    value = (second[:, 0] - first[:, 0]) * (y - first[:, 1]) \
        - (second[:, 1] - first[:, 1]) * (x - first[:, 0])
    return numpy.where(swap, -value, value)


def _near(corners, x, y, distance):
    """Whether points are within a distance of a side of triangles (n x 3 x 2), bool array."""
    result = numpy.zeros(len(x), dtype=bool)
    point = numpy.stack([x, y], axis=1)
    for i in range(3):
        start = corners[:, i]
        side = corners[:, (i + 1) % 3] - start
        length = (side ** 2).sum(axis=1)
        along = ((point - start) * side).sum(axis=1) / numpy.where(length > 0, length, 1.0)
        nearest = start + numpy.clip(along, 0.0, 1.0)[:, None] * side
        result |= ((point - nearest) ** 2).sum(axis=1) <= distance ** 2
    return result


def _normals(normals, eye, view, triangles, triangle, corners, weights):
    """Unit normals of fragments in eye space, n x 3: interpolated, or of the triangles."""
    if normals is None:
        a, b, c = (eye[triangles[:, i], :3] for i in range(3))
        flat = numpy.cross(b - a, c - a)
        result = flat[triangle]
    else:
        turned = normals @ view[:3, :3].T
        result = (weights[:, :, None] * turned[corners]).sum(axis=1)
    length = numpy.linalg.norm(result, axis=1)
    return result / numpy.where(length > 0, length, 1.0)[:, None]


def _shade(material, normal, window, triangles, triangle):
    """Colours n x 3 under a headlight, seen from both sides as in VTK."""
    if not material.GetLighting():
        return numpy.broadcast_to(numpy.array(material.GetDiffuseColor()), (len(normal), 3)).copy()
    facing = numpy.where(_front(window, triangles)[triangle], normal[:, 2], -normal[:, 2])
    diffuse = numpy.maximum(facing, 0.0)[:, None]
    return material.GetAmbient() * numpy.array(material.GetAmbientColor()) \
        + material.GetDiffuse() * diffuse * numpy.array(material.GetDiffuseColor())
