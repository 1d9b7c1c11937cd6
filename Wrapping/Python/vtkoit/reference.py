# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The right picture of fragments: sorted and composited in double precision, on the CPU."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray

from .errors import Error, capture


def composite(fragments, shape, background):
    """Fragments composited over a background in float64.

    fragments: array n x 7 in any order, each x, y (from below), depth, r, g, b, opacity, as from
    vtkOITABufferPass.GetFragments(); depths count in float32. shape: (height, width). background: array, height x width x
    4, premultiplied, top row first. Fragments of a pixel with the same depth form a group, whose
    opacity is 1 - prod(1 - a), and whose colour is the mean weighted by opacity. Returns (pixels,
    layers): float array, height x width x 4, premultiplied, and int array, height x width.
    """
    height, width = shape
    fragments = numpy.asarray(fragments)
    row = height - 1 - fragments[:, 1].astype(numpy.int64)
    pixel = row * width + fragments[:, 0].astype(numpy.int64)
    # The bits of floats that are not negative sort as the floats do.
    depth = (fragments[:, 2].astype(numpy.float32) + numpy.float32(0)).view(numpy.uint32)
    key = (pixel.astype(numpy.uint64) << numpy.uint64(32)) | depth
    order = numpy.argsort(key, kind="stable")
    key = key[order]
    layers = numpy.bincount(pixel, minlength=height * width)
    pixels = numpy.zeros((height * width, 4))
    transmittance = numpy.ones(height * width)
    if len(order):
        start = numpy.nonzero(numpy.concatenate([[True], key[1:] != key[:-1]]))[0]
        alpha = fragments[order, 6].astype(float)
        opacity = 1.0 - numpy.multiply.reduceat(1.0 - alpha, start)
        weight = numpy.add.reduceat(alpha, start)
        color = numpy.stack([
            numpy.add.reduceat(alpha * fragments[order, 3 + c], start) for c in range(3)], axis=1)
        color /= numpy.where(weight > 0.0, weight, 1.0)[:, None]
        where = (key[start] >> numpy.uint64(32)).astype(numpy.int64)
        for chosen in _by_rank(where, height * width):
            here = where[chosen]
            share = transmittance[here] * opacity[chosen]
            pixels[here, :3] += share[:, None] * color[chosen]
            pixels[here, 3] += share
            transmittance[here] *= 1.0 - opacity[chosen]
    pixels += transmittance[:, None] * numpy.asarray(background, dtype=float).reshape(-1, 4)
    return pixels.reshape(height, width, 4), layers.reshape(shape)


def _by_rank(pixel, number):
    """Yields the indices of the first entries of all pixels, then of the second ones, and so on.
    pixel: int array, ascending. number: int, of pixels."""
    count = numpy.bincount(pixel, minlength=number)
    first = numpy.concatenate([[0], numpy.cumsum(count)[:-1]])
    rank = numpy.arange(len(pixel)) - first[pixel]
    order = numpy.argsort(rank, kind="stable")
    bounds = numpy.cumsum(numpy.bincount(rank))
    begin = 0
    for end in bounds:
        yield order[begin:end]
        begin = end


def fragments_of(abuffer):
    """The captured fragments of a vtkOITABufferPass, float32 array n x 7. Raises Error."""
    values = vtkFloatArray()
    with capture() as captured:
        done = abuffer.GetFragments(values)
    if not done and abuffer.GetNumberOfFragments() > 0:
        raise Error("the fragments cannot be read: %s" % captured.errors(1))
    return vtk_to_numpy(values).reshape(-1, 7) if done else numpy.zeros((0, 7), numpy.float32)
