# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Putting a pass into a renderer that already exists, and taking it out again."""

from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLRenderer

from .passes import create
from .vtkOIT import vtkOITRendererHook


def install(renderer, method="auto", **properties):
    """Draws the translucent props of a renderer by a method of vtkOIT, from the next frame on.

    renderer: any vtkRenderer (vtkOpenGLRenderer), application subclasses included; it keeps its
    own pipeline: selection, SSAO, FXAA, volumes, overlays. A method installed before is replaced.
    method: str, one of methods(). properties: as for create(), e.g. FragmentPrecision="float",
    MaximumBufferSize=256 * 2**20.

    Returns the pass (vtkOITPass), whose statistics tell about the last frame. Raises TypeError for
    something that is no renderer, ValueError for an unknown method, property or value.
    """
    _check(renderer)
    new_pass = create(method, **properties)
    if not vtkOITRendererHook.Install(renderer, new_pass):
        raise TypeError("the renderer (%s) cannot take a pass" % renderer.GetClassName())
    return new_pass


def uninstall(renderer):
    """Gives a renderer back as install() found it. True, or False when nothing was installed."""
    _check(renderer)
    return bool(vtkOITRendererHook.Uninstall(renderer))


def installed(renderer):
    """The pass (vtkOITPass) that install() put into a renderer, or None."""
    _check(renderer)
    return vtkOITRendererHook.GetInstalledPass(renderer)


def _check(renderer):
    if not isinstance(renderer, vtkOpenGLRenderer):
        raise TypeError("a vtkRenderer is needed (of a PyVista plotter: plotter.renderer), not a %s"
                        % type(renderer).__name__)
