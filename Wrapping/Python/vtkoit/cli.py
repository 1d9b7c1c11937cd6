# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: python3 -m vtkoit, build/bin/vtkoit."""

import os
import signal
import sys
import traceback

from . import child, streams
from .errors import Error, one_line
from .options import check, joined, parser, without_value
from .values import parse_numbers
from .version import PYTHON_VERSION

# Those that may read files of the user's.
_ISOLATED = ("render", "compare", "bench")


def main(prog="vtkoit", arguments=None):
    """Runs the command line; returns the exit status: 0, 1 for an error, 2 for wrong usage.

    arguments: list of str, default those of the process.
    """
    own = arguments is None
    if own:
        streams.prepare()
        arguments = sys.argv[1:]
    try:
        missing = without_value(arguments)
        options = parser(prog).parse_args([each for each in joined(arguments) if each not in missing])
        options.without_value = missing
    except SystemExit as leave:
        status = leave.code or 0
        return _guarded(prog, lambda: status)
    options.name = "%s %s" % (prog, options.command)
    isolated = own and options.command in _ISOLATED and hasattr(os, "fork")
    return _guarded(options.name, lambda: _isolated(options) if isolated else _run(options))


def _isolated(options):
    """Runs a command in a child process; the exit status. Raises Error."""
    check(options)
    limit = parse_numbers("--read-timeout", [options.read_timeout], 0.0, 1e6)[0]
    try:
        return child.run(lambda: _guarded(options.name, lambda: _run(options)), limit)
    except child.Ended as end:
        streams.clear_line()
        if end.number == signal.SIGINT:
            streams.complain("%s: interrupted\n" % options.name)
        if end.number in child.FORWARDED:
            return 128 + end.number
        if end.number == signal.SIGALRM:
            raise Error("%s: cannot be read: reading it took more than %g s; the file is corrupt, or "
                        "needs more time: --read-timeout S" % (end.reading, limit)) from None
        inputs = options.scenes or [] if options.command == "bench" else options.inputs
        raise Error("VTK crashed (%s); one of the files is corrupt, or memory ran out: %s" % (
            signal.strsignal(end.number), end.reading or " ".join(inputs))) from None


def _guarded(name, work):
    """Runs a function that returns an exit status; that status, with an error told in one line."""
    try:
        status = work()
    except Error as error:
        status = _fail(name, one_line(error))
    except KeyboardInterrupt:
        _fail(name, "interrupted")
        status = 128 + signal.SIGINT
    except MemoryError:
        status = _fail(name, "out of memory; use a smaller --size or fewer inputs")
    except ModuleNotFoundError as error:
        if error.name and error.name.startswith("numpy"):
            status = _fail(name, "needs NumPy for Python %s (Debian: python3-numpy)" % PYTHON_VERSION)
        else:
            status = _fail(name, "this Python lacks a module: %s" % one_line(error))
    except OSError as error:
        status = _told(name, streams.finish()) or _fail(name, one_line(
            "%s: %s" % (error.filename or "a file", error.strerror or error)))
    except Exception as error:  # pylint: disable=broad-except
        where = traceback.extract_tb(error.__traceback__)[-1]
        status = _fail(name, "internal error, please report it: %s: %s (%s:%d)" % (
            type(error).__name__, one_line(error), os.path.basename(where.filename), where.lineno))
    return status or _told(name, streams.finish())


def _told(name, trouble):
    """The exit status for what streams.finish() found. A reader that has left is not told about."""
    if trouble is None:
        return 0
    if not isinstance(trouble, BrokenPipeError):
        streams.complain("%s: standard output cannot be written: %s\n" % (name, trouble.strerror))
    return 1


def _fail(name, message):
    streams.complain("%s: %s\n" % (name, message))
    return 1


def _run(options):
    """Runs a command in this process; 0. Raises Error."""
    from .progress import Progress

    check(options)
    progress = Progress()
    try:
        if options.command == "info":
            from . import info

            info.run()
        elif options.command == "render":
            from . import render

            render.run(options, progress)
        elif options.command == "compare":
            from . import compare

            compare.run(options, progress)
        elif options.command == "run":
            from . import application

            application.run(options.program, options.method, options.respect, options.log, options.preload)
        elif options.command == "conform":
            from .conform import run

            run.run(options, progress)
        elif options.command == "bench":
            from .bench import run

            run.run(options, progress)
        else:
            from . import showcase

            showcase.run(options.output, options.size, progress)
    finally:
        progress.clear()
    return 0
