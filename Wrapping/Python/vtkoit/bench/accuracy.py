# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of a picture against the truth, over the pixels that translucent props cover."""

import collections
import math

import numpy

Errors = collections.namedtuple("Errors", "max rmse psnr p99 over0 over1 over8")
Errors.__doc__ = """In steps of 8 bits, 1/255: max and p99 (of the largest channel's error of each pixel) and rmse
(of all channels), float; psnr, float in decibels, None for no error. Erroneous pixels in percent, float:
over0 (another 8-bit value than the nearest one: more than half a step), over1 and over8 (more than 1 and 8
steps), in any channel."""

# What rounding to 8 bits leaves, and float32 arithmetic on top.
HALF_STEP = 0.5 + 1e-3


def measure(pixels, truth, covered):
    """The Errors of a picture.

    pixels: array of uint8, height x width x channels. truth: float array of that shape, in [0, 1].
    covered: bool array, height x width; all errors are 0 where no pixel is.
    """
    error = numpy.abs(pixels[covered].astype(float) - 255.0 * numpy.clip(truth[covered], 0.0, 1.0))
    if not error.size:
        return Errors(0.0, 0.0, None, 0.0, 0.0, 0.0, 0.0)
    error = error.reshape(len(error), -1)
    worst = error.max(axis=1)
    rmse = math.sqrt((error ** 2).mean())
    return Errors(
        max=float(worst.max()), rmse=rmse,
        psnr=20.0 * math.log10(255.0 / rmse) if rmse > 0.0 else None,
        p99=float(numpy.percentile(worst, 99.0)),
        over0=100.0 * float((worst > HALF_STEP).mean()),
        over1=100.0 * float((worst > 1.0 + 1e-3).mean()),
        over8=100.0 * float((worst > 8.0 + 1e-3).mean()))


def frontier(points):
    """Which points no other one beats in both coordinates: indices in ascending order of the first
    coordinate, list of int. points: list of (cost, error), float."""
    best = math.inf
    result = []
    for i in sorted(range(len(points)), key=lambda i: (points[i], i)):
        if points[i][1] < best:
            best = points[i][1]
            result.append(i)
    return result
