# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Results on disk, one file for each scene and method, so that an interrupted run can go on.

A result is taken again only when it was measured with the same configuration: the same build, machine,
renderer, size and number of frames.
"""

import json
import os
import re

import numpy

from .. import picture
from ..errors import Error


def slug(name):
    """A name as a file's name, str."""
    return re.sub(r"[^A-Za-z0-9.=-]+", "_", name).strip("_.") or "_"


class Store:
    """The folder of results below an output folder."""

    def __init__(self, folder, configuration):
        """folder: str, made if missing. configuration: dict that JSON can hold. Raises Error."""
        self.folder = os.path.join(folder, "results")
        self.configuration = configuration
        self.outdated = set()
        try:
            os.makedirs(self.folder, exist_ok=True)
        except OSError as error:
            raise Error("%s: cannot be made: %s" % (self.folder, error.strerror)) from None

    def path(self, scene, name):
        """The path of a file of a scene (str), str."""
        return os.path.join(self.folder, slug(scene), name)

    def load(self, scene, method, size):
        """The result of a scene and a method (str), dict, or None when it must be measured."""
        try:
            with open(self.path(scene, slug(method) + ".json"), encoding="utf-8") as file:
                kept = json.load(file)
            result = kept["result"]
        except FileNotFoundError:
            return None
        except (OSError, ValueError, KeyError, TypeError):
            self.outdated.add("damaged files")
            return None
        if kept.get("configuration") != self._with(size):
            for key, value in self._with(size).items():
                if kept.get("configuration", {}).get(key) != value:
                    self.outdated.add(key)
            return None
        return result

    def save(self, scene, method, size, result, color=None):
        """Keeps a result (dict) and, where there is one, its picture (array of uint8, height x width
        x 3)."""
        base = self.path(scene, slug(method))
        os.makedirs(os.path.dirname(base), exist_ok=True)
        if color is not None:
            picture.save(color, base + ".png")
        with open(base + ".json.part", "w", encoding="utf-8") as file:
            json.dump({"configuration": self._with(size), "result": result}, file, indent=1)
        os.replace(base + ".json.part", base + ".json")

    def picture(self, scene, method):
        """The kept picture, array of uint8, height x width x 3; None without one."""
        path = self.path(scene, slug(method) + ".png")
        return read_png(path) if os.path.exists(path) else None

    def load_truth(self, scene, size):
        """What save_truth() kept, dict; None when it must be found again."""
        path = self.path(scene, "truth.npz")
        try:
            with numpy.load(path, allow_pickle=False) as file:
                kept = {name: file[name] for name in file.files}
            facts = json.loads(str(kept.pop("facts")))
        except (OSError, ValueError, KeyError):
            return None
        if facts.pop("configuration", None) != self._with(size):
            return None
        return {**kept, **facts}

    def save_truth(self, scene, size, arrays, facts):
        """Keeps the right picture: arrays (dict of str to array) and facts (dict)."""
        path = self.path(scene, "truth.npz")
        os.makedirs(os.path.dirname(path), exist_ok=True)
        text = json.dumps({**facts, "configuration": self._with(size)})
        numpy.savez_compressed(path + ".part.npz", facts=numpy.array(text), **arrays)
        os.replace(path + ".part.npz", path)

    def _with(self, size):
        return {**self.configuration, "size": list(size)}


def read_png(path):
    """A PNG file as an array of uint8, height x width x components, top row first."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(os.fsencode(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[::-1].copy()
