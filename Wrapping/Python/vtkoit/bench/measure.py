# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of several methods, interleaved: what one costs, and its picture.

A method's first frames compile its shaders and find the size of its buffers; they are not timed. Its
picture is that of the scene's own camera, before and after all other frames. Then the methods take turns, a frame each, and before each
frame the camera turns a little, so that nothing of the last one can be used. Last, a few frames with a
still camera. Times run until glFinish() returns.

Other work on the machine disturbs all methods alike in a round; what is reported are medians, and
ratios of medians over the same rounds. `cpu` counts the time of all cores.
"""

import collections
import gc

import numpy

from ..errors import capture
from ..picture import grab
from . import machine

Settings = collections.namedtuple("Settings", "frames budget turn longest")
Settings.__doc__ = """frames: int, timed frames of a method. budget: float, seconds of timed frames after which
a method stops, with 3 frames at least, or 1 when a single frame takes longer. turn: float, degrees of the
camera a frame. longest: float, seconds of a frame after which a method is left out of deeper scenes of a
family."""

Measured = collections.namedtuple("Measured", "timing statistics colors alpha reason")
Measured.__doc__ = """timing: dict, as from timing(), or None when the method did not run. statistics: a
contenders.Statistics, or None. colors: list of arrays of uint8, height x width x 3: the picture before and
after all frames. alpha: array of uint8, height x width, over a transparent background, or None. reason: str,
why it did not run, or why another method drew in its place; empty for neither."""

REFERENCE = "blend"  # what ratios refer to; always among those that run
# Bytes of a pixel in the most expensive method's buffers and the window's own, and of a triangle.
_PIXEL_BYTES = 800
_TRIANGLE_BYTES = 80


def groups(names, pixels, triangles, memory=None):
    """Lists of names that fit into memory together, each with the reference first.

    names: list of str. pixels, triangles: int, of the scene. memory: bytes, default half of what
    is free.
    """
    memory = machine.available_bytes() // 2 if memory is None else memory
    each = pixels * _PIXEL_BYTES + triangles * _TRIANGLE_BYTES
    room = max(1, int(memory // max(1, each)) - 1)
    others = [name for name in names if name != REFERENCE]
    return [[REFERENCE] + others[i:i + room] for i in range(0, max(1, len(others)), room)]


def measure(stage, names, settings, progress):
    """Yields (name, Measured) in a Stage for a list of names, of which the first is the reference."""
    scene = stage.facts()["scene"]
    contenders = []
    try:
        for name in names:
            progress.show("%s: %s" % (scene, name))
            reason = stage.why_not(name)
            if reason:
                yield name, Measured(None, None, [], None, reason)
                continue
            contenders.append(_Entrant(name, stage, settings))
        running = [entrant for entrant in contenders if not entrant.reason]
        with capture():
            for entrant in running:
                progress.show("%s: %s" % (scene, entrant.name))
                entrant.warm_up()
        _take_turns(scene, running, settings, progress)
        for entrant in contenders:
            yield entrant.name, entrant.result(running)
    finally:
        for entrant in contenders:
            entrant.contender.close()
        gc.collect()


def _take_turns(name, running, settings, progress):
    rounds = settings.frames
    with capture():
        for number in range(rounds):
            progress.show("%s: frame %d of %d" % (name, number + 1, rounds), number / rounds)
            for entrant in running[::-1] if number % 2 else running:
                entrant.take_turn(number)
        for number in range(max(2, rounds // 3)):
            progress.show("%s: still frame" % name)
            for entrant in running:
                entrant.stand_still(number)
        for entrant in running:
            entrant.look_again()


class _Entrant:
    """A contender with what was measured of it."""

    def __init__(self, name, stage, settings):
        self.name = name
        self.settings = settings
        self.times = []
        self.gpu = []
        self.still = []
        self.most_bytes = 0
        self.colors = []
        self.alpha = self.statistics = self.camera = None
        with capture() as captured:
            self.contender = stage.contender(name)
            self.first = self.contender.render()[0]
            self._look()
        self.reason = captured.errors(1)

    def _look(self):
        if self.first < 0.5 * self.settings.budget:
            self.first = self.contender.render()[0]
        self.colors = [grab(self.contender.window)[..., :3]]
        self.camera = self.contender.renderer.GetActiveCamera().NewInstance()
        self.camera.DeepCopy(self.contender.renderer.GetActiveCamera())
        self.statistics = self.contender.statistics()
        if self.first < 1.5 * self.settings.budget:
            background = self.contender.renderer.GetBackgroundAlpha()
            self.contender.renderer.SetBackgroundAlpha(0.0)
            self.contender.render()
            self.alpha = grab(self.contender.window)[..., 3]
            self.contender.renderer.SetBackgroundAlpha(background)

    def warm_up(self):
        """Turns to and fro, so that what a turning camera needs is there before times are taken."""
        if self.first < 0.3 * self.settings.budget:
            for turns in (2, -4, 2):
                self.contender.turn(turns * self.settings.turn)
                self.contender.render()

    def _may(self, times):
        least = 3 if self.first < self.settings.budget else 1
        return len(times) < least or sum(t for t, _ in times) < self.settings.budget

    def take_turn(self, number):
        if len(self.times) == number and self._may(self.times):
            self.contender.turn(self.settings.turn)
            self.times.append(self.contender.render())
            if self.contender.gpu_seconds is not None:
                self.gpu.append(self.contender.gpu_seconds)
            told = self.contender.statistics()
            if told is not None:
                self.most_bytes = max(self.most_bytes, told.bytes)

    def stand_still(self, number):
        if self.first > self.settings.budget:
            return
        if number == 0:
            # What a method keeps of a still scene, it has after some frames.
            for _ in range(3):
                self.contender.render()
        if len(self.still) == number and (
                number < 2 or sum(t for t, _ in self.still) < 0.25 * self.settings.budget):
            self.still.append(self.contender.render())

    def look_again(self):
        """The picture again, for errors that come with what is kept from frame to frame."""
        if self.first < self.settings.budget:
            camera = self.contender.renderer.GetActiveCamera()
            camera.DeepCopy(self.camera)
            camera.Modified()  # DeepCopy() does not tell
            self.contender.render()
            self.colors.append(grab(self.contender.window)[..., :3])

    def result(self, running):
        if self.reason:
            return Measured(None, None, [], None, self.reason)
        reference = next(e for e in running if e.name == REFERENCE)
        statistics = self.statistics
        if statistics is not None:
            statistics = statistics._replace(bytes=max(statistics.bytes, self.most_bytes))
        result = timing(self.times, self.still, reference.times)
        result["gpu_ms"] = 1000.0 * float(numpy.median(self.gpu)) if self.gpu else None
        return Measured(result, statistics, self.colors, self.alpha, self.contender.why_other())


def timing(times, still, reference):
    """What is reported of a method's frames, dict of float: ms and its quartiles, of all cores, with
    a still camera, and as ratios to the reference.

    times, still, reference: lists of (seconds, seconds of all cores); a frame of times and the
    reference's frame of the same number are from the same round.
    """
    values = 1000.0 * numpy.array(times, dtype=float)
    same = 1000.0 * numpy.array(reference, dtype=float)[:len(values)]
    values = values[:len(same)] if len(same) else values
    median, cpu = numpy.median(values, axis=0)
    low, high = numpy.percentile(values[:, 0], [25, 75])
    base, base_cpu = numpy.median(same, axis=0)
    return {
        "frames": len(values),
        "ms": float(median),
        "ms_low": float(low),
        "ms_high": float(high),
        "cpu_ms": float(cpu),
        "still_ms": float(1000.0 * numpy.median([t for t, _ in still])) if still else None,
        "ratio": float(median / base),
        "cpu_ratio": float(cpu / base_cpu) if base_cpu > 0.0 else None,
        "fps": float(1000.0 / median),
    }
