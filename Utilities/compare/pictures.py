# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a build in a file, and what differs between two such files."""

import collections
import fcntl
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import zipfile

import numpy

HERE = pathlib.Path(__file__).resolve().parent
BENCH = HERE.parents[1] / "Wrapping" / "Python" / "vtkoit" / "bench"
SOURCES = [HERE / "draw.py", HERE / "scenes.py"] + [BENCH / n for n in ("scene.py", "families.py", "sciviz.py")]
# Extensions that the tiers hide.
TIERS = ("", "GL_EXT_shader_framebuffer_fetch", "GL_ARB_shader_storage_buffer_object")


class Failure(Exception):
    """What went wrong, in one line."""


def libraries(build):
    """The libraries of a build, list of Path. Raises Failure."""
    found = sorted({path.resolve() for path in (pathlib.Path(build) / "lib").rglob("libvtkOIT*")
                    if path.is_file() and not path.name.endswith("LateLibrary.so")})
    if not found or not (pathlib.Path(build) / "bin" / "vtkoit-python").exists():
        raise Failure("%s: no build of vtkOIT: no lib/libvtkOIT* or no bin/vtkoit-python" % build)
    return found


def key(build, what):
    """A digest of a build's libraries, of what is drawn and of how, str. what: dict."""
    digest = hashlib.sha256(json.dumps(what, sort_keys=True).encode())
    digest.update(os.environ.get("LP_NUM_THREADS", "").encode())
    for path in [*libraries(build), *SOURCES]:
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def command(build, asked):
    """The command line for draw.py in a build, list of str. asked: dict."""
    return [str(pathlib.Path(build) / "bin" / "vtkoit-python"), str(HERE / "draw.py"), json.dumps(asked)]


def environment(**values):
    """The environment for draw.py, dict of str."""
    return {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONHASHSEED": "0", "VTKOIT_HIDE_EXTENSIONS": "", **values}


def render(build, output, what):
    """Draws everything with a build into a file. output: Path. what: dict: size, patterns, methods, full. Raises Failure."""
    libraries(build)
    part = output.with_name("%s.%d.part" % (output.name, os.getpid()))
    part.unlink(missing_ok=True)
    try:
        for number, hidden in enumerate(TIERS):
            asked = {"do": "pictures", "output": str(part), "hidden": hidden, "number": number, **what}
            status = subprocess.run(command(build, asked), check=False,
                                    env=environment(VTKOIT_HIDE_EXTENSIONS=hidden)).returncode
            if status:
                raise Failure("%s ended with status %d%s" % (
                    build, status, ", with VTKOIT_HIDE_EXTENSIONS=" + hidden if hidden else ""))
        part.rename(output)
    finally:
        part.unlink(missing_ok=True)


def cached(build, folder, what):
    """The file of a build's pictures, Path; drawn unless the folder has it. Raises Failure."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / (key(build, what) + ".zip")
    with open(path.with_suffix(".lock"), "w", encoding="ascii") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # another one that draws the same is waited for
        if path.exists():
            print("%s: as drawn before, %s" % (build, path), file=sys.stderr)
        else:
            print("%s: drawing into %s" % (build, path), file=sys.stderr)
            render(build, path, what)
    return path


class Result:
    """The pictures of a build in a file."""

    def __init__(self, path):
        """path: Path. Raises Failure."""
        try:
            self.file = zipfile.ZipFile(path)
            tiers = [json.loads(self.file.read("records-%d.json" % i)) for i in range(len(TIERS))]
        except (OSError, KeyError, ValueError, zipfile.BadZipFile) as error:
            raise Failure("%s: not written by compare_builds.py render: %s" % (path, error)) from None
        self.about = "VTK %(vtk)s, %(window)s, %(renderer)s" % tiers[0]
        self.records = {(r["scene"], r["contender"], r["hidden"]): r for tier in tiers for r in tier["records"]}

    def picture(self, frame):
        """The picture of a frame (dict of a record), array n x 4."""
        return numpy.frombuffer(self.file.read(frame["picture"]), frame["type"]).reshape(-1, 4)

    def count(self):
        """The number of pictures, int."""
        return sum(len(r["frames"]) for r in self.records.values())


def name_of(at):
    """How a record is called, str. at: (scene, contender, hidden)."""
    return "%s, %s%s" % (at[0], at[1], " without " + at[2] if at[2] else "")


def difference(a, b):
    """How two pictures differ, str: pixels and the largest difference. a, b: arrays n x 4."""
    if a.shape != b.shape or a.dtype != b.dtype:
        return "%d pixels of %s, and %d of %s" % (len(a), a.dtype, len(b), b.dtype)
    # Of not-a-number the bits count.
    apart = (a.view(numpy.uint8).reshape(len(a), -1) != b.view(numpy.uint8).reshape(len(b), -1)).any(axis=1)
    largest = numpy.abs(a[apart].astype(float) - b[apart].astype(float))
    finite = largest[numpy.isfinite(largest)]
    text = "%d of %d pixels, up to %.4g" % (
        apart.sum(), len(a), finite.max() if len(finite) else 0.0)
    text += " of 255" if a.dtype == numpy.uint8 else ""
    return text + (", not finite" if len(finite) < largest.size else "")


def _statistics(a, b):
    """Lines about what two records tell otherwise, list of str."""
    told = collections.OrderedDict()
    for one, other in zip(a["frames"], b["frames"]):
        mine, yours = one["statistics"], other["statistics"]
        for name in sorted(set(mine) | set(yours)):
            if json.dumps(mine.get(name)) != json.dumps(yours.get(name)):  # as text, for not-a-number
                values = [v[0] if isinstance(v, list) and len(v) == 1 else v
                          for v in (mine.get(name), yours.get(name))]
                told.setdefault("%s %s -> %s" % (name, *values), []).append(str(one["number"] + 1))
    lines = ["frame %s: %s" % (" ".join(frames), text) for text, frames in told.items()]
    for name in ("depth", "missing", "messages"):
        if a.get(name) != b.get(name):
            lines.append("%s %s -> %s" % (name, a.get(name), b.get(name)))
    return lines


def diff(path_a, path_b, limit=40):
    """Prints what differs; the number of scenes and contenders whose pictures differ, int. path_a, path_b: Path. limit: int,
    lines of each kind."""
    a, b = Result(path_a), Result(path_b)
    for letter, path, result in (("A", path_a, a), ("B", path_b, b)):
        print("%s: %s, %d pictures; %s" % (letter, path, result.count(), result.about))
    pictures, statistics, compared = [], [], 0
    for at, one in a.records.items():
        other = b.records.get(at)
        if other is None or len(one["frames"]) != len(other["frames"]):
            pictures.append("%s: not drawn alike: %s" % (
                name_of(at), "not by B" if other is None else other.get("missing") or "not by A"))
            continue
        compared += len(one["frames"])
        apart = [(f, g) for f, g in zip(one["frames"], other["frames"]) if f["picture"] != g["picture"]]
        if apart:
            pictures.append("%s: frame %s: %s" % (
                name_of(at), " ".join(str(f["number"] + 1) for f, _ in apart),
                "; ".join(dict.fromkeys(difference(a.picture(f), b.picture(g)) for f, g in apart))))
        statistics += ["%s: %s" % (name_of(at), line) for line in _statistics(one, other)]
    only = sorted({at[1] for at in b.records} - {at[1] for at in a.records})
    if only:
        print("only B has: %s" % " ".join(only))
    for title, lines in (("statistics that differ", statistics), ("pictures that differ", pictures)):
        print("%s: %d" % (title, len(lines)))
        for line in lines[:limit]:
            print("  " + line)
        if len(lines) > limit:
            print("  ... and %d more (--lines)" % (len(lines) - limit))
    print("%d pictures compared bit by bit: %s" % (
        compared, "%d scenes and contenders differ" % len(pictures) if pictures else "all equal"))
    return len(pictures)
