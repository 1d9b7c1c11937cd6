# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the completion of the command line for a shell: python3 completion.py SHELL FILE.

shtab makes it of the parser of argparse; what files and methods are, only this script knows.
"""

import argparse
import sys

import shtab
from vtkoit.bench.contenders import VTK
from vtkoit.options import parser
from vtkoit.passes import methods

FILES = ("inputs", "scenes", "program")
FOLDERS = ("document",)
METHODS = {"method": methods(), "methods": list(VTK) + methods()}


def describe(options):
    """Says of each option what may stand behind it. options: argparse.ArgumentParser."""
    for action in options._actions:  # pylint: disable=protected-access
        if action.help and action.help != argparse.SUPPRESS:
            action.help %= dict(vars(action), prog=options.prog)
        if isinstance(action, argparse._SubParsersAction):  # pylint: disable=protected-access
            for command in action.choices.values():
                describe(command)
        elif action.dest in FILES or (action.dest == "output" and action.metavar == "FILE"):
            action.complete = shtab.FILE
        elif action.dest in FOLDERS or action.dest == "output":
            action.complete = shtab.DIRECTORY
        elif action.dest in METHODS:
            # A function of the shell, since shtab 1.5 completes only the first one of an argument's choices.
            action.complete = {"bash": "_vtkoit_" + action.dest,
                               "zsh": "(%s)" % " ".join(METHODS[action.dest])}


def main(shell, path):
    options = parser("vtkoit")
    describe(options)
    functions = ["_vtkoit_%s() { local IFS=' '; compgen -W '%s' -- \"$1\"; }" % (name, " ".join(names))
                 for name, names in METHODS.items()]
    text = shtab.complete(options, shell, preamble={"bash": "\n".join(functions)})
    with open(path, "w", encoding="utf-8") as file:
        file.write(text + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
