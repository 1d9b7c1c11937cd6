# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The cost of frames of two builds: alternating frames of two processes, or instructions by callgrind."""

import json
import re
import shutil
import subprocess
import sys
import tempfile

import numpy
from pictures import Failure, command, environment, libraries

SCENES = ("one-sphere@200x200", "spheres", "isosurfaces", "small-props", "deep", "disjoint")
SIZE = "400x400"
WARM_UP = 5
TURN_SECONDS = 0.05


def parse_size(text):
    """[width, height] of a str such as 400x400. Raises Failure."""
    match = re.fullmatch(r"(\d+)x(\d+)", text)
    if not match or not all(0 < int(number) <= 16384 for number in match.groups()):
        raise Failure("%s: no size; give WxH, such as 400x400" % text)
    return [int(number) for number in match.groups()]


def parse_scene(text, size):
    """(name, [width, height]) of a str such as spheres or spheres@200x200. size: str, the default."""
    name, _, own = text.partition("@")
    return name, parse_size(own or size)


class Worker:
    """A process of a build that draws a frame when it is asked to."""

    def __init__(self, build, environ):
        libraries(build)
        self.build = build
        # pylint: disable=consider-using-with
        self.process = subprocess.Popen(command(build, {"do": "serve"}), env=environ, text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def ask(self, **question):
        """The answer to a line, dict. Raises Failure."""
        try:
            self.process.stdin.write(json.dumps(question) + "\n")
            self.process.stdin.flush()
            return json.loads(self.process.stdout.readline())
        except (OSError, ValueError):
            raise Failure("%s: its process ended, status %s" % (self.build, self.process.wait())) from None

    def close(self):
        """Ends the process."""
        self.process.stdin.close()
        self.process.wait()


def methods_of(build):
    """The methods of a build, list of str. Raises Failure."""
    worker = Worker(build, environment())
    try:
        return worker.ask(methods=0)["methods"]
    finally:
        worker.close()


def _frames(workers, frames, budget):
    """(times of the rounds, array n x 2 builds x 2: wall and processor time of a frame; frames of a round, int).
    frames: int. budget: float, seconds."""
    for number in range(WARM_UP):
        first = [worker.ask(frame=number)["frame"][1] for worker in workers]
    # Short frames are taken several at once: a process that has waited for the other one begins slowly.
    several = int(numpy.clip(TURN_SECONDS / max(*first, 1e-4), 1, 20))
    rounds, spent = [], 0.0
    for number in range(frames):
        times = [None, None]
        for i in (1, 0) if number % 2 else (0, 1):
            if several > 1:
                workers[i].ask(frame=number)
            times[i] = numpy.median([workers[i].ask(frame=number)["frame"] for _ in range(several)], axis=0)
        rounds.append(times)
        spent += several * (times[0][0] + times[1][0])
        if spent > budget and number >= 8:
            break
    return numpy.array(rounds), several


def _spread(quotients):
    low, middle, high = numpy.percentile(quotients, [25, 50, 75])
    return "%.3f (%.3f to %.3f)" % (middle, low, high)


def alternate(build_a, build_b, scenes, methods, size, frames, budget):
    """Prints a Markdown table of the ratios B/A. scenes, methods: list of str. size: str. frames: int. budget: float,
    seconds of a row."""
    chosen = [parse_scene(text, size) for text in scenes]
    methods = methods or methods_of(build_a)
    workers = [Worker(build, environment()) for build in (build_a, build_b)]
    quotients = []
    try:
        print("| scene | method | rounds x frames | A ms | A processor ms | B/A time (quartiles) | "
              "B/A processor time (quartiles) |\n|---|---|---|---|---|---|---|")
        for scene, pixels in chosen:
            for method in methods:
                label = "| %s %dx%d | `%s` |" % (scene, *pixels, method)
                opened = [worker.ask(open=[scene, method, pixels]) for worker in workers]
                missing = [answer["missing"] for answer in opened]
                if missing[0].startswith("no scene"):
                    raise Failure(missing[0])
                if any(missing):
                    print("%s - | %s | | | |" % (label, "; ".join(filter(None, dict.fromkeys(missing)))))
                else:
                    times, several = _frames(workers, frames, budget)
                    ratio = times[:, 1] / times[:, 0]
                    quotients.append(numpy.median(ratio, axis=0))
                    milliseconds = 1000.0 * numpy.median(times[:, 0], axis=0)
                    print("%s %d x %d | %.2f | %.2f | %s | %s |" % (
                        label, len(times), several, *milliseconds, _spread(ratio[:, 0]), _spread(ratio[:, 1])))
                sys.stdout.flush()
                for worker in workers:
                    worker.ask(close=0)
        if quotients:
            print("| all | median of the medians | | | | %s | %s |" % tuple(
                _spread(column) for column in numpy.transpose(quotients)))
    finally:
        for worker in workers:
            worker.close()


def valgrind_environment():
    """The environment in which instructions are counted, dict of str."""
    # One thread, nothing compiled before, and instructions that valgrind knows.
    return environment(LP_NUM_THREADS="0", LP_NATIVE_VECTOR_WIDTH="128", MESA_SHADER_CACHE_DISABLE="true")


def count_instructions(build, scene, method, pixels, frames):
    """Instructions of a process that draws so many frames, int. Raises Failure."""
    asked = {"do": "frames", "scene": scene, "contender": method, "size": pixels, "frames": frames}
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--trace-children=yes", "--callgrind-out-file=%s/%%p" % folder,
             *command(build, asked)], check=False, env=valgrind_environment(), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            text=True)
    counts = [int(number) for number in re.findall(r"Collected : (\d+)", run.stderr)]
    if run.returncode or not counts:
        raise Failure("valgrind ended with status %d: %s" % (run.returncode, run.stderr[-300:]))
    return max(counts)  # the others are of the shell script around Python


def instructions(build_a, build_b, scenes, methods, size, frames):
    """Prints a Markdown table of the instructions of a frame. As for alternate()."""
    if not shutil.which("valgrind"):
        raise Failure("--instructions needs valgrind (Debian: valgrind)")
    print("| scene | method | A instructions of a frame | B | B/A |\n|---|---|---|---|---|")
    for text in scenes:
        scene, pixels = parse_scene(text, size)
        for method in methods or ["auto", "abuffer", "dual"]:
            each = []
            for build in (build_a, build_b):
                libraries(build)
                few, many = (count_instructions(build, scene, method, pixels, n)
                             for n in (WARM_UP, WARM_UP + frames))
                each.append((many - few) / frames)
            print("| %s %dx%d | `%s` | %s | %s | %.4f |" % (
                scene, *pixels, method, format(round(each[0]), ","), format(round(each[1]), ","), each[1] / each[0]))
            sys.stdout.flush()
