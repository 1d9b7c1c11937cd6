# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""plotter.oit: exact translucency in PyVista.

    import pyvista as pv
    plotter = pv.Plotter()
    ...
    plotter.oit.enable()
    plotter.show()
    print(plotter.oit.report())

PyVista 0.48 and later find this module by its entry point when `plotter.oit` is first used; nothing
needs to be imported. With an older PyVista call vtkoit.install(plotter).
"""

from typing import NamedTuple

import pyvista

from .hook import install, installed, uninstall

if not hasattr(pyvista, "register_plotter_component"):
    raise ImportError("plotter.oit needs PyVista 0.48 or later; with this one call vtkoit.install(plotter)")


class Frame(NamedTuple):
    """What the pass of a subplot did in its last frame."""

    subplot: int  # as in plotter.renderers
    algorithm: str  # that drew
    exact: bool  # whether nothing was dropped or approximated
    error_bound: float  # of a colour from 0 to 1, 0 when exact
    geometry_passes: int  # how often the translucent meshes were drawn
    fragments: int  # over all pixels, negative when not known
    depth_complexity: int  # most fragments of a pixel, negative when not known
    buffer_size: int  # bytes


class Report(list):
    """A list of Frame, one for each subplot; as text a table."""

    def __str__(self):
        lines = ["subplot   exact  passes  fragments  layers     MiB  algorithm"]
        for frame in self:
            lines.append("%7d  %6s  %6d  %9s  %6s  %6.1f  %s" % (
                frame.subplot, _exactness(frame), frame.geometry_passes,
                frame.fragments if frame.fragments >= 0 else "-",
                frame.depth_complexity if frame.depth_complexity >= 0 else "-",
                frame.buffer_size / 2.0 ** 20, frame.algorithm))
        return "\n".join(lines)


def _exactness(frame):
    """Whether a Frame is exact, str: by less than what is seen, by TransmittanceThreshold, says by how much."""
    if frame.exact:
        return "yes"
    return "%.4f" % frame.error_bound if frame.error_bound < 0.01 else "no"


@pyvista.register_plotter_component("oit")
class Component:
    """Draws the translucent meshes of all subplots of a plotter by vtkOIT."""

    def __init__(self, plotter):
        self._plotter = plotter

    def enable(self, method="auto", **properties):
        """Draws translucent meshes in the right order from the next frame on, in all subplots.

        method: str, one of vtkoit.methods(). properties: as for vtkoit.create(), for example
        TransmittanceThreshold=0. Depth peeling and multisampling need not be set. Calling it again
        changes the method. Raises ValueError for an unknown method, property or value.
        """
        install(self._window(), method, **properties)
        self._plotter.render()

    def disable(self):
        """Leaves translucent meshes to VTK again, as before enable(). True, or False when it was not
        enabled."""
        done = self._plotter.render_window is not None and uninstall(self._plotter)
        if done:
            self._plotter.render()
        return done

    @property
    def enabled(self):
        """Whether vtkOIT draws the translucent meshes: bool."""
        return self._plotter.render_window is not None and bool(installed(self._plotter))

    def report(self):
        """What was done in the last frame of each subplot that vtkOIT draws: a Report."""
        frames = Report()
        if not self.enabled:
            return frames
        for subplot, renderer in enumerate(self._plotter.renderers):
            done = installed(renderer)
            if done is not None:
                frames.append(Frame(
                    subplot, done.GetAlgorithmName(), done.GetExact(), done.GetErrorBound(),
                    done.GetNumberOfGeometryPasses(), done.GetNumberOfFragments(),
                    done.GetMaximumDepthComplexity(), done.GetBufferSizeInBytes()))
        return frames

    def _window(self):
        window = self._plotter.render_window
        if window is None:
            raise RuntimeError("the plotter is closed; enable vtkOIT before show(), or show(auto_close=False)")
        return window

    def __plotter_close__(self):
        # While the window, and with it OpenGL, is still there.
        if self._plotter.render_window is not None:
            uninstall(self._plotter)
