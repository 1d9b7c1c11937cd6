# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the first picture costs: each method in a process of its own, with nothing compiled before (cold), and with the
driver's cache of shaders from a process before it (warm)."""

import json
import os
import subprocess
import sys
import tempfile

import numpy

from ..errors import Error, capture
from ..values import parse_size
from ..windows import headless
from . import catalogue, rounds
from .document import table
from .measure import REFERENCE
from .stage import Stage

PAGE = "first-picture.md"
METHODS = ("vtk-weighted", "vtk-dual", "abuffer", "auto")
SCENES = ("one-sphere", "spheres", "hull", "isosurfaces", "small-props")
QUICK_SCENES = SCENES[:1]
FRAMES = 3  # of a process
TURN = 0.5  # degrees before each but the first
CACHES = ("cold", "warm")
_CHILD = "from vtkoit.bench import first; first.draw(*%r)"


def draw(scene, method, size):
    """What a process does: prints the processor time in seconds of its first frames, a list in JSON. scene, method, size: str."""
    headless()
    chosen, = catalogue.choose([scene])
    contender = Stage(chosen, parse_size(size)).contender(method)
    times = []
    with capture() as captured:
        for number in range(FRAMES):
            if number:
                contender.turn(TURN)
            times.append(contender.render()[1])
    reason = contender.missing() or captured.errors(1)
    print(json.dumps({"times": times, "reason": reason}))


def measure(size, settings, is_quick, progress):
    """The results, list of dict: scene, triangles, cache, method, and of each of the first frames the multiple of the
    reference's first one, medians of settings.frames processes. size: (width, height). settings: rounds.Settings."""
    results = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in QUICK_SCENES if is_quick else SCENES:
            for cache in CACHES:
                taken = _take(scene, cache, folder, "%dx%d" % size, settings.frames, progress)
                of = taken[REFERENCE][:, 0]
                results += [{"scene": scene, "cache": cache, "method": method,
                             "frames": [rounds.ratio(times[:, i], of)[0] for i in range(FRAMES)]}
                            for method, times in taken.items()]
    return results


def _take(scene, cache, folder, size, number, progress):
    """Times by method, dict of array number x FRAMES: methods take turns."""
    names = (REFERENCE, *METHODS)
    times = {name: [] for name in names}
    if cache == "warm":
        for name in names:
            _run(scene, name, size, cache, folder)
    for turn in range(number):
        for name in names[::-1] if turn % 2 else names:
            progress.show("%s, %s: %s, process %d of %d" % (scene, cache, name, turn + 1, number), turn / number)
            times[name].append(_run(scene, name, size, cache, folder))
    return {name: numpy.array(mine) for name, mine in times.items()}


def _run(scene, method, size, cache, folder):
    environment = {key: value for key, value in os.environ.items() if not key.startswith("MESA_SHADER_CACHE")}
    environment["MESA_SHADER_CACHE_DISABLE"] = "true" if cache == "cold" else "false"
    environment["MESA_SHADER_CACHE_DIR"] = folder
    ran = subprocess.run([sys.executable, "-c", _CHILD % ((scene, method, size),)], env=environment, check=False,
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        told = json.loads(ran.stdout.splitlines()[-1])
    except (ValueError, IndexError):
        told = {"reason": "its process ended with status %d: %s" % (ran.returncode, ran.stderr[-200:])}
    if told["reason"]:
        raise Error("%s in %s: %s" % (method, scene, told["reason"]))
    return told["times"]


_HEAD = """# The first picture

A script that makes one picture and a batch job a time step pay what the first frame costs: shaders are compiled, data go to the
driver, buffers find their size. This page was written by

```sh
{command}
```

on {machine}.

Processor time of all cores as multiples of the first frame of unsorted blending (`blend`), medians of {frames} processes of each method,
which took turns; {size} pixels. In parentheses the second and the third frame, of a camera that turns: they compile what the first one has not
needed. Cold: nothing is in the driver's cache of shaders. Warm: it has what a process of the same method compiled before.
"""


def page(results, where, command, settings, size):
    """The page in Markdown, str. results: list of dict of measure(). where: str, the machine."""
    parts = [_HEAD.format(command=command, machine=where, frames=settings.frames, size="%d x %d" % size)]
    methods = (REFERENCE, *METHODS)
    for cache in CACHES:
        rows = []
        for scene in dict.fromkeys(result["scene"] for result in results):
            mine = {r["method"]: r["frames"] for r in results if (r["scene"], r["cache"]) == (scene, cache)}
            rows.append([scene] + ["%.2f (%.2f, %.2f)" % tuple(mine[method]) for method in methods])
        parts += ["## " + cache.capitalize(), table(["scene"] + ["`%s`" % m for m in methods], rows)]
    return "\n\n".join(part.strip("\n") for part in parts) + "\n"
