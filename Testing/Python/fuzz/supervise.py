# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a fuzzer's cases in a child, so that a crash or a frame without end is a failure with a seed and
not the end of the run."""

import collections
import json
import os
import select
import signal
import sys

SECONDS = 300  # for one case; they take less than one, and the loaded machines of tests are slow


def run(seeds, case):
    """Calls case(seed) for each of the seeds, in a child. case returns counts by name, dict; a count
    called "failed" is one. Returns the sums, a Counter, with "seeds" besides."""
    sums = collections.Counter()
    waiting = iter(seeds)
    seed = next(waiting, None)
    while seed is not None:
        child = _Child(case)
        while seed is not None:
            counts = child.ask(seed)
            sums["seeds"] += 1
            sums.update(counts or {"failed": 1})
            crashed, seed = seed, next(waiting, None)
            if counts is None:
                print("seed %d: %s" % (crashed, child.end), flush=True)
                break
        child.close()
    return sums


class _Child:
    """A process that answers seeds; forked before anything is drawn, so that it may draw. end: how it
    ended, str, after an answer of None."""

    def __init__(self, case):
        asked, self.questions = os.pipe()
        self.answers, answered = os.pipe()
        sys.stdout.flush()
        self.pid = os.fork()
        if self.pid == 0:
            os.close(self.questions)
            os.close(self.answers)
            _answer(case, asked, answered)
        os.close(asked)
        os.close(answered)
        self.end = ""

    def ask(self, seed):
        os.write(self.questions, b"%d\n" % seed)
        ready, _, _ = select.select([self.answers], [], [], SECONDS)
        line = os.read(self.answers, 4096) if ready else b""
        if line:
            return json.loads(line)
        if ready:
            _, status = os.waitpid(self.pid, 0)
            self.end = "crashed by signal %d" % os.WTERMSIG(status) if os.WIFSIGNALED(status) else \
                "ended with status %d" % os.WEXITSTATUS(status)
        else:
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
            self.end = "no end after %d s" % SECONDS
        self.pid = 0
        return None

    def close(self):
        os.close(self.questions)
        os.close(self.answers)
        if self.pid:
            os.waitpid(self.pid, 0)


def _answer(case, asked, answered):
    """The child: to its end, without what the parent has to do at its own."""
    status = 1
    try:
        with os.fdopen(asked) as questions:
            for line in questions:
                counts = json.dumps(case(int(line)))
                sys.stdout.flush()
                os.write(answered, counts.encode() + b"\n")
        status = 0
    except BaseException:  # noqa: B902 (whatever it is, it must not go on as if it were the parent)
        sys.excepthook(*sys.exc_info())
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)
