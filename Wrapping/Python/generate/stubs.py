# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the type stubs of a wrapped module: python3 stubs.py MODULE FILE, such as vtkoit.vtkOIT.

VTK's wrappers have the signatures in the documentation of each method: one line an overload,
"Name(self, argument:type) -> type", each followed by one of C++.
"""

import importlib
import inspect
import re
import sys

HEAD = """# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
# Made by Wrapping/Python/generate/stubs.py from the documentation of the wrapped classes.
from typing import Any, Callable, MutableSequence, Sequence, final, overload

"""
SIGNATURE = re.compile(r"^(?P<name>\w+)\((?P<arguments>.*)\) *-> *(?P<result>.+)$")
BUILTIN = {"bool", "int", "float", "str", "bytes", "None", "Any"}


def type_of(text, used):
    """A type as the documentation writes it, as Python's: arrays are (float, float) or [float, ...]."""
    text = text.strip()
    if text.startswith("(") or text.startswith("["):
        inner = [part.strip() for part in text[1:-1].split(",") if part.strip() not in ("", "...")]
        kinds = sorted({type_of(part, used) for part in inner}) or ["Any"]
        kind = "MutableSequence" if text[0] == "[" else "Sequence"
        return "%s[%s]" % (kind, kinds[0] if len(kinds) == 1 else "Any")
    if text in ("callback", "function"):
        return "Callable[..., Any]"
    if text in BUILTIN:
        return text
    if not re.fullmatch(r"[\w.]+", text) or text in ("void", "char"):
        return "Any"
    if text[0].islower() and not text.startswith("vtk") or text == "Pointer":
        return "Any"
    used.add(text)
    return text


def split_arguments(text):
    """The arguments of a signature, list of str; commas inside of brackets do not count."""
    depth, parts = 0, [""]
    for char in text:
        depth += (char in "([") - (char in ")]")
        if char == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += char
    return [part.strip() for part in parts if part.strip()]


def signatures(name, method, used):
    """The lines of a method, list of (str, bool): arguments and result, and whether it is static."""
    for line in (method.__doc__ or "").splitlines():
        found = SIGNATURE.match(line)
        if not found or found["name"] != name:
            continue
        arguments, is_static = [], True
        for number, argument in enumerate(split_arguments(found["arguments"])):
            if argument == "self":
                is_static = False
                arguments.append("self")
                continue
            word, _, kind = argument.partition(":")
            kind, equals, default = kind.partition("=")
            word = word if word.isidentifier() and word not in ("None", "in", "from") else "argument%d" % number
            arguments.append("%s: %s%s" % (word, type_of(kind or "Any", used), " = ..." if equals else ""))
        yield "(%s) -> %s: ..." % (", ".join(arguments), type_of(found["result"], used)), is_static


def lines_of(cls, used):
    """The stub of a class, list of str."""
    base = cls.__bases__[0].__name__
    used.add(base)
    body = []
    for name, member in sorted(vars(cls).items()):
        if name.startswith("__"):
            continue
        if isinstance(member, type):
            body += ["    @final", "    class %s(int): ..." % name]
        elif inspect.isdatadescriptor(member):  # properties, from VTK 9.4 on
            body.append("    %s: Any" % name)
        elif isinstance(member, int):
            kind = type(member).__name__
            body.append("    %s: %s" % (name, kind if kind in vars(cls) else "int"))
        else:
            found = list(dict.fromkeys(signatures(name, member, used)))
            for text, is_static in found:
                if len(found) > 1:
                    body.append("    @overload")
                if is_static:
                    body.append("    @staticmethod")
                body.append("    def %s%s" % (name, text))
    return ["class %s(%s):" % (cls.__name__, base)] + (body or ["    ..."]) + [""]


def home_of(name):
    """The module of VTK that has a class, str, or None."""
    for module in ("vtkCommonCore", "vtkCommonDataModel", "vtkRenderingCore", "vtkRenderingOpenGL2"):
        if hasattr(importlib.import_module("vtkmodules." + module), name):
            return "vtkmodules." + module
    return None


def ancestors_first(classes):
    return sorted(classes, key=lambda cls: (len(cls.__mro__), cls.__name__))


def main(module, path):
    used = set()
    own = [value for name, value in vars(importlib.import_module(module)).items()
           if name.startswith("vtk") and isinstance(value, type)]
    body = []
    for cls in ancestors_first(own):
        body += lines_of(cls, used)
    imports = []
    names = {cls.__name__ for cls in own}
    nested = {name for cls in own for name, value in vars(cls).items() if isinstance(value, type)}
    for name in sorted(used - names - nested):
        home = home_of(name) if name.isidentifier() else None
        if home:
            imports.append("from %s import %s" % (home, name))
        else:
            imports.append("%s = Any" % name)
    text = HEAD + "\n".join(imports + [""] + body)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.rstrip("\n") + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
