# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that docs/troubleshooting.md lists every message that the libraries, the Python package
and the command line can print.

    python3 Utilities/check_messages.py [--list]

A message is taken for listed when each of its literal parts is in the page; what is put in between
(names, numbers) is written as … there. In C++ every literal of the modules that reads like a
sentence counts as a message, in Python the arguments of raised exceptions and of calls to fail().
"""

import ast
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "troubleshooting.md"
SHORTEST = 20  # characters; shorter parts, such as " of ", say nothing

LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
PERCENT = re.compile(r"%(?:\(\w+\))?[-+ #0-9.]*[a-zA-Z]")
# GLSL in C++ strings, printf formats and PrintSelf labels are not sentences.
NO_SENTENCE = re.compile(r"//VTK|^\s*#|[{}=]|\bgl_|\bvec\d|: $|GL_[A-Z]{3}")

# What VTK's object factories show in a list of factories.
NO_MESSAGES = {
    "render window of OSMesa",
    "interactor without a window system",
    "vtkOIT: hooks into every renderer",
    "vtkOIT: rendering without a display through OSMesa",
}


def cxx_messages(text):
    """Literals that read like sentences; adjacent ones are joined, as the compiler does."""
    strings = []
    text = re.sub(
        LITERAL.pattern + "|" + COMMENT.pattern,
        lambda match: match.group(0) if match.group(0).startswith('"') else " ",
        text,
        flags=re.DOTALL,
    )
    end = None
    for match in LITERAL.finditer(text):
        if end is not None and not text[end : match.start()].strip():
            strings[-1] += match.group(1)
        else:
            strings.append(match.group(1))
        end = match.end()
    for string in strings:
        string = string.replace('\\"', '"').replace("\\n", " ")
        if string in NO_MESSAGES or NO_SENTENCE.search(string):
            continue
        if len(string.split()) >= 4:
            yield [string]


def python_messages(text):
    """The literal parts of what is raised or given to fail()."""
    for node in ast.walk(ast.parse(text)):
        call = node.exc if isinstance(node, ast.Raise) else node
        if not isinstance(call, ast.Call) or not call.args:
            continue
        name = getattr(call.func, "id", getattr(call.func, "attr", ""))
        if isinstance(node, ast.Raise) or name.lstrip("_") == "fail":
            yield [
                part
                for argument in call.args
                for literal in ast.walk(argument)
                if isinstance(literal, ast.Constant) and isinstance(literal.value, str)
                for part in PERCENT.split(literal.value)
            ]


def messages():
    """Pairs of file and the literal parts of a message."""
    for file in sorted((ROOT / "vtkOIT").rglob("*.cxx")):
        for parts in cxx_messages(file.read_text(encoding="utf-8")):
            yield file.relative_to(ROOT), parts
    for file in sorted((ROOT / "Wrapping" / "Python").rglob("*.py")):
        for parts in python_messages(file.read_text(encoding="utf-8")):
            yield file.relative_to(ROOT), parts


def main(arguments):
    page = " ".join(PAGE.read_text(encoding="utf-8").split())
    missing = 0
    for file, parts in messages():
        if "--list" in arguments:
            print(f"{file}: {' … '.join(part.strip() for part in parts)}")
            continue
        for part in parts:
            part = " ".join(part.split()).strip(".;:, ")
            if len(part) >= SHORTEST and part not in page:
                print(f"{file}: not in {PAGE.relative_to(ROOT)}: {part}", file=sys.stderr)
                missing += 1
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
