# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Exact order-independent transparency for VTK.

    import vtkoit
    vtkoit.install(renderer)      # or a vtkRenderWindow, a PyVista plotter, a ParaView view
    ...
    vtkoit.uninstall(renderer)    # as it was before
    vtkoit.install_everywhere()   # all renderers that are made from now on

Importing this package changes nothing: windows are made as before. A script that has no display
calls headless() before its first render window.

The wrapped classes are in vtkoit.vtkOIT (passes, factory, hook) and vtkoit.vtkOITOSMesa (windows
without a display); the command line is ``python3 -m vtkoit -h``.
"""

# VTK's OpenGL classes come in by object factories, which this import registers.
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

from .errors import Error
from .everywhere import install_everywhere, uninstall_everywhere
from .hook import install, installed, uninstall
from .passes import create, method_info, methods, properties
from .version import VERSION as __version__
from .windows import backend, headless

__all__ = [
    "Error",
    "__version__",
    "backend",
    "create",
    "headless",
    "install",
    "install_everywhere",
    "installed",
    "method_info",
    "methods",
    "properties",
    "uninstall",
    "uninstall_everywhere",
]
