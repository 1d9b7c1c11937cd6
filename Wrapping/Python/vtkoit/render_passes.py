# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The translucent stage of pyvista-render-passes, drawn by vtkOIT.

pyvista-render-passes finds TranslucentStage by its entry point and asks it for a pass whenever it builds
the chain of passes of a subplot. Its settings are those of `plotter.render_passes.get_state()` and
`set_state()`, below providers and "vtkoit".
"""

import json

from .passes import create


class TranslucentStage:
    """A provider in the sense of pyvista-render-passes; it asks for the protocol, not for a class."""

    name = "vtkoit"
    stages = ("translucent",)

    def __init__(self):
        self._state = self.default_state()
        self._invalidate = None

    def build_pass(self, stage, renderer, chain, delegate):  # pylint: disable=unused-argument
        """A new pass (vtkOITPass) for the stage, or None when switched off."""
        if stage not in self.stages or not self._state["enabled"]:
            return None
        return create(self._state["method"], **self._state["properties"])

    def bind(self, invalidate):
        """invalidate: a function that asks for a new chain, or None when the provider is removed."""
        self._invalidate = invalidate

    @staticmethod
    def default_state():
        """dict: enabled (bool), method (str, one of vtkoit.methods()), properties (dict, as for
        vtkoit.create())."""
        return {"enabled": True, "method": "auto", "properties": {}}

    def get_state(self):
        """The settings, a dict that can be written as JSON."""
        return json.loads(json.dumps(self._state))

    def set_state(self, state):
        """Sets what the dict has; the rest keeps its value. Raises ValueError, and changes nothing, for
        an unknown setting, method, property or value."""
        unknown = sorted(set(state) - set(self._state))
        if unknown:
            raise ValueError("unknown setting %r; the settings are: %s" % (unknown[0], ", ".join(self._state)))
        new = json.loads(json.dumps({**self._state, **state}))
        create(new["method"], **new["properties"])  # raises where something is wrong
        self._state = new
        if self._invalidate is not None:
            self._invalidate()

    @staticmethod
    def veto(settings):  # pylint: disable=unused-argument
        """None: all settings of the other passes are fine."""
        return None
