# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the user's files hold, as it is drawn: surfaces and volumes."""

import collections

from .read import read_all
from .surfaces import make_surfaces
from .volumes import make_volumes

Contents = collections.namedtuple("Contents", "surfaces volumes notes")
Contents.__doc__ = """surfaces: list of surfaces.Surface. volumes: list of volumes.Volume. notes: list of str, what was
chosen for the user."""


def load(paths, options, progress):
    """The Contents of files. paths: list of str. options: render.SceneOptions. Raises Error."""
    inputs = read_all(paths, progress, options.raw, options.spacing)
    volumes, notes = [], []
    if options.volume is not None:
        progress.begin("volumes")
        volumes, notes = make_volumes(inputs, options.volume)
    surfaces, others = make_surfaces(inputs, options.request, progress, options.volume is not None)
    return Contents(surfaces, volumes, notes + others)


def count(contents):
    """How many there are of each, str: "1 volume, 2 surfaces"; no volumes are not told."""
    numbers = [(len(contents.volumes), "volume")] if contents.volumes else []
    numbers.append((len(contents.surfaces), "surface"))
    return ", ".join("%d %s%s" % (number, what, "s"[:number != 1]) for number, what in numbers)
