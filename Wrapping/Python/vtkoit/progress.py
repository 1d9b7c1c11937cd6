# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Progress of work that takes more than a second, on a terminal only."""

import os
import sys
import time


class Progress:
    """Writes "text 45 %" over and over into one line of a terminal's standard error."""

    _DELAY = 1.0  # seconds without a word
    _PERIOD = 0.1  # seconds between two lines

    def __init__(self, stream=None):
        """stream: a text stream; default standard error. Silent unless it is a terminal."""
        stream = sys.stderr if stream is None else stream
        self._fd = None
        if stream.isatty():
            # Its own descriptor: standard error is redirected while readers work.
            self._fd = os.dup(stream.fileno())
        self._start = time.monotonic()
        self._last = 0.0
        self._shown = False

    def watch(self, algorithm, text):
        """Shows the progress of a vtkAlgorithm while it works; text: str, what it does."""
        if self._fd is None:
            return
        self._start = time.monotonic()
        algorithm.AddObserver(
            "ProgressEvent", lambda source, _event: self.show(text, source.GetProgress()))

    def begin(self, text):
        """Starts counting the second for a new piece of work; text: str."""
        self._start = time.monotonic()
        self.show(text)

    def show(self, text, fraction=None):
        """Shows a state of the work: text (str) and, when known, the fraction done in [0, 1]."""
        now = time.monotonic()
        if self._fd is None or now - self._start < self._DELAY or now - self._last < self._PERIOD:
            return
        self._last = now
        self._shown = True
        percent = "" if fraction is None else " %3.0f %%" % (100.0 * fraction)
        self._write("\r\x1b[K%s%s" % (text, percent))

    def clear(self):
        """Takes the line away."""
        if self._shown:
            self._write("\r\x1b[K")
            self._shown = False

    def _write(self, text):
        try:
            os.write(self._fd, text.encode("utf-8", "replace"))
        except OSError:
            self._fd = None
