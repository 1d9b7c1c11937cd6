# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Drawing the translucent props of every renderer of this process."""

from .passes import create
from .vtkOIT import vtkOITProcessHook


def install_everywhere(method="auto", respect_depth_peeling=False, log=False):
    """Draws the translucent props of every renderer that is made from now on, or is in a window that
    is made from now on, by a method of vtkOIT; what the application does with depth peeling does not
    matter. `vtkoit run` does the same to a program without a change in it.

    method: str, one of methods(). respect_depth_peeling: bool, True leaves renderers to VTK whose
    depth peeling is off. log: bool, True prints a line for each renderer on standard error, and
    statistics at the end of the process.

    Renderers that have a pass by install() keep it. A window that was made before is reached by
    install(window). Raises ValueError for an unknown method.
    """
    create(method)  # raises where there is no such method
    vtkOITProcessHook.SetRespectDepthPeeling(respect_depth_peeling)
    vtkOITProcessHook.SetLog(log)
    vtkOITProcessHook.Install(method)


def uninstall_everywhere():
    """Gives back every renderer that install_everywhere() has reached. True, or False when it was not
    called."""
    return vtkOITProcessHook.Uninstall()
