# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The program that draws the scenes, and what it says of a pass."""

import json
import os
import subprocess

import numpy

from ..errors import Error

NAME = "vtkOITCxxTests"
LONGEST = 600.0  # seconds of a test and pass; a pass may never end

# Those that the program knows besides the methods of vtkOIT.
VTK = {
    "vtk-weighted": "`vtkOrderIndependentTranslucentPass`, VTK's default",
    "vtk-dual": "`vtkDualDepthPeelingPass`, that is `UseDepthPeelingOn()`, with as many peels as it asks for",
    "vtk-dual-4": "`vtkDualDepthPeelingPass` with 4 peels, as by default",
    "vtk-peel": "`vtkDepthPeelingPass`, with as many peels as it asks for",
}


def find(path=None):
    """The path of the program, str: path, or bin/vtkOITCxxTests above this package. Raises Error."""
    if path is not None:
        if not os.access(path, os.X_OK) or os.path.isdir(path):
            raise Error("--program %s: no program; give vtkOITCxxTests of a build with tests" % path)
        return os.path.abspath(path)
    folder = os.path.dirname(os.path.realpath(__file__))
    while os.path.dirname(folder) != folder:
        folder = os.path.dirname(folder)
        found = os.path.join(folder, "bin", NAME)
        if os.access(found, os.X_OK):
            return found
    raise Error("the scenes are drawn by %s, which is built with the tests (cmake -DBUILD_TESTING=ON) and is in no "
                "package; name it by --program FILE" % NAME)


def run(program, test, contender, folder):
    """What a test says of a contender: list of dict, a comparison each (number, what, color, alpha,
    allowed_color, allowed_alpha, picture), at the end one with the key problem, str, where the test did not
    end well. folder: str, an empty one for pictures. Raises Error when nothing can be drawn at all."""
    results = os.path.join(folder, "results.jsonl")
    problem = None
    try:
        done = subprocess.run([program, test, contender, "--results", results, "--pictures", folder], check=False,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=LONGEST)
        if done.returncode < 0:
            problem = "ended by signal %d" % -done.returncode
        elif done.returncode:
            problem = "exit status %d" % done.returncode
    except subprocess.TimeoutExpired:
        problem = "no end after %g minutes" % (LONGEST / 60.0)
    except OSError as error:
        raise Error("%s: cannot be run: %s" % (program, error.strerror)) from None
    lines = []
    if os.path.exists(results):
        with open(results, encoding="utf-8", errors="replace") as file:
            lines = [json.loads(line) for line in file]
    found = [line for line in lines if "what" in line]
    for line in found:
        line["key"] = (test, found.index(line))
    if problem or not found:
        found.append({"test": test, "contender": contender, "problem": problem or "no comparison"})
    return found


def read_picture(path):
    """A file as the program writes it: array of uint8, height x width x 3."""
    with open(path, "rb") as file:
        _, width, height, _ = file.readline().split()
        return numpy.frombuffer(file.read(), dtype=numpy.uint8).reshape(int(height), int(width), 3)
