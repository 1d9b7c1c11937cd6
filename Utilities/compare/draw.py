# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The part of compare_builds.py that runs in a build, by its vtkoit-python; one JSON object in the argument.

{"do": "pictures", ...}   draws all scenes by all contenders into a zip file
{"do": "frames", ...}     draws a number of frames and ends, for callgrind
{"do": "forks", ...}      the same for several drawings, each in a process of its own, whose ids it prints
{"do": "serve"}           draws frames one at a time as standard input asks, and answers with their times

A contender is METHOD[:NAME=VALUE,...][@4 | @float], in a window of 4 samples, or in a framebuffer of floats with a
background of alpha 0.4.
"""

import gc
import hashlib
import json
import os
import re
import sys
import time
import zipfile
import zlib

import numpy
import scenes
import vtkoit
from vtkmodules import vtkRenderingOpenGL2 as gl
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkFloatArray,
    vtkLogger,
    vtkOutputWindow,
    vtkStringOutputWindow,
    vtkUnsignedCharArray,
    vtkVersion,
)
from vtkmodules.vtkRenderingCore import vtkRenderWindow

TURNS = (0.0, 0.0, 0.0, 7.0, -3.0)  # degrees that the camera turns before each frame
# What takes long keeps less from frame to frame, and does not draw all of them, or in windows of half the width.
LEFT_OUT = {"peel": (2, 4), "dual": (2, 4), "multilayer": (2, 4), "weighted": (2, 4), "bucket": (1, 2, 4)}
HALF = ("bucket",)
STATISTICS = ("AlgorithmName", "Exact", "ErrorBound", "NumberOfGeometryPasses", "NumberOfFragments",
              "MaximumDepthComplexity", "BufferSizeInBytes", "SkipSummary")
# Each on its own, where a method has the property and another value for its default.
VARIANTS = (
    ("FragmentPrecision", "float"),
    ("TransmittanceThreshold", 0.0),
    ("TransmittanceThreshold", 1.0 / 512.0),
    ("MaximumBufferSize", 2 ** 20),
    ("MaximumNumberOfPeels", 2),
    ("UseOcclusionQuery", 0),
    ("ReuseFrames", 0),
    ("SkipSorting", 0),
    ("SkipHiddenFragments", 0),
    ("NumberOfLayersPerPass", 4),
    ("NumberOfLayersPerPass", 16),
)
MULTISAMPLED = ("auto", "abuffer")
# What instructions are compared with, and no method of ours: VTK's blending in the order of the props.
UNSORTED = {"blend": gl.vtkTranslucentPass}
# Unless everything is asked for, the methods as they are draw every scene, and the others these and each one scene of
# so many, in turns.
THOROUGH = ("baseline-spheres", "baseline-viewports")
TURN = 8


def contenders(methods, hidden):
    """All contenders of methods, list of str. hidden: str, extensions that are hidden; there, only a few."""
    result = []
    for method in methods:
        result += [method, method + "@float"]
        try:
            properties = vtkoit.properties(method)
        except ValueError:
            continue  # a name of the other build; said where it is drawn
        for name, value in VARIANTS:
            if name in properties and properties[name] != value and not (
                    hidden and name not in ("FragmentPrecision", "MaximumBufferSize")):
                result.append("%s:%s=%s" % (method, name, value))
        if method in MULTISAMPLED and not hidden:
            result += [method + "@4", method + ":FragmentPrecision=float@4", method + ":MaximumBufferSize=1048576@4"]
    return result


def make_window(size, samples=0):
    """An empty vtkRenderWindow without a display."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(samples)
    window.SetAlphaBitPlanes(True)
    window.SetSize(*size)
    window.SetNumberOfLayers(2)
    return window


class Drawing:
    """A scene by a contender, in a window that many share, one after the other: shaders are compiled once."""

    def __init__(self, window, renderers, contender):
        """renderers: list of new vtkRenderer. contender: str. Raises ValueError where the build does not know it."""
        name, _, self.target = contender.partition("@")
        method, _, rest = name.partition(":")
        values = dict(text.split("=") for text in filter(None, rest.split(",")))
        self.window = window
        self.renderers = renderers
        create = UNSORTED.get(method, lambda: vtkoit.create(method, **values))
        self.passes = [create() for _ in renderers]
        self.outer = []
        for renderer, inner in zip(renderers, self.passes):
            steps = gl.vtkRenderStepsPass()
            steps.SetTranslucentPass(inner)
            if self.target == "float":
                renderer.SetBackgroundAlpha(0.4)
                self.outer.append(gl.vtkFramebufferPass())
                self.outer[-1].SetDelegatePass(steps)
                self.outer[-1].SetColorFormat(gl.vtkTextureObject.Float32)
                self.outer[-1].SetDepthFormat(gl.vtkTextureObject.Float32)
                steps = self.outer[-1]
            renderer.SetPass(steps)
            window.AddRenderer(renderer)

    def turn(self, degrees):
        """Turns the cameras around the vertical."""
        for renderer in self.renderers:
            renderer.GetActiveCamera().Azimuth(degrees)

    def missing(self):
        """What this contender lacks in this context, str; empty when it runs."""
        find = getattr(self.passes[0], "GetMissingCapability", lambda window: "")
        return " ".join(find(self.window).split())

    def picture(self):
        """What the last frame shows: array n x 4 of bytes, or of float."""
        if self.outer:
            return numpy.concatenate([_floats(outer.GetColorTexture()) for outer in self.outer])
        width, height = self.window.GetSize()
        pixels = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
        return vtk_to_numpy(pixels)

    def depth(self):
        """A digest of the depth buffer, str; None where it cannot be read."""
        if self.target:
            return None
        width, height = self.window.GetSize()
        depths = vtkFloatArray()
        self.window.GetZbufferData(0, 0, width - 1, height - 1, depths)
        return _digest(vtk_to_numpy(depths))

    def statistics(self):
        """What the passes tell of the last frame, dict of list."""
        return {name: [getattr(each, "Get" + name, lambda: None)() for each in self.passes]
                for name in STATISTICS}

    def close(self):
        """Makes room for the next one."""
        for renderer in self.renderers:
            renderer.SetPass(None)
            self.window.RemoveRenderer(renderer)
        for outer in self.outer:
            outer.ReleaseGraphicsResources(self.window)
        for each in self.passes:
            each.ReleaseGraphicsResources(self.window)


def _floats(texture):
    size = texture.GetWidth(), texture.GetHeight()
    values = numpy.zeros((size[1], size[0], 4), numpy.float32)
    buffer = texture.Download()
    buffer.Download2D(10, values, size, 4, [0, 0])  # VTK_FLOAT
    return values.reshape(-1, 4)


def _digest(values):
    return hashlib.sha256(values.tobytes()).hexdigest()[:16]


class _Messages:
    """What VTK and vtkOIT report while something is drawn, without addresses and line numbers."""

    def __init__(self):
        self.window = None

    def listen(self):
        self.window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.window)

    def take(self):
        text = re.sub(r"0x[0-9a-fA-F]+|In \S+, line \d+", "", self.window.GetOutput() or "")
        return sorted({" ".join(line.split()) for line in text.splitlines() if line.strip()})


def draws(scene, contender, hidden):
    """Whether a contender draws a scene when not everything is asked for; the same for any list of them."""
    return scene in THOROUGH or zlib.crc32((scene + contender + hidden).encode()) % TURN == 0 or (
        not hidden and ":" not in contender and "@" not in contender)


def pictures(zip_file, hidden, size, patterns, methods, full):
    """Draws everything into a ZipFile; yields a dict for each scene and contender. full: bool, all contenders in all
    scenes."""
    windows = {}
    messages = _Messages()
    names = contenders(methods or vtkoit.methods(), hidden)
    stored = set(zip_file.namelist())
    for scene in scenes.choose(patterns):
        make = scene.make()
        # What is drawn is said before it is, for the case that it crashes.
        sys.stderr.write("\n%s%s:" % (scene.name, " without " + hidden if hidden else ""))
        for name in names:
            if not full and not draws(scene.name, name, hidden):
                continue
            sys.stderr.write(" " + name)
            sys.stderr.flush()
            record = {"scene": scene.name, "contender": name, "hidden": hidden, "frames": []}
            factor = (2 if name.startswith(HALF) else 1) * scenes.SMALLER.get(scene.name, 1)
            kind = ((size[0] // factor, size[1] // factor), 4 if name.endswith("@4") else 0)
            if kind not in windows:
                windows[kind] = make_window(*kind)
            start = time.process_time()
            messages.listen()
            drawing = None
            try:
                drawing = Drawing(windows[kind], make(), name)
                _draw(drawing, record, zip_file, stored)
            except ValueError as error:
                record["missing"] = " ".join(str(error).split())
            if drawing is not None:
                drawing.close()
            record["messages"] = messages.take()
            record["seconds"] = round(time.process_time() - start, 3)
            yield record
        gc.collect()
    sys.stderr.write("\n")
    for window in windows.values():
        window.Finalize()


def _draw(drawing, record, zip_file, stored):
    left_out = LEFT_OUT.get(re.match("[a-z]*", record["contender"]).group(), ())
    for number, degrees in enumerate(TURNS):
        if number in left_out:
            continue
        if degrees:
            drawing.turn(degrees)
        drawing.window.Render()
        if number == 0:
            record["missing"] = drawing.missing()
        if drawing.outer and number == 1:
            continue  # large, and shown by the next one
        values = drawing.picture()
        digest = _digest(values)
        if digest not in stored:
            stored.add(digest)
            zip_file.writestr(digest, values.tobytes())
        record["frames"].append({"number": number, "picture": digest, "type": values.dtype.name,
                                 "statistics": drawing.statistics()})
    record["depth"] = drawing.depth()


def write_pictures(output, hidden, number, **what):
    """Appends the pictures and the records of a tier to a zip file. output: str. number: int, of the tier."""
    with zipfile.ZipFile(output, "a", zipfile.ZIP_DEFLATED, compresslevel=1) as zip_file:
        records = list(pictures(zip_file, hidden, **what))
        window = make_window((8, 8))
        window.Render()
        context = re.search(r"OpenGL renderer string:\s*(.*)", window.ReportCapabilities() or "")
        zip_file.writestr("records-%d.json" % number, json.dumps({
            "hidden": hidden, "vtk": vtkVersion.GetVTKVersion(), "window": window.GetClassName(),
            "renderer": context.group(1).strip() if context else "", "records": records}))


class Timed:
    """Frames of a turning camera, the cost of each."""

    def __init__(self, scene, contender, size):
        self.window = make_window(size, 4 if contender.endswith("@4") else 0)
        self.drawing = Drawing(self.window, scenes.choose([scene])[0].make()(), contender)

    def frame(self):
        """(seconds, seconds of the processor) of the next frame."""
        self.drawing.turn(1.0)
        cpu, start = time.process_time(), time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        return time.perf_counter() - start, time.process_time() - cpu

    def close(self):
        """Frees the window."""
        self.drawing.close()
        self.window.Finalize()


def serve():
    """Answers lines of JSON: {"methods": 0}, {"open": [scene, contender, size]}, {"frame": 0}, {"close": 0};
    each with one line of JSON."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    timed = None
    for line in sys.stdin:
        asked = json.loads(line)
        result = {}
        try:
            if "open" in asked:
                timed = Timed(*asked["open"])
                result = {"first": timed.frame(), "missing": timed.drawing.missing()}
            elif "frame" in asked:
                result = {"frame": timed.frame()}
            elif "methods" in asked:
                result = {"methods": vtkoit.methods()}
            elif timed is not None:
                timed.close()
                timed = None
                gc.collect()
        except ValueError as error:
            result = {"missing": " ".join(str(error).split())}
        answers.write(json.dumps(result) + "\n")
        answers.flush()


def draw_frames(scene, contender, size, frames):
    """Draws so many frames of a turning camera."""
    timed = Timed(scene, contender, size)
    for _ in range(frames):
        timed.frame()


def fork(drawings, frames):
    """Draws each of several (scene, contender, size) in a process of its own, which has imported everything already:
    under valgrind that takes longer than the frames."""
    for drawing in drawings:
        sys.stdout.flush()
        child = os.fork()
        if child == 0:
            status = 1
            try:
                draw_frames(*drawing, frames)
                status = 0
            finally:
                os._exit(status)
        if os.waitpid(child, 0)[1]:
            sys.exit("%s by %s was not drawn" % tuple(drawing[:2]))
        print(child)


def main():
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # the output window gets the same
    asked = json.loads(sys.argv[1])
    do = asked.pop("do")
    if do == "pictures":
        write_pictures(**asked)
    elif do == "serve":
        serve()
    elif do == "forks":
        fork(**asked)
    else:
        draw_frames(**asked)


if __name__ == "__main__":
    main()
