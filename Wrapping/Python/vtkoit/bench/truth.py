# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The right picture of a scene: the fragments that the A-buffer captured, composited by reference.py, or
the picture of a method that is exact here."""

import collections

import numpy

from ..errors import Error, capture
from ..picture import grab
from ..reference import composite, fragments_of

Truth = collections.namedtuple("Truth", "color alpha covered source fragments layers cross_check")
Truth.__doc__ = """color: float array, height x width x 3, in [0, 1], over the scene's background. alpha: float
array, height x width, over a transparent background. covered: bool array, height x width, where
translucent props or volumes are. source: str, "fragments", or whose picture it is: "abuffer" or "peel", or
"samples" of `abuffer` with FINER times the samples in volumes. fragments, layers: int, of all pixels and of the
deepest one. cross_check: float, the largest difference in steps of 8 bits to `peel`, or with volumes to VTK's dual
depth peeling with as many samples, or None."""

# What a sample of a volume stands for becomes shorter by: VTK's own picture then is within a step or two.
FINER = 8

# More fragments are not copied: 100 bytes each while they are sorted.
LARGEST = 24000000
# Fragments that `peel` may draw, over all its passes, for the cross-check.
LARGEST_CROSS_CHECK = 200000000

# Layers that VTK's dual depth peeling may peel with fine samples, for the cross-check.
LARGEST_DUAL = 8

METHOD = "abuffer:FragmentPrecision=float,SkipHiddenFragments=0,TransmittanceThreshold=0"
PEEL = "peel:TransmittanceThreshold=0"


def find(stage, cross_check=True):
    """The Truth of a Stage; cross_check: bool, whether to compare it with `peel`. Raises Error where no
    method is exact."""
    if stage.has_volumes():
        return _of_samples(stage.finer(FINER), cross_check)
    for source, method in (("abuffer", METHOD), ("peel", PEEL)):
        with capture():
            contender = stage.contender(method)
            contender.render()
            contender.render()
        reason = contender.why_other()
        if not reason:
            break
        contender.close()
    else:
        raise Error("no method can tell the right picture here: %s" % reason)
    told = contender.statistics()
    if source == "abuffer" and told.fragments <= LARGEST:
        result = _of_fragments(stage, contender)
    else:
        result = _of_picture(stage, contender)._replace(source=source)
    contender.close()
    if cross_check and source == "abuffer" and \
            told.fragments * max(1, told.layers) <= LARGEST_CROSS_CHECK:
        result = result._replace(cross_check=_cross_check(stage, result))
    return result


def _of_fragments(stage, contender):
    told = contender.statistics()
    width, height = stage.size
    behind = stage.behind(contender.renderer.GetBackgroundAlpha())
    covering = stage.behind(0.0)[..., 3:]
    fragments = fragments_of(contender.oit)
    pixels, layers = composite(
        fragments, (height, width), numpy.dstack([behind[..., :3], covering]) / 255.0)
    return Truth(pixels[..., :3].astype(numpy.float32), pixels[..., 3].astype(numpy.float32),
                 layers > 0, "fragments", told.fragments, told.layers, None)


def _of_picture(stage, contender):
    told = contender.statistics()
    behind = stage.behind(contender.renderer.GetBackgroundAlpha())
    covering = stage.behind(0.0)[..., 3]
    color = grab(contender.window)
    contender.renderer.SetBackgroundAlpha(0.0)
    contender.render()
    alpha = grab(contender.window)[..., 3]
    covered = (color != behind).any(axis=2) | (alpha != covering)
    return Truth((color[..., :3] / 255.0).astype(numpy.float32),
                 (alpha / 255.0).astype(numpy.float32), covered, "", told.fragments, told.layers, None)


def _of_samples(stage, cross_check):
    """The Truth of a Stage with fine samples in its volumes."""
    with capture() as captured:
        contender = stage.contender(METHOD)
        contender.render()
        contender.render()
    reason = contender.why_other() or captured.errors(1)
    if reason or not contender.statistics().exact:
        raise Error("no method can tell the right picture of these volumes here: %s" % reason)
    result = _of_picture(stage, contender)._replace(source="samples")
    contender.close()
    if cross_check and result.layers <= LARGEST_DUAL:
        result = result._replace(cross_check=_cross_check(stage, result, "vtk-dual"))
    return result


def _cross_check(stage, truth, method=PEEL):
    """The largest difference of a method's picture to the truth, float, in steps of 8 bits."""
    with capture():
        contender = stage.contender(method)
        contender.render()
        pixels = grab(contender.window)
        contender.close()
    difference = numpy.abs(pixels[..., :3] - 255.0 * numpy.clip(truth.color, 0.0, 1.0))
    return float(difference[truth.covered].max(initial=0.0))
