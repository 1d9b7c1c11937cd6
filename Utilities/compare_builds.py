#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares two builds of vtkOIT: whether their pictures are the same bit by bit, and what their frames cost.

For a change that is to change nothing: build A before it and B after it, in two folders.

  compare_builds.py pictures A B       draws with both and tells what differs; status 1 when a picture does
  compare_builds.py render A a.zip     draws with one, such as inside Utilities/matrix.sh --copy a.zip /tmp/a.zip testing
  compare_builds.py diff a.zip b.zip   tells what differs between two such files
  compare_builds.py speed A B          the time of frames, in turns, B/A
  compare_builds.py speed A B --instructions
  compare_builds.py instructions A     those of one build, as multiples of blending's (Utilities/instructions.sh)

The scenes and how they are drawn come from the source tree of this script, the package vtkoit and the library from the
builds. Pictures of a build take about 10 minutes of one core: all methods in most scenes, their variants each in some;
--scenes with --full draws them all. Windows are made by the build's vtkoit-python: OSMesa, or EGL. Only files of the same
VTK, Mesa and machine can be equal.

llvmpipe draws the same bits with one thread and with several: what the A-buffer collects comes in another order then, and is
sorted. Only how many passes a peeling method needs may depend on when an occlusion query has its result; LP_NUM_THREADS=0
for both builds makes that certain, too, and has pictures of its own in the cache.
"""

import argparse
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "compare"))

try:
    import instructions
    import pictures
    import speed
except ModuleNotFoundError as error:
    sys.exit("compare_builds.py: %s: no %s; try /usr/bin/python3, or a build's vtkoit-python" % (
        sys.executable, error.name))


def parser():
    """The command line."""
    top = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = top.add_subparsers(dest="command", required=True)

    def add(name, text, *positional):
        result = commands.add_parser(name, help=text, description=text)
        for each, meaning in positional:
            result.add_argument(each, type=pathlib.Path, metavar=each.upper(), help=meaning)
        return result

    folders = [("build_a", "build folder"), ("build_b", "build folder to compare with it")]
    both = add("pictures", "draw with two builds and compare the pictures", *folders)
    both.add_argument("--cache", type=pathlib.Path, default=pathlib.Path("/tmp/vtkoit-compare"), metavar="DIR",
                      help="keeps the pictures of a build until it or the scenes change (default: %(default)s)")
    one = add("render", "draw with one build", ("build", "build folder"), ("output", "file of the pictures, .zip"))
    for command in (both, one):
        _add_what(command, "200x200")
        command.add_argument("--full", action="store_true", help="all variants of all methods in all scenes: hours")
    compare = add("diff", "compare two files of pictures", ("file_a", "from render"), ("file_b", "from render"))
    for command in (both, compare):
        command.add_argument("--lines", type=int, default=40, metavar="N", help="of each kind (default: %(default)s)")
    timed = add("speed", "time frames of a turning camera by two builds in turns", *folders)
    _add_what(timed, speed.SIZE)
    timed.add_argument("--frames", type=int, metavar="N", help="of a row (default: 40; with --instructions 3)")
    timed.add_argument("--budget", type=float, default=20.0, metavar="S",
                       help="seconds of a row after which it has no more frames, but 9 (default: %(default)s)")
    timed.add_argument("--instructions", action="store_true",
                       help="count instructions of a frame by callgrind instead: exact, but minutes a row, and "
                            "other shaders than on the machine itself")
    counted = add("instructions", "count instructions of a build as multiples of blending's", ("build", "build folder"))
    counted.add_argument("--scenes", nargs="+", metavar="S", help="default: " + " ".join(instructions.SCENES))
    counted.add_argument("--methods", nargs="+", metavar="M", help="default: " + " ".join(instructions.METHODS))
    mode = counted.add_mutually_exclusive_group()
    mode.add_argument("--record", action="store_true", help="write them into %s" % instructions.RECORD.name)
    mode.add_argument("--check", action="store_true", help="status 1 when one has grown by more than 2 %% over that file")
    return top


def _add_what(command, size):
    command.add_argument("--scenes", nargs="+", metavar="S", help=(
        "names of vtkoit bench --list or patterns, or baseline-*" if size != speed.SIZE else
        "names, each with @WxH for another size (default: %s)" % " ".join(speed.SCENES)))
    command.add_argument("--methods", nargs="+", metavar="M", help=(
        "default: all of vtkoit.methods()" if size != speed.SIZE else
        "METHOD:NAME=VALUE,... (default: all; with --instructions auto abuffer dual)"))
    command.add_argument("--size", default=size, metavar="WxH", help="pixels (default: %(default)s)")


def run(options):
    """Runs a command; the exit status."""
    if options.command == "diff":
        return 1 if pictures.diff(options.file_a, options.file_b, options.lines) else 0
    if options.command == "instructions":
        return instructions.run(options.build, options.scenes, options.methods, options.record, options.check)
    if options.command == "speed":
        arguments = (options.build_a, options.build_b, options.scenes or speed.SCENES, options.methods, options.size)
        if options.instructions:
            speed.instructions(*arguments, options.frames or 3)
        else:
            speed.alternate(*arguments, options.frames or 40, options.budget)
        return 0
    what = {"size": speed.parse_size(options.size), "patterns": options.scenes, "methods": options.methods,
            "full": options.full}
    if options.command == "render":
        pictures.render(options.build, options.output, what)
        return 0
    # The same for both, whatever the methods are called in B.
    what["methods"] = what["methods"] or speed.methods_of(options.build_a)
    files = [pictures.cached(build, options.cache, what) for build in (options.build_a, options.build_b)]
    return 1 if pictures.diff(*files, options.lines) else 0


def main():
    try:
        return run(parser().parse_args())
    except pictures.Failure as failure:
        print("compare_builds.py: %s" % failure, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
