# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""All scenes by name, and what a user's --scenes says."""

import fnmatch
import os

from ..errors import Error
from . import clouds, data, families, sciviz

QUICK = ("one-sphere", "spheres", "layers-16", "hull")


def all_scenes():
    """Every scene there is here, list of Scene."""
    return sciviz.scenes() + data.scenes() + clouds.scenes() + families.scenes() + clouds.family_scenes()


def choose(names, quick=False):
    """The scenes of a list of str: names, patterns such as layers-*, families such as layers (volumes for all of
    volumes-60, volumes-240, ...), or files; None for all, or with quick for a few. list of Scene. Raises Error."""
    every = all_scenes()
    if names is None:
        return [scene for scene in every if scene.name in QUICK] if quick else every
    result = []
    for name in names:
        found = [scene for scene in every
                 if fnmatch.fnmatchcase(scene.name, name) or ((scene.family or "") + "-").startswith(name + "-")]
        if not found and os.path.exists(name):
            found = [data.file_scene(name)]
        if not found:
            raise Error("--scenes %s: no such scene or file; --list tells what there is" % name)
        result += [scene for scene in found if scene.name not in [s.name for s in result]]
    return result
