# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Render windows without a display, and what a window's OpenGL context is."""

import collections
import re

from .errors import capture

Context = collections.namedtuple(
    "Context", "window_class vendor renderer version extensions")
Context.__doc__ = """An OpenGL context: window_class, vendor, renderer and version are str,
extensions is a frozenset of str."""


def headless():
    """Makes every vtkRenderWindow of this process headless from now on; no display is needed.

    Call it before the first render window is made. OSMesa, or with VTK 9.4 and later EGL where
    there is no OSMesa. Calling it again does nothing. Returns the backend's name, str. Raises
    RuntimeError with one line that names the reason when neither works.
    """
    from .vtkOITOSMesa import vtkOITHeadless

    if not vtkOITHeadless.GetBackendName():
        with capture() as captured:
            works = vtkOITHeadless.Initialize()
        if not works:
            raise RuntimeError(captured.summary(1) or "no way to render without a display")
    return vtkOITHeadless.GetBackendName()


def backend():
    """"OSMesa" or "EGL" after headless(), otherwise an empty str."""
    from .vtkOITOSMesa import vtkOITHeadless

    return vtkOITHeadless.GetBackendName()


def make_window(renderer, size, samples=0):
    """A vtkRenderWindow that shows nothing on a screen, with the renderer in it.

    size: (width, height), int, pixels. samples: int, multisampling, 0 for none.
    """
    from vtkmodules.vtkRenderingCore import vtkRenderWindow

    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(samples)
    window.SetAlphaBitPlanes(True)
    window.SetSize(*size)
    if renderer is not None:
        window.AddRenderer(renderer)
    return window


def context_of(window):
    """The Context of a vtkRenderWindow; renders it once when it was never rendered."""
    if window.GetNeverRendered():
        window.Render()
    report = window.ReportCapabilities() or ""
    strings = {}
    for key in ("vendor", "renderer", "version"):
        match = re.search(r"^OpenGL %s string:\s*(.*)$" % key, report, re.MULTILINE)
        strings[key] = match.group(1).strip() if match else "unknown"
    extensions = frozenset(re.findall(r"\bGL_[A-Z]+_\w+", report))
    return Context(window.GetClassName(), strings["vendor"], strings["renderer"],
                   strings["version"], extensions)
