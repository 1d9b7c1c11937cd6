# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page docs/what-vtk-gets-wrong.md."""

import os

from ..bench.document import table
from ..errors import Error
from . import program

PAGE = "what-vtk-gets-wrong.md"

HOW = """All draw into a window of 8 bits a channel, over a background of alpha 0.4, without multisampling unless a comparison names the
samples. A comparison is wrong when a channel of some pixel is off by more than the test allows and three steps of 255 on top, so that
rounding alone is not called wrong. Cells give the largest error of a colour channel and of alpha, in [0, 1], and how many of the
comparisons are wrong. Coincident faces of different colours may be in any order here. Left out are float framebuffers and what needs
them (16 to 19, 33), and rules and properties of vtkOIT's own (15, 29, 30, 34, 37, 38)."""

_HEAD = """# What VTK's own passes get wrong

Made by `{command}`, not written by hand. VTK {vtk}, OpenGL renderer {renderer}.

The scenes are those of [the stress suite](stress-tests.md), with the same answers. Contenders:

{contenders}

"""


def about(contender):
    """One line, str, about a contender."""
    return program.VTK.get(contender, "vtkOIT's method `%s` in the same place" % contender)


def write(folder, verdict, machine, command):
    """Writes the page into a folder, str. Raises Error. verdict: verdict.Verdict. machine: dict, as from
    bench.machine.describe(). command: str, that makes the page."""
    parts = [_HEAD.format(
        command=command, vtk=machine["vtk"], renderer=machine["renderer"],
        contenders="\n".join("- `%s`: %s." % (name, about(name)) for name in verdict.contenders)) + HOW,
        table(*verdict.matrix()), "## The largest colour errors"]
    for contender in verdict.contenders:
        head, rows = verdict.worst(contender)
        if rows:
            parts += ["`%s`; the worst comparison of a number and test, at most %d:" % (contender, 12),
                      table(head, rows)]
    if verdict.problems:
        parts += ["## Tests that did not end", "\n".join(
            "- %(test)s, `%(contender)s`: %(problem)s" % line for line in verdict.problems)]
    path = os.path.join(folder, PAGE)
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n\n".join(parts) + "\n")
    except OSError as error:
        raise Error("%s: cannot be written: %s" % (path, error.strerror)) from None
