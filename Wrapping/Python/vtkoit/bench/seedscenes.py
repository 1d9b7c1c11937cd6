# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes like those of the documents that the project implements, which are not published: quads of grass
and of leaves, two buildings, meshes one behind the other, stacks of planes."""

import math

import numpy

from .. import camera, colors
from . import families, scans
from .scene import Part, Scene, append, facing, mesh, quads, sphere

QUADS = 192  # of grass and leaves: 384 triangles


def buildings():
    """Those of multi-layer peeling: grass, a tree, a courtyard and a cathedral, list of Scene."""
    return [
        Scene("grass", "quads of grass", _grass, _level),
        Scene("tree", "quads of leaves", _tree, _level),
        Scene("courtyard", "columns and walls around a court", _courtyard, _level),
        Scene("cathedral", "columns, walls and a dome", _cathedral, _level),
    ]


def dragons():
    """Three meshes, one behind the other, in three colours, Scene."""
    def make():
        mine = scans.scenes()[0].make()[0].data
        step = 0.15 * mine.GetLength()
        return [Part(_moved(mine, (step * i, 0.0, -step * i)), color, 0.4)
                for i, color in enumerate(((0.2, 0.3, 0.9), (0.3, 0.8, 0.3), (0.9, 0.25, 0.2)))]

    return Scene("dragons", "three meshes, one behind the other", make, camera.place)


def see_through(opacities):
    """The first mesh of scans.py with an opacity, or several of them with one each, Scene. opacities: list
    of float."""
    def make():
        mine = scans.scenes()[0].make()[0].data
        length = mine.GetLength()
        return [Part(_moved(mine, (0.1 * i * length, 0.0, -0.1 * i * length)), colors.palette_color(i), opacity)
                for i, opacity in enumerate(opacities)]

    return Scene("see-through-%s" % "-".join("%g" % o for o in opacities), "a mesh seen through itself", make,
                 camera.place)


def planes(number):
    """Planes behind each other over half the window, Scene."""
    return Scene("planes-%d" % number, "planes behind each other",
                 lambda: families.stack(number, 0.5, 0.8, 0.1), lambda renderer: facing(renderer, 1.0))


def _level(renderer):
    """Looks from the height of the scene's middle."""
    view = renderer.GetActiveCamera()
    view.SetPosition(0.4, 0.55, 6.0)
    view.SetFocalPoint(0.0, 0.5, 0.0)
    view.SetViewAngle(24.0)
    renderer.ResetCameraClippingRange()


def _moved(data, by):
    from vtkmodules.vtkCommonTransforms import vtkTransform
    from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

    place = vtkTransform()
    place.Translate(*by)
    moved = vtkTransformPolyDataFilter()
    moved.SetTransform(place)
    moved.SetInputData(data)
    moved.Update()
    return moved.GetOutput()


def _leaves(centers, half, sideways):
    """Quads around centers, array n x 3, each turned around the vertical by an angle, array n."""
    across = half * numpy.stack([numpy.cos(sideways), 0 * sideways, numpy.sin(sideways)], axis=1)
    up = numpy.array([0.0, half, 0.0])
    corners = numpy.stack([centers - across - up, centers + across - up, centers + across + up,
                           centers - across + up], axis=1)
    third = len(corners) // 3
    return [Part(quads(corners[i * third:(i + 1) * third]), color, 0.35)
            for i, color in enumerate(((0.2, 0.6, 0.2), (0.5, 0.7, 0.2), (0.1, 0.45, 0.25)))]


def _grass():
    random = numpy.random.RandomState(6)
    centers = random.uniform((-1, 0.4, -1), (1, 0.6, 1), (QUADS, 3))
    return _leaves(centers, 0.26, random.uniform(-0.6, 0.6, QUADS))


def _tree():
    random = numpy.random.RandomState(7)
    direction = random.normal(size=(QUADS, 3))
    centers = direction / numpy.linalg.norm(direction, axis=1, keepdims=True) * \
        random.uniform(0.2, 1.0, (QUADS, 1)) ** 0.5 + (0.0, 0.5, 0.0)
    return _leaves(centers, 0.28, random.uniform(-1.5, 1.5, QUADS))


def _column(x, z, radius=0.04, height=1.0, sides=10, rings=4):
    angles = numpy.linspace(0, 2 * math.pi, sides, endpoint=False)
    points = [(x + radius * math.cos(a), height * ring / rings, z + radius * math.sin(a))
              for ring in range(rings + 1) for a in angles]
    cells = [(ring * sides + i, ring * sides + (i + 1) % sides, (ring + 1) * sides + (i + 1) % sides,
              (ring + 1) * sides + i) for ring in range(rings) for i in range(sides)]
    return mesh(points, cells)


def _wall(start, end, height=1.0, steps=12):
    start, end = numpy.array(start, dtype=float), numpy.array(end, dtype=float)
    places = [start + (end - start) * i / steps for i in range(steps + 1)]
    points = [(p[0], height * j / steps, p[1]) for j in range(steps + 1) for p in places]
    row = steps + 1
    return mesh(points, [(a, a + 1, a + row + 1, a + row) for a in
                         (j * row + i for j in range(steps) for i in range(steps))])


def _courtyard():
    """Four rows of columns on each side, and walls in front of and behind them."""
    sides = numpy.linspace(-1, 1, 11)
    columns = [_column(x, z) for distance in (0.5, 0.7, 0.9, 1.1) for t in sides
               for x, z in ((t, distance), (t, -distance), (distance, t), (-distance, t))]
    walls = []
    for distance in (0.4, 1.2):
        d = distance
        walls += [_wall((-d, -d), (d, -d)), _wall((d, -d), (d, d)), _wall((d, d), (-d, d)),
                  _wall((-d, d), (-d, -d))]
    return [Part(append(columns), (0.8, 0.7, 0.5), 0.35), Part(append(walls), (0.6, 0.5, 0.45), 0.3)]


def _cathedral():
    """A nave between four rows of columns, two walls on each side, and a dome of two shells."""
    columns = [_column(x, z, 0.05, sides=14) for x in (-0.6, -0.3, 0.3, 0.6)
               for z in numpy.linspace(-1.5, 1.5, 18)]
    walls = [_wall((x, -1.6), (x, 1.6)) for x in (-0.9, -0.8, 0.8, 0.9)] + \
        [_wall((-0.9, z), (0.9, z)) for z in (-1.6, 1.6)]
    dome = [sphere((0, 1.1, 0), radius, 36) for radius in (0.5, 0.55)]
    return [Part(append(columns), (0.75, 0.72, 0.65), 0.35), Part(append(walls), (0.7, 0.6, 0.5), 0.3),
            Part(append(dome), (0.35, 0.5, 0.6), 0.3)]
