# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Starting a program that knows nothing of vtkOIT so that vtkOIT draws its translucent props."""

import os
import shutil
import sys

from .errors import Error
from .passes import methods
from .version import LIBRARIES

# Programs whose chain of passes is where only LD_PRELOAD gets at it.
_PRELOADED = ("f3d",)
# Programs in which users switch depth peeling themselves, per view.
_SWITCHED = ("paraview", "pvpython", "pvbatch", "pvserver", "pvrenderserver", "pvdataserver")


def run(command, method=None, respect=False, log=False, preload=None):
    """Replaces this process by a program.

    command: list of str, the program and its arguments. method: str or None for that of the
    environment. respect: bool, whether depth peeling of a renderer switches vtkOIT. log: bool.
    preload: bool, or None for what is known of the program. Raises Error.
    """
    if not command:
        raise Error("give the program to run, such as: vtkoit run mayavi2")
    program = shutil.which(command[0])
    if program is None:
        raise Error("%s: no such program" % command[0])
    variables = environment(command[0], method, respect, log, preload)
    sys.stdout.flush()
    try:
        os.execve(program, command, variables)
    except OSError as error:
        raise Error("%s: cannot be run: %s" % (command[0], error.strerror)) from None


def environment(program, method=None, respect=False, log=False, preload=None):
    """The variables for a program, dict of str to str; as run(). Raises Error."""
    name = os.path.basename(program)
    if method is not None and method not in methods():
        raise Error("method %s: unknown; the methods are: %s" % (method, " ".join(methods())))
    result = dict(os.environ)
    _put_first(result, "VTK_AUTOLOAD_PATH", os.path.dirname(_library("autoload", "libvtkOITAutoload.so")))
    if method is not None:
        result["VTKOIT_METHOD"] = method
    if respect or (name in _SWITCHED and not result.get("VTKOIT_AUTOLOAD")):
        result["VTKOIT_AUTOLOAD"] = "respect"
    if log:
        result["VTKOIT_LOG"] = "1"
    if name in _PRELOADED if preload is None else preload:
        _put_first(result, "LD_PRELOAD", _library("preload", "libvtkOITPreload.so"))
    return result


def _library(folder, name):
    """The path of one of the libraries that hook into programs."""
    if not sys.platform.startswith("linux"):
        raise Error("run needs Linux; in a Python script call vtkoit.install_everywhere()")
    here = os.path.dirname(os.path.realpath(__file__))
    path = os.path.normpath(os.path.join(here, LIBRARIES, folder, name))
    if not os.path.isfile(path):
        raise Error("%s is missing; build vtkOIT with BUILD_SHARED_LIBS=ON, or install it anew" % path)
    return path


def _put_first(variables, name, entry):
    """Puts an entry in front of a list in the environment."""
    others = [each for each in variables.get(name, "").split(":") if each and each != entry]
    variables[name] = ":".join([entry, *others])
