# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What drew a frame: the method that was asked for, or another one in its place, and why."""

import re

from .errors import watch

_UNSORTED = "unsorted blending"
# What a pass says before the reason when another one draws.
_CONSEQUENCE = re.compile(r"^(Rendered by [^:]*|Translucent props are blended unsorted)[:;]\s*")


class Drawn:
    """Looks after a pass from before its first frame."""

    def __init__(self, method, instance):
        """method: str, its name. instance: vtkOITPass, its pass, with its properties set."""
        self._method = method
        self._instance = instance
        self._own = instance.GetAlgorithmName()
        self._warnings, _ = watch(instance, "WarningEvent")

    def by(self):
        """The name of the algorithm that drew the last frame, str."""
        return self._instance.GetAlgorithmName()

    def unsorted(self):
        """Whether no method could draw the last frame in the right order, bool."""
        return self.by() == _UNSORTED

    def why_other(self, window):
        """Why another method drew the last frame, str in one line; empty when the method itself did.

        window: the vtkRenderWindow of that frame.
        """
        # The method auto takes the name of what it chose.
        if self.by() == self._own or (self._method == "auto" and not self.unsorted()):
            return ""
        missing = " ".join(self._instance.GetMissingCapability(window).split())
        told = self._warnings[-1] if self._warnings else "no reason given"
        return missing or _CONSEQUENCE.sub("", told).rstrip(".")

    def warning(self, window):
        """One line, str, that says why another method drew and which, or what the pass says of a frame that is
        not exact; empty for neither."""
        reason = self.why_other(window)
        if not reason:
            return "" if self._instance.GetExact() or not self._warnings else self._warnings[-1].rstrip(".")
        return "the method %s does not run here (%s); drawn by %s%s" % (
            self._method, reason, self.by(), ", which is not exact" if self.unsorted() else "")
