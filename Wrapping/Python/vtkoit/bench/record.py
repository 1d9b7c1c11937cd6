# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is kept of a method in a scene: one flat dict, whose keys are those of tables.COLUMNS."""

from . import accuracy


def make(facts, name, right, measured):
    """The result of a measure.Measured, dict that JSON can hold, and its worst picture, array of uint8,
    height x width x 3, or None.

    facts: dict, as from Stage.facts(). name: str, the contender's. right: the truth, dict with the
    fields of truth.Truth.
    """
    result = {**facts, "method": name, "reason": measured.reason, "truth": right["source"],
              "truth_fragments": int(right["fragments"]), "truth_layers": int(right["layers"]),
              "cross_check": right["cross_check"]}
    result.update(measured.timing or {})
    if measured.statistics is not None:
        result.update(measured.statistics._asdict())
    color = None
    if measured.colors:
        errors = [accuracy.measure(c, right["color"], right["covered"]) for c in measured.colors]
        worst = max(range(len(errors)), key=lambda i: (errors[i].max, errors[i].rmse))
        color = measured.colors[worst]
        result.update(errors[worst]._asdict())
    if measured.alpha is not None:
        errors = accuracy.measure(measured.alpha, right["alpha"], right["covered"])
        result.update({"alpha_" + key: value for key, value in errors._asdict().items()})
    return result, color


def not_run(reason):
    """A measure.Measured of what was not rendered, for a reason, str."""
    from .measure import Measured

    return Measured(None, None, [], None, reason)
