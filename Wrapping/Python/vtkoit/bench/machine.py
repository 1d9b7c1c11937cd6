# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What was measured on: the header of every output."""

import datetime
import hashlib
import os
import platform
import re

from ..version import VERSION
from ..windows import backend, context_of, make_window


def describe():
    """The machine and the software, dict of str to str or number."""
    from vtkmodules.vtkCommonCore import vtkVersion

    window = make_window(None, (8, 8))
    context = context_of(window)
    window.Finalize()
    return {
        "date": datetime.datetime.now().astimezone().isoformat(timespec="seconds"),
        "cpu": _cpu(),
        "cores": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity")
        else os.cpu_count(),
        "load": round(os.getloadavg()[0], 1),
        "system": "%s %s" % (_system(), platform.machine()),
        "vtkoit": VERSION,
        "library": library_digest(),
        "vtk": vtkVersion.GetVTKVersion(),
        "window": context.window_class,
        "backend": backend(),
        "renderer": context.renderer,
        "opengl": context.version,
    }


def line(machine):
    """The header in one line, str."""
    return ("%(cpu)s, %(cores)d cores (load %(load)s), %(system)s; VTK %(vtk)s, vtkOIT %(vtkoit)s; "
            "%(renderer)s, OpenGL %(opengl)s; %(date)s" % machine)


def is_busy(machine):
    """Whether other work, by the load of the last minute, takes more than a quarter of the cores."""
    return machine["load"] > 0.25 * machine["cores"]


def _cpu():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            match = re.search(r"^model name\s*:\s*(.+)$", file.read(), re.MULTILINE)
        if match:
            return " ".join(match.group(1).split())
    except OSError:
        pass
    return platform.processor() or platform.machine()


def _system():
    try:
        return platform.freedesktop_os_release()["PRETTY_NAME"]
    except (OSError, KeyError):
        return platform.system()


def library_digest():
    """Tells one build of vtkOIT's libraries from another, str; empty where they cannot be found."""
    digest = hashlib.sha256()
    try:
        with open("/proc/self/maps", encoding="utf-8", errors="replace") as file:
            paths = sorted(set(re.findall(r"/\S*libvtkOIT[-.]\S*", file.read())))
        for path in paths:
            with open(path, "rb") as file:
                digest.update(file.read())
    except OSError:
        return ""
    return digest.hexdigest()[:12] if paths else ""


def available_bytes():
    """Memory that is free for us, int."""
    try:
        with open("/proc/meminfo", encoding="ascii") as file:
            match = re.search(r"^MemAvailable:\s*(\d+) kB", file.read(), re.MULTILINE)
        return 1024 * int(match.group(1))
    except (OSError, AttributeError):
        return 4 * 2 ** 30
