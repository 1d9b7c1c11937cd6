# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of a few contenders in turns, for comparisons of two settings: what a frame costs, and what the
pass tells of it. measure.py has the errors, too, and more care for slow methods."""

import collections

import numpy

from ..errors import Error, capture

Settings = collections.namedtuple("Settings", "frames turn budget")
Settings.__doc__ = """frames: int, timed frames of a contender. turn: float, degrees of the camera before each
frame, 0 for a still one. budget: float, seconds of a contender's timed frames after which there are no more
rounds."""

Taken = collections.namedtuple("Taken", "seconds cpu statistics summary")
Taken.__doc__ = """Of one contender: seconds and cpu (of all cores), arrays of float, one entry a round;
statistics, contenders.Statistics of the last frame or None; summary, str: what its last frame did without."""

# A frame that compiles, two that find out how large buffers are, two more until a still one is reused.
WARM_UP = 5


def take(stage, names, settings, progress):
    """Taken by name, dict, of the contenders names (list of str) in a Stage. Raises Error where one
    cannot draw."""
    contenders = []
    try:
        for name in names:
            contenders.append(stage.contender(name))
        with capture() as captured:
            for contender in contenders:
                spent = 0.0
                for number in range(WARM_UP):
                    if number < 2 or spent < settings.budget or not settings.turn:
                        _turn(contender, settings.turn * (1 if number % 2 else -1))
                        spent += contender.render()[0]
        for contender in contenders:
            reason = contender.missing() or captured.errors(1)
            if reason:
                raise Error("%s: %s" % (contender.name, reason))
        return _take(stage, contenders, settings, progress)
    finally:
        for contender in contenders:
            contender.close()


def _turn(contender, degrees):
    if degrees:  # a turn by 0 degrees is a change of the camera, too
        contender.turn(degrees)


def _take(stage, contenders, settings, progress):
    scene = stage.facts()["scene"]
    times = {contender.name: [] for contender in contenders}
    with capture():
        for number in range(settings.frames):
            progress.show("%s: frame %d of %d" % (scene, number + 1, settings.frames),
                          number / settings.frames)
            for contender in contenders[::-1] if number % 2 else contenders:
                _turn(contender, settings.turn)
                times[contender.name].append(contender.render())
            if max(sum(t for t, _ in mine) for mine in times.values()) > settings.budget:
                break
    result = {}
    for contender in contenders:
        seconds, cpu = numpy.array(times[contender.name], dtype=float).T
        told = getattr(contender.oit, "GetSkipSummary", str)()
        result[contender.name] = Taken(seconds, cpu, contender.statistics(), told)
    return result


def ratio(values, reference):
    """(median, lower quartile, upper quartile) of the ratios in the same rounds, float. values, reference:
    arrays of float."""
    number = min(len(values), len(reference))
    quotients = values[:number] / reference[:number]
    low, middle, high = numpy.percentile(quotients, [25, 50, 75])
    return float(middle), float(low), float(high)
