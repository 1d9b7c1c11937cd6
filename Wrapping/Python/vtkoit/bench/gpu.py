# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Timer queries of a GPU. VTK's own timer keeps its results to C++, so OpenGL is called here."""

import ctypes
import re

from ..windows import backend

_TIMESTAMP, _QUERY_RESULT, _RENDERER = 0x8E28, 0x8866, 0x1F01  # of OpenGL
_SOFTWARE = re.compile("llvmpipe|softpipe|swrast|SwiftShader|Software", re.IGNORECASE)


def _loader():
    """The function that finds functions of OpenGL in this process; None without any."""
    for name, library, function in (
            ("OSMesa", "libOSMesa.so.8", "OSMesaGetProcAddress"),
            ("EGL", "libEGL.so.1", "eglGetProcAddress"),
            ("", "libGL.so.1", "glXGetProcAddressARB")):
        if name == backend():
            try:
                result = getattr(ctypes.CDLL(library), function)
            except (OSError, AttributeError):
                return None
            result.restype = ctypes.c_void_p
            result.argtypes = [ctypes.c_char_p]
            return result
    return None


class Timer:
    """Measures the time of the GPU between begin() and end(), in the current context."""

    def __init__(self):
        """Raises OSError where the functions cannot be found."""
        load = _loader()
        if load is None:
            raise OSError("no OpenGL library")

        def function(name, result, *arguments):
            address = load(name.encode())
            if not address:
                raise OSError("no %s" % name)
            return ctypes.CFUNCTYPE(result, *arguments)(address)

        unsigned = ctypes.c_uint
        self._counter = function("glQueryCounter", None, unsigned, unsigned)
        self._result = function("glGetQueryObjectui64v", None, unsigned, unsigned, ctypes.c_void_p)
        get_string = function("glGetString", ctypes.c_char_p, unsigned)
        self.renderer = (get_string(_RENDERER) or b"").decode("utf-8", "replace")
        generate = function("glGenQueries", None, ctypes.c_int, ctypes.c_void_p)
        self._queries = (unsigned * 2)()
        generate(2, ctypes.byref(self._queries))

    def is_software(self):
        """Whether the processor does the work of the GPU: then its time tells nothing new."""
        return bool(_SOFTWARE.search(self.renderer))

    def begin(self):
        self._counter(self._queries[0], _TIMESTAMP)

    def end(self):
        self._counter(self._queries[1], _TIMESTAMP)

    def seconds(self):
        """The time between begin() and end(), float. Waits for it."""
        values = []
        for query in self._queries:
            value = ctypes.c_uint64()
            self._result(query, _QUERY_RESULT, ctypes.byref(value))
            values.append(value.value)
        return 1e-9 * (values[1] - values[0])


def make_timer():
    """A Timer for the current context; None in software, or where there are no timer queries."""
    try:
        timer = Timer()
    except OSError:
        return None
    return None if timer.is_software() else timer
