# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The methods that compete: ours with any properties, and VTK's own, each in a window of its own."""

import collections
import time

from ..errors import Error, capture
from ..passes import create, methods
from ..windows import make_window
from .scene import actor_of, append, fill

# Peels that never end a frame before its last layer.
ALL_PEELS = 100000

Statistics = collections.namedtuple(
    "Statistics", "algorithm exact error_bound passes fragments layers bytes")
Statistics.__doc__ = """What a pass tells of its last frame: algorithm (str), exact (bool), error_bound (float),
passes, fragments, layers, bytes (int, negative for unknown); None for what VTK's passes do not tell."""

VTK = {
    "blend": "unsorted blending",
    "vtk-weighted": "VTK's default, vtkOrderIndependentTranslucentPass",
    "vtk-peel": "vtkDepthPeelingPass to the end",
    "vtk-dual": "vtkDualDepthPeelingPass to the end",
    "vtk-dual-4": "vtkDualDepthPeelingPass, 4 peels as in ParaView",
    "vtk-sort": "vtkDepthSortPolyData, all props in one",
}

# Beside the methods as they are: the options that make the most of them, and the papers' own.
VARIANTS = (
    "abuffer:FragmentPrecision=float",
    "dual:TransmittanceThreshold=0",
    "multilayer:NumberOfLayersPerPass=4",
    "multilayer:NumberOfLayersPerPass=16",
    "bucket:MaximumNumberOfPeels=1",
    "bucket-pairs:MaximumNumberOfPeels=1",
    "bucket-adaptive:MaximumNumberOfPeels=1",
)


def names(quick=False):
    """What competes by default, list of str; quick: VTK's choices and one of each kind of ours."""
    if quick:
        return ["blend", "vtk-weighted", "vtk-dual"] + [
            name for name in methods() if name in ("auto", "abuffer", "dual", "multilayer",
                                                   "weighted-average")]
    return list(VTK) + methods() + list(VARIANTS)


def parse(name):
    """(method, properties) of a str such as multilayer:NumberOfLayersPerPass=16,OcclusionRatio=0.1:
    str, and dict of str to str. Raises Error for what does not exist."""
    method, _, rest = name.partition(":")
    properties = {}
    for text in filter(None, rest.split(",")):
        key, equals, value = text.partition("=")
        if not equals or not value:
            raise Error("--methods %s: give METHOD:NAME=VALUE,NAME=VALUE" % name)
        properties[key] = value
    if method in VTK:
        if properties:
            raise Error("--methods %s: VTK's methods take no properties here" % name)
        return method, properties
    if method not in methods():
        raise Error("--methods %s: unknown; there are: %s" % (
            method, " ".join(list(VTK) + methods())))
    try:
        create(method, **properties)
    except ValueError as error:
        raise Error("--methods %s: %s" % (name, error)) from None
    return method, properties


def make_pass(name):
    """(translucent pass for vtkRenderStepsPass, vtkOITPass or None) of a contender's name."""
    from vtkmodules import vtkRenderingOpenGL2 as gl

    method, properties = parse(name)
    blend = gl.vtkTranslucentPass()
    if method in ("blend", "vtk-sort"):
        return blend, None
    if method == "vtk-weighted":
        result = gl.vtkOrderIndependentTranslucentPass()
    elif method == "vtk-peel":
        result = gl.vtkDepthPeelingPass()
    elif method in ("vtk-dual", "vtk-dual-4"):
        result = gl.vtkDualDepthPeelingPass()
    else:
        result = create(method, **properties)
        return result, result
    result.SetTranslucentPass(blend)
    if method != "vtk-weighted":
        result.SetMaximumNumberOfPeels(4 if method == "vtk-dual-4" else ALL_PEELS)
        result.SetOcclusionRatio(0.0)
    return result, None


def why_not(name, parts):
    """Why a contender cannot draw a scene, str; empty when it can."""
    if parse(name)[0] == "vtk-sort" and any(
            part.kind in ("spheres", "sticks") or part.texture for part in _translucent(parts)):
        return "sorts polygons of one colour a prop, not textures or impostors"
    return ""


def _translucent(parts):
    return [part for part in parts if part.opacity < 1.0 or part.texture]


class Contender:
    """A method in a window of its own with its own copy of the scene."""

    def __init__(self, name, scene, parts, size):
        """name: str. scene: Scene, parts: list of Part. size: (width, height), pixels."""
        from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass

        self.name = name
        translucent, self.oit = make_pass(name)
        self.renderer = fill(scene, _sorted_parts(parts)[0] if name == "vtk-sort" else parts)
        if name == "vtk-sort":
            self.renderer.AddActor(_sorted_actor(parts, self.renderer.GetActiveCamera()))
            scene.place(self.renderer)
        self.steps = vtkRenderStepsPass()
        self.steps.SetTranslucentPass(translucent)
        self.renderer.SetPass(self.steps)
        self.window = make_window(self.renderer, size)
        self.messages = []

    def render(self):
        """Renders a frame; (seconds, seconds of all cores), float, until the frame is done."""
        cpu = time.process_time()
        start = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        seconds = time.perf_counter() - start
        return seconds, time.process_time() - cpu

    def turn(self, degrees):
        """Turns the camera around the vertical, so that nothing of the last frame can be used."""
        self.renderer.GetActiveCamera().Azimuth(degrees)

    def statistics(self):
        """Statistics of the last frame; None for VTK's passes."""
        if self.oit is None:
            return None
        return Statistics(
            self.oit.GetAlgorithmName(), bool(self.oit.GetExact()), self.oit.GetErrorBound(),
            self.oit.GetNumberOfGeometryPasses(), self.oit.GetNumberOfFragments(),
            self.oit.GetMaximumDepthComplexity(), self.oit.GetBufferSizeInBytes())

    def missing(self):
        """Why the method does not run in this context, str; empty when it runs."""
        if self.oit is None:
            return ""
        return " ".join(self.oit.GetMissingCapability(self.window).split())

    def close(self):
        """Frees the window and what is on its context."""
        with capture():
            self.renderer.SetPass(None)
            self.window.RemoveRenderer(self.renderer)
            self.window.Finalize()


def _sorted_parts(parts):
    """(opaque parts, translucent parts)."""
    translucent = _translucent(parts)
    return [part for part in parts if part not in translucent], translucent


def _sorted_actor(parts, camera):
    """One actor of all translucent parts, whose polygons are sorted by depth for each frame."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkFiltersHybrid import vtkDepthSortPolyData

    translucent = _sorted_parts(parts)[1]
    colored = []
    for part in translucent:
        data = vtkPolyData()
        data.SetPoints(part.data.GetPoints())
        data.SetPolys(part.data.GetPolys())
        data.SetStrips(part.data.GetStrips())
        data.GetPointData().SetNormals(part.data.GetPointData().GetNormals())
        rgba = numpy.rint(255 * numpy.array([*part.color, part.opacity])).astype(numpy.uint8)
        array = numpy_to_vtk(numpy.tile(rgba, (data.GetNumberOfPoints(), 1)), deep=True)
        array.SetName("colors")
        data.GetPointData().SetScalars(array)
        colored.append(data)
    sort = vtkDepthSortPolyData()
    sort.SetInputData(append(colored))
    sort.SetDirectionToBackToFront()
    sort.SetDepthSortModeToBoundsCenter()
    sort.SetCamera(camera)
    actor = actor_of(translucent[0]._replace(data=append(colored)))
    actor.GetProperty().SetOpacity(1.0)
    mapper = actor.GetMapper()
    mapper.SetInputConnection(sort.GetOutputPort())
    mapper.ScalarVisibilityOn()
    mapper.SetColorModeToDirectScalars()
    actor.ForceTranslucentOn()
    return actor


def opaque_picture(scene, parts, size, background_alpha=1.0):
    """What is behind the translucent props: array of uint8, height x width x 4, top row first.
    background_alpha: float, of the background."""
    from ..picture import grab

    renderer = fill(scene, parts)
    opaque = _sorted_parts(parts)[0]
    actors = renderer.GetActors()
    actors.InitTraversal()
    for part in parts:
        actors.GetNextActor().SetVisibility(part in opaque)
    renderer.SetBackgroundAlpha(background_alpha)
    window = make_window(renderer, size)
    window.Render()
    pixels = grab(window)
    window.RemoveRenderer(renderer)
    window.Finalize()
    return pixels
