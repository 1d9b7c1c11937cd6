# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Putting passes into renderers that already exist, and taking them out again."""

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkRenderingCore import vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLRenderer

from .passes import create
from .vtkOIT import vtkOITRendererHook

_WINDOW_HOOK = "_vtkoit_window_hook"  # attribute of a window that install() was called for


def install(where, method="auto", **properties):
    """Draws translucent props by a method of vtkOIT, from the next frame on.

    where: a vtkRenderer (vtkOpenGLRenderer), application subclasses included; it keeps its own
    pipeline: selection, SSAO, FXAA, volumes, overlays. Or a vtkRenderWindow: all its renderers, also
    those that are added later. Or a PyVista or vedo plotter: its window. Or a render view of ParaView:
    its renderer. A method installed before is replaced.
    method: str, one of methods(). properties: as for create(), e.g. FragmentPrecision="float",
    MaximumBufferSize=256 * 2**20.

    Returns the pass (vtkOITPass), whose statistics tell about the last frame; for a window or a
    plotter the list of the passes of its renderers. Raises TypeError for something that has no
    renderer, ValueError for an unknown method, property or value.
    """
    target = _target(where)
    if isinstance(target, vtkOpenGLRenderer):
        return _install(target, create(method, **properties))
    create(method, **properties)  # what is wrong with them is told now, and nothing installed
    hook = _window_hook(target)
    if hook is None:
        hook = _WindowHook(target)
        setattr(target, _WINDOW_HOOK, hook)
    return hook.set_method(target, lambda: create(method, **properties))


def uninstall(where):
    """Gives what install() was called for back as it was. True, or False when nothing was installed."""
    target = _target(where)
    if isinstance(target, vtkOpenGLRenderer):
        return bool(vtkOITRendererHook.Uninstall(target))
    hook = _window_hook(target)
    if hook is None:
        return any([vtkOITRendererHook.Uninstall(renderer) for renderer in target.GetRenderers()])
    delattr(target, _WINDOW_HOOK)
    hook.give_back(target)
    return True


def installed(where):
    """The pass (vtkOITPass) that install() put into a renderer, or None; for a window or a plotter
    the list of the passes of its renderers, without those that have none."""
    target = _target(where)
    if isinstance(target, vtkOpenGLRenderer):
        return vtkOITRendererHook.GetInstalledPass(target)
    found = [vtkOITRendererHook.GetInstalledPass(renderer) for renderer in target.GetRenderers()]
    return [each for each in found if each is not None]


class _WindowHook:
    """Keeps all renderers of a window supplied; an attribute of the window."""

    def __init__(self, window):
        self.make = None
        self.tag = window.AddObserver("StartEvent", lambda caller, _event: self.supply(caller))

    def set_method(self, window, make):
        """make: a function that returns a new pass. Returns the passes of the renderers there are."""
        self.make = make
        return [_install(renderer, make()) for renderer in window.GetRenderers()
                if isinstance(renderer, vtkOpenGLRenderer)]

    def supply(self, window):
        """Before a frame: the renderers that were added since the last one."""
        for renderer in window.GetRenderers():
            if isinstance(renderer, vtkOpenGLRenderer) and not vtkOITRendererHook.GetInstalledPass(renderer):
                _install(renderer, self.make())

    def give_back(self, window):
        window.RemoveObserver(self.tag)
        for renderer in window.GetRenderers():
            vtkOITRendererHook.Uninstall(renderer)


def _window_hook(window):
    return getattr(window, _WINDOW_HOOK, None)


def _install(renderer, new_pass):
    if not vtkOITRendererHook.Install(renderer, new_pass):
        raise TypeError("the renderer (%s) cannot take a pass" % renderer.GetClassName())
    return new_pass


def _target(where):
    """The vtkOpenGLRenderer or vtkRenderWindow that install() is about."""
    found = where
    if hasattr(where, "GetClientSideObject"):  # a view's proxy in ParaView
        found = getattr(where.GetClientSideObject(), "GetRenderer", lambda: None)()
    elif not isinstance(where, vtkObject):
        # A plotter of PyVista, of vedo.
        found = getattr(where, "render_window", None) or getattr(where, "window", None)
    if isinstance(found, (vtkOpenGLRenderer, vtkRenderWindow)):
        return found
    raise TypeError("a vtkRenderer, a vtkRenderWindow, a plotter or a render view is needed, not a %s"
                    % type(where).__name__)
