# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The methods that compete: ours with any properties, and VTK's own, each in a window of its own."""

import collections
import time

from .. import method_option
from ..drawn import Drawn
from ..errors import capture
from ..lookup import render_pass
from ..passes import create, methods
from ..windows import make_window
from . import gpu

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
    return method_option.parse(name, VTK)


def make_pass(name):
    """(translucent pass for vtkRenderStepsPass, vtkOITPass or None) of a contender's name."""
    method, properties = parse(name)
    blend = render_pass("vtkTranslucentPass")()
    if method in ("blend", "vtk-sort"):
        return blend, None
    if method == "vtk-weighted":
        result = render_pass("vtkOrderIndependentTranslucentPass")()
    elif method == "vtk-peel":
        result = render_pass("vtkDepthPeelingPass")()
    elif method in ("vtk-dual", "vtk-dual-4"):
        result = render_pass("vtkDualDepthPeelingPass")()
    else:
        result = create(method, **properties)
        return result, result
    result.SetTranslucentPass(blend)
    if method != "vtk-weighted":
        result.SetMaximumNumberOfPeels(4 if method == "vtk-dual-4" else ALL_PEELS)
        result.SetOcclusionRatio(0.0)
    return result, None


class Contender:
    """A method in a window of its own with its own copy of the scene."""

    def __init__(self, name, renderer, size):
        """name: str. renderer: a vtkRenderer of its own. size: (width, height), pixels."""
        self.name = name
        self.renderer = renderer
        translucent, self.oit = make_pass(name)
        self.drawn = self.oit and Drawn(parse(name)[0], self.oit)
        self.steps = render_pass("vtkRenderStepsPass")()
        self.steps.SetTranslucentPass(translucent)
        # What can draws volumes between the layers, otherwise they are drawn over them.
        if renderer.GetVolumes().GetNumberOfItems() and hasattr(translucent, "SetVolumetricPass"):
            translucent.SetVolumetricPass(render_pass("vtkVolumetricPass")())
            self.steps.SetVolumetricPass(None)
        self.renderer.SetPass(self.steps)
        self.window = make_window(self.renderer, size)
        self.timer = None
        self.gpu_seconds = None

    def render(self):
        """Renders a frame; (seconds, seconds of all cores), float, until the frame is done. Sets
        gpu_seconds, float; None without a GPU, and for the first frame."""
        is_first = bool(self.window.GetNeverRendered())
        if self.timer is not None:
            self.window.MakeCurrent()
            self.timer.begin()
        cpu = time.process_time()
        start = time.perf_counter()
        self.window.Render()
        if self.timer is not None:
            self.timer.end()
        self.window.WaitForCompletion()
        seconds = time.perf_counter() - start
        cpu = time.process_time() - cpu
        if self.timer is not None:
            self.gpu_seconds = self.timer.seconds()
        elif is_first:
            self.timer = gpu.make_timer()
        return seconds, cpu

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

    def why_other(self):
        """Why another method drew the last frame in this one's place, str; empty when none did."""
        return self.drawn.why_other(self.window) if self.oit else ""

    def close(self):
        """Frees the window and what is on its context."""
        with capture():
            self.renderer.SetPass(None)
            self.window.RemoveRenderer(self.renderer)
            self.window.Finalize()
