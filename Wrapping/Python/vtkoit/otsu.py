# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Isovalues that separate the classes of a volume's values, for those who give none."""

import numpy


def thresholds(values, number=2, bins=128):
    """The thresholds between number + 1 classes of values, by Otsu's method, list of float.

    N. Otsu, A threshold selection method from gray-level histograms, IEEE Trans. SMC 9 (1979):
    the thresholds that maximise the variance between the classes of the histogram.
    values: array of any shape; values that are not finite are left out. number: 1 or 2. Empty when
    all values are equal.
    """
    values = numpy.asarray(values).ravel()
    if values.dtype.kind == "f":
        values = values[numpy.isfinite(values)]
    if values.size == 0 or values.min() == values.max():
        return []
    counts, edges = numpy.histogram(values, bins=bins)
    centers = 0.5 * (edges[1:] + edges[:-1])
    weight = numpy.concatenate([[0.0], numpy.cumsum(counts, dtype=float)])
    moment = numpy.concatenate([[0.0], numpy.cumsum(counts * centers)])

    def between(first, last):
        """Weight times squared mean of the bins first to last - 1, arrays of bin numbers."""
        mass = weight[last] - weight[first]
        total = moment[last] - moment[first]
        return numpy.divide(total ** 2, mass, out=numpy.zeros_like(total), where=mass > 0)

    cut = numpy.arange(1, bins)
    if number == 1:
        best = _middle_of_best(between(0, cut) + between(cut, bins))
        return [float(edges[cut[best[0]]])]
    low, high = cut[:, None], cut[None, :]
    score = between(0, low) + between(low, numpy.maximum(high, low)) + between(high, bins)
    score[high <= low] = -1.0
    best = _middle_of_best(score)
    return [float(edges[cut[best[0]]]), float(edges[cut[best[1]]])]


def _middle_of_best(score):
    """The position of the largest value; of several, as between classes far apart, the middle."""
    best = numpy.argwhere(score >= score.max() * (1.0 - 1e-9))
    return best.mean(axis=0).round().astype(int)
