# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The right picture of a scene: the fragments that the A-buffer captured, sorted and composited in
double precision on the CPU."""

import collections

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray

from ..errors import Error, capture
from ..picture import grab

Truth = collections.namedtuple("Truth", "color alpha covered source fragments layers cross_check")
Truth.__doc__ = """color: float array, height x width x 3, in [0, 1], over the scene's background. alpha: float
array, height x width, over a transparent background. covered: bool array, height x width, where
translucent props are. source: str, "fragments" or "abuffer". fragments, layers: int, of all pixels and of the
deepest one. cross_check: float, the largest difference to `peel` in steps of 8 bits, or None."""

# More fragments are not copied: 100 bytes each while they are sorted.
LARGEST = 24000000
# Fragments that `peel` may draw, over all its passes, for the cross-check.
LARGEST_CROSS_CHECK = 200000000

METHOD = "abuffer:FragmentPrecision=float,SkipHiddenFragments=0"
CROSS_CHECK = "peel:TransmittanceThreshold=0"


def composite(fragments, shape, background):
    """Fragments composited over a background in float64.

    fragments: array n x 7 in any order, each x, y (from below), depth, r, g, b, opacity, as from
    vtkOITABufferPass.GetFragments(). shape: (height, width). background: array, height x width x
    4, premultiplied, top row first. Fragments of a pixel with the same depth form a group, whose
    opacity is 1 - prod(1 - a), and whose colour is the mean weighted by opacity. Returns (pixels,
    layers): float array, height x width x 4, premultiplied, and int array, height x width.
    """
    height, width = shape
    fragments = numpy.asarray(fragments, dtype=numpy.float32)
    row = height - 1 - fragments[:, 1].astype(numpy.int64)
    pixel = row * width + fragments[:, 0].astype(numpy.int64)
    # The bits of floats that are not negative sort as the floats do.
    depth = numpy.ascontiguousarray(fragments[:, 2] + numpy.float32(0)).view(numpy.uint32)
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
        raise Error("no truth for the scene: %s" % captured.errors(1))
    return vtk_to_numpy(values).reshape(-1, 7) if done else numpy.zeros((0, 7), numpy.float32)


def find(stage):
    """The Truth of a Stage. Raises Error where the A-buffer does not run."""
    width, height = stage.size
    with capture():
        contender = stage.contender(METHOD)
        contender.render()
        contender.render()
    if contender.missing():
        raise Error("the truth needs the method abuffer: %s" % contender.missing())
    told = contender.statistics()
    behind = stage.behind(contender.renderer.GetBackgroundAlpha())
    covering = stage.behind(0.0)[..., 3:]
    if told.fragments <= LARGEST:
        fragments = fragments_of(contender.oit)
        pixels, layers = composite(
            fragments, (height, width), numpy.dstack([behind[..., :3], covering]) / 255.0)
        result = Truth(pixels[..., :3].astype(numpy.float32), pixels[..., 3].astype(numpy.float32),
                       layers > 0, "fragments", told.fragments, told.layers, None)
    else:
        color = grab(contender.window)
        contender.renderer.SetBackgroundAlpha(0.0)
        contender.render()
        alpha = grab(contender.window)[..., 3]
        covered = (color != behind).any(axis=2) | (alpha != covering[..., 0])
        result = Truth((color[..., :3] / 255.0).astype(numpy.float32),
                       (alpha / 255.0).astype(numpy.float32), covered, "abuffer", told.fragments,
                       told.layers, None)
    contender.close()
    if told.fragments * max(1, told.layers) <= LARGEST_CROSS_CHECK:
        result = result._replace(cross_check=_cross_check(stage, result))
    return result


def _cross_check(stage, truth):
    """The largest difference of the method `peel` to the truth, float, in steps of 8 bits."""
    with capture():
        contender = stage.contender(CROSS_CHECK)
        contender.render()
        pixels = grab(contender.window)
        contender.close()
    difference = numpy.abs(pixels[..., :3] - 255.0 * numpy.clip(truth.color, 0.0, 1.0))
    return float(difference[truth.covered].max(initial=0.0))
