# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Work in a child process: some of VTK's readers crash, and some never end, on a corrupt file.

The child ends when the parent does, whatever ends it. While a file is read, a timer of the system ends
the child, also in the middle of C++ code, which nothing in Python could interrupt.
"""

import contextlib
import ctypes
import mmap
import os
import signal

# What asks a process to end; what is ignored here, as by nohup, stays so.
FORWARDED = (signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGQUIT)
_SET_DEATH_SIGNAL = 1  # PR_SET_PDEATHSIG of Linux's prctl
_NOTE_BYTES = 4096

_note = None  # of the child: memory that the parent sees, with the name of what is read
_limit = 0.0  # seconds, 0 for none


class Ended(Exception):
    """The child was ended by a signal: number (int), and reading (str), the name of the file that it
    was reading then, empty for none."""

    def __init__(self, number, reading):
        super().__init__(number, reading)
        self.number = number
        self.reading = reading


def run(work, read_timeout):
    """Runs a function without arguments in a child process; what it returns, int, an exit status.

    read_timeout: float, seconds for each reading() block, 0 for no limit. Signals that ask this process
    to end go on to the child. Raises Ended.
    """
    note = mmap.mmap(-1, _NOTE_BYTES)
    forwarded = [number for number in FORWARDED if signal.getsignal(number) != signal.SIG_IGN]
    signal.pthread_sigmask(signal.SIG_BLOCK, forwarded)
    parent = os.getpid()
    child = os.fork()
    if child == 0:
        status = 1
        try:
            _become_child(parent, note, read_timeout, forwarded)
            status = work()
        finally:
            os._exit(status)

    def forward(number, _frame):
        os.kill(child, number)

    before = {number: signal.signal(number, forward) for number in forwarded}
    signal.pthread_sigmask(signal.SIG_UNBLOCK, forwarded)
    try:
        _, status = os.waitpid(child, 0)
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    if os.WIFSIGNALED(status):
        raise Ended(os.WTERMSIG(status), bytes(note[:]).rstrip(b"\0").decode("utf-8", "replace"))
    return os.WEXITSTATUS(status)


def _become_child(parent, note, read_timeout, forwarded):
    global _note, _limit  # pylint: disable=global-statement
    _note, _limit = note, read_timeout
    # Python's own handlers would wait for the end of C++ code.
    for number in (*forwarded, signal.SIGALRM):
        signal.signal(number, signal.SIG_DFL)
    with contextlib.suppress(OSError, AttributeError):
        ctypes.CDLL(None).prctl(_SET_DEATH_SIGNAL, signal.SIGKILL)
    if os.getppid() != parent:  # it ended before it could be told to take the child along
        os._exit(1)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, forwarded)


@contextlib.contextmanager
def reading(name):
    """Bounds the time of the with block, in which the file name (str) is read; does nothing in a
    process that run() has not made."""
    if _note is None:
        yield
        return
    _write(name)
    signal.setitimer(signal.ITIMER_REAL, _limit)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        _write("")


def _write(name):
    text = name.encode("utf-8", "replace")[:_NOTE_BYTES]
    _note[:] = text + bytes(_NOTE_BYTES - len(text))
