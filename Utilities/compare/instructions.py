# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Instructions of the first picture and of a steady frame of one build, as multiples of those of unsorted blending, and
what has grown since they were recorded."""

import pathlib
import re
import shutil
import subprocess
import tempfile

from pictures import Failure, command, libraries
from speed import valgrind_environment

# Many props; deep; isosurfaces.
SCENES = ("crowd-200", "layers-32", "isosurfaces-coarse")
METHODS = ("abuffer", "auto", "dual")
REFERENCE = "blend"
SIZE = [128, 128]
# The first picture of a process, some that still compile, and those that are taken for steady.
FRAMES, STEADY = 12, 3
GROWTH = 1.02
RECORD = pathlib.Path(__file__).resolve().parent / "instructions.txt"
HEAD = ("# Instructions by callgrind as multiples of those of unsorted blending, %d x %d pixels, made by\n"
        "# Utilities/instructions.sh --record: scene, method, first picture of a process (nothing compiled before),\n"
        "# steady frame.\n" % tuple(SIZE))


def count(build, scenes, methods):
    """Instructions of (first picture, steady frame), dict of (scene, method) to (int, float), in one run of valgrind.
    Raises Failure."""
    if not shutil.which("valgrind"):
        raise Failure("instructions are counted by valgrind (Debian: valgrind)")
    libraries(build)
    drawings = [[scene, method, SIZE] for scene in scenes for method in methods]
    with tempfile.TemporaryDirectory() as folder:
        # Counts are written and set to 0 where a frame begins.
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--trace-children=yes", "--dump-before=vtkRenderWindow::Render()",
             "--callgrind-out-file=%s/%%p" % folder,
             *command(build, {"do": "forks", "drawings": drawings, "frames": FRAMES})],
            check=False, env=valgrind_environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if run.returncode:
            raise Failure("valgrind ended with status %d: %s" % (run.returncode, run.stderr[-300:]))
        children = [int(line) for line in run.stdout.split()]
        return {(scene, method): _of_child(pathlib.Path(folder), child)
                for (scene, method, _), child in zip(drawings, children)}


def _of_child(folder, child):
    # Part 1 is what comes before the first frame, and what follows the last one is in no numbered part.
    frames = [_total(folder / ("%d.%d" % (child, number))) for number in range(2, FRAMES + 1)]
    return frames[0], sum(frames[-STEADY:]) / STEADY


def _total(path):
    try:
        return int(re.search(r"^totals: (\d+)", path.read_text(), re.MULTILINE).group(1))
    except (OSError, AttributeError):
        raise Failure("callgrind wrote no %s; is there a vtkRenderWindow::Render() any more?" % path.name) from None


def ratios(counts):
    """Multiples of the reference, dict of (scene, method) to (first, steady), from what count() returns."""
    return {(scene, method): tuple(own / of for own, of in zip(values, counts[scene, REFERENCE]))
            for (scene, method), values in counts.items() if method != REFERENCE}


def read(path):
    """The ratios in a file, as from ratios(). Raises Failure."""
    result = {}
    try:
        for line in pathlib.Path(path).read_text().splitlines():
            if line and not line.startswith("#"):
                scene, method, *values = line.split()
                first, steady = values
                result[scene, method] = float(first), float(steady)
    except (OSError, ValueError) as error:
        raise Failure("%s: %s" % (path, error)) from None
    return result


def write(path, found):
    """Writes ratios into a file."""
    pathlib.Path(path).write_text(HEAD + "".join(
        "%-20s %-8s %7.3f %7.3f\n" % (*key, *values) for key, values in found.items()))


def grown(recorded, found):
    """What has grown by more than 2 %, a line each, list of str; what is not recorded, too."""
    lines = []
    for (scene, method), values in found.items():
        if (scene, method) not in recorded:
            lines.append("%s by %s: not recorded" % (scene, method))
            continue
        for name, before, now in zip(("first picture", "steady frame"), recorded[scene, method], values):
            if now > GROWTH * before:
                lines.append("%s by %s, %s: %.3f, recorded %.3f" % (scene, method, name, now, before))
    return lines


def run(build, scenes, methods, record, check):
    """Prints a Markdown table; the exit status, 1 when `check` finds something."""
    found = ratios(count(build, scenes or SCENES, [REFERENCE, *(methods or METHODS)]))
    print("| scene | method | first picture / blending's | steady frame / blending's |\n|---|---|---|---|")
    for key, values in found.items():
        print("| %s | `%s` | %.3f | %.3f |" % (*key, *values))
    if record:
        write(RECORD, found)
    worse = grown(read(RECORD), found) if check else []
    for line in worse:
        print("grown: " + line)
    return 1 if worse else 0
