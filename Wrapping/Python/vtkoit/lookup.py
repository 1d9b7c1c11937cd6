# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""A table whose values are looked for when they are first asked for."""


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
