# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is looked for when it is first asked for: values of a table, and classes of VTK."""

import importlib

# Render passes are in the second one up to VTK 9.6; VTK's master has moved some of them to the first.
_PASS_MODULES = ("vtkRenderingCore", "vtkRenderingOpenGL2")


def render_pass(name):
    """A class of VTK's render passes by its name, str, from the module that has it. Raises ImportError."""
    for module in _PASS_MODULES:
        found = getattr(importlib.import_module("vtkmodules." + module), name, None)
        if found is not None:
            return found
    raise ImportError("VTK has no %s in %s" % (name, " or ".join(_PASS_MODULES)))


class LazyTable:
    """Maps keys to find(table[key]); each value is found once."""

    def __init__(self, table, find):
        """table: dict; find: function of a table's value."""
        self._table = table
        self._find = find
        self._found = {}

    def get(self, key):
        """The value found for a key, None for an unknown key."""
        if key not in self._found:
            value = self._table.get(key)
            self._found[key] = None if value is None else self._find(value)
        return self._found[key]
