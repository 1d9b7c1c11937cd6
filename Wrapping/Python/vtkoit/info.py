# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command info: what this machine renders with, and which methods run."""

from vtkmodules.vtkCommonCore import vtkVersion

from .errors import Error, capture
from .hook import install
from .passes import method_info
from .version import VERSION
from .windows import backend, context_of, headless, make_window

# What the methods of vtkOIT make use of.
EXTENSIONS = [
    "GL_ARB_shader_image_load_store",
    "GL_ARB_shader_storage_buffer_object",
    "GL_ARB_shader_atomic_counters",
    "GL_ARB_clear_texture",
    "GL_ARB_post_depth_coverage",
    "GL_EXT_shader_framebuffer_fetch",
    "GL_ARB_fragment_shader_interlock",
    "GL_NV_fragment_shader_interlock",
    "GL_ARB_texture_barrier",
]


def run():
    """Prints what the process renders with. Raises Error when no context can be made."""
    with capture() as captured:
        try:
            headless()
            reason = ""
        except RuntimeError as error:
            reason = str(error)
        if not reason:
            window = make_window(None, (8, 8))
            context = context_of(window)
            infos = method_info(window)
            choice = _choice(window)
            window.Finalize()
    if reason:
        raise Error(reason)
    if context.version == "unknown":
        raise Error("the context of %s cannot be made: %s"
                    % (context.window_class, captured.summary(1) or "no reason given"))
    rows = [
        ("vtkOIT", VERSION),
        ("VTK", vtkVersion.GetVTKVersion()),
        ("window", "%s (headless, %s)" % (context.window_class, backend())),
        ("OpenGL", context.version),
        ("renderer", context.renderer),
        ("vendor", context.vendor),
    ]
    for name, value in rows:
        print("%-10s %s" % (name, value))
    print("extensions")
    for name in EXTENSIONS:
        print("  %-3s %s" % ("yes" if name in context.extensions else "no", name))
    print("methods")
    width = max(len(info.name) for info in infos)
    for info in infos:
        print("  %-*s  %s  %s" % (width, info.name, info.class_name,
                                  "does not run: " + info.missing if info.missing else "runs"))
    print(choice)


def _choice(window):
    """One line, str: what the method auto takes in this window for props that need sorting."""
    from vtkmodules.vtkFiltersSources import vtkSphereSource
    from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

    renderer = vtkRenderer()
    for center in (0.0, 0.5):  # they overlap
        source = vtkSphereSource()
        source.SetCenter(center, 0.0, 0.0)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetOpacity(0.5)
        renderer.AddActor(actor)
    taken = install(renderer)
    window.AddRenderer(renderer)
    window.Render()
    line = "auto takes %s: %s, at most %.4g MiB" % (
        taken.GetAlgorithmName(), taken.GetAlgorithmReason(), taken.GetBufferLimit() / 2.0 ** 20)
    window.RemoveRenderer(renderer)
    return line
