# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong in the comparisons of passes, as tables."""

import collections

WORST_CASES = 12  # in the tables of a contender's largest errors
_CHANNELS = (("color", "colour"), ("alpha", "alpha"))


class Verdict:
    """The comparisons (list of dict, as from program.run()) of contenders (list of str) in scenes (dict of
    number to scenes.Stress)."""

    def __init__(self, scenes, contenders, lines):
        self.scenes = scenes
        self.contenders = contenders
        self.problems = [line for line in lines if "problem" in line]
        self.by_cell = collections.defaultdict(list)
        for line in lines:
            if line.get("number") in scenes:
                self.by_cell[line["number"], line["contender"]].append(line)

    def matrix(self):
        """(head, rows): scenes by contenders, lists of str; a cell is "right", or how wrong it is."""
        rows = []
        for number, scene in sorted(self.scenes.items()):
            cells = [cell(self.by_cell[number, contender]) for contender in self.contenders]
            if any(text != "-" for text in cells):
                rows.append([str(number), scene.title] + cells)
        return ["no.", "scene"] + self.contenders, rows

    def worst(self, contender):
        """(head, rows): the worst comparison of a contender for each scene and test, by its error of colour."""
        wrong = {}
        for (number, other), lines in self.by_cell.items():
            for line in lines if other == contender else ():
                key = (number, line["test"])
                if is_wrong(line, "color") and (key not in wrong or line["color"] > wrong[key]["color"]):
                    wrong[key] = line
        ranked = sorted(wrong.items(), key=lambda item: -item[1]["color"])[:WORST_CASES]
        return ["error", "no.", "test", "comparison"], [
            [error_text(line["color"]), str(number), test, line["what"]] for (number, test), line in ranked]

    def shown(self, number):
        """The comparison of a scene that has pictures and the largest excess of colour of any contender: a dict
        of contender to comparison; empty when there is none."""
        lines = [line for contender in self.contenders for line in self.by_cell[number, contender]
                 if line["picture"]]
        if not lines:
            return {}
        key = max(lines, key=lambda line: line["color"] - line["allowed_color"])["key"]
        return {line["contender"]: line for line in lines if line["key"] == key}


def is_wrong(line, channel):
    return line[channel] > line["allowed_" + channel]


def error_text(error):
    return "not finite" if error >= 1e30 else "%.3f" % error if error >= 0.0005 else "%.1g" % error


def cell(lines):
    """What a contender makes of a scene, str. lines: its comparisons, list of dict."""
    if not lines:
        return "-"
    parts = []
    for channel, name in _CHANNELS:
        wrong = [line[channel] for line in lines if is_wrong(line, channel)]
        if wrong:
            parts.append("%s %s (%d/%d)" % (name, error_text(max(wrong)), len(wrong), len(lines)))
    return ", ".join(parts) or "right"
