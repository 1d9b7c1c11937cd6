# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Standard output and error of the command line, also where they are closed, full, or another encoding."""

import codecs
import io
import os
import sys

from .errors import printable


class _Output(io.FileIO):
    """Standard output that remembers the first error. It goes on after it, so that the work is done,
    unless who reads it has left."""

    trouble = None

    def write(self, data):
        try:
            return super().write(data)
        except OSError as error:
            self.trouble = self.trouble or error
            if isinstance(error, BrokenPipeError):
                raise
            return len(data)


def _escape(error):
    text = printable(error.object[error.start:error.end])
    return text.encode("ascii", "backslashreplace").decode("ascii"), error.end


codecs.register_error("vtkoit", _escape)
_output = None


def prepare():
    """Makes the three standard streams usable, before any file is opened.

    A closed one would give its number to the next file that is opened, into which libraries would
    print then. What an encoding lacks is written as escapes.
    """
    global _output  # pylint: disable=global-statement
    for number, mode in ((0, os.O_RDONLY), (1, os.O_RDONLY), (2, os.O_WRONLY)):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, mode)  # the lowest number that is free: this one
    # Writing to what is open for reading fails, as it does where there is nothing.
    encoding = sys.stdout.encoding if sys.stdout else "utf-8"
    _output = _Output(1, "w", closefd=False)
    sys.stdout = io.TextIOWrapper(io.BufferedWriter(_output), encoding, "vtkoit",
                                  line_buffering=_output.isatty())
    if sys.stderr is None:
        sys.stderr = open(2, "w", encoding="utf-8", errors="backslashreplace", closefd=False)


def finish():
    """Writes out what was printed; the OSError that kept any of it from being written, or None."""
    try:
        sys.stdout.flush()
    except OSError:
        # So that Python does not complain again at its end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    trouble = _output and _output.trouble
    if trouble is not None:
        _output.trouble = None
    return trouble


def complain(text):
    """Writes a str to standard error; nothing where that cannot be done."""
    try:
        sys.stderr.write(text)
        sys.stderr.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)


def clear_line():
    """Takes away the line of progress that a process which was ended may have left on a terminal."""
    if sys.stderr.isatty():
        complain("\r\x1b[K")
