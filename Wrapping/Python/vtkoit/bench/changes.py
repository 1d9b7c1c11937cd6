# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What data cost that change from frame to frame: frames with a change beside frames of the same camera without one."""

import collections

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..errors import Error, capture
from . import catalogue, rounds
from .document import table
from .measure import REFERENCE
from .scene import sphere
from .stage import Stage

PAGE = "changing-data.md"
METHODS = ("abuffer", "auto")
SCENE = "spheres"
WARM_UP = 6

Change = collections.namedtuple("Change", "name title apply")
Change.__doc__ = """name, title: str. apply: function of a list of vtkActor and the number of a frame, which changes the actors
before the frame."""


def _scale(actors, number):
    for actor in actors:
        points = actor.GetMapper().GetInput().GetPoints()
        vtk_to_numpy(points.GetData())[:] *= 1.001 if number % 2 else 1.0 / 1.001
        points.GetData().Modified()
        points.Modified()


def _dent(actors, number):
    for actor in actors:
        points = actor.GetMapper().GetInput().GetPoints()
        vtk_to_numpy(points.GetData())[::7] *= 0.97 if number % 2 else 1.0 / 0.97
        points.GetData().Modified()
        points.Modified()


def _replace(actors, _):
    for actor in actors:
        copy = vtkPolyData()
        copy.DeepCopy(actor.GetMapper().GetInput())
        actor.GetMapper().SetInputData(copy)


def _grow(actors, number):
    actors[number % len(actors)].GetMapper().SetInputData(sphere((0, 0, 0), 0.5, 32 + number % 8))


def _color(actors, number):
    for actor in actors:
        data = actor.GetMapper().GetInput()
        values = numpy.linspace(0.0, 1.0, data.GetNumberOfPoints()) * (1.0 + 0.01 * (number % 5))
        data.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
        actor.GetMapper().ScalarVisibilityOn()


def _look_up(actors, number):
    for actor in actors:
        mapper = actor.GetMapper()
        if not mapper.GetScalarVisibility():
            _color([actor], 0)
            mapper.SetLookupTable(vtkLookupTable())
        mapper.SetScalarRange(0.0, 1.0 + 0.01 * (number % 5))


def _move(actors, number):
    for actor in actors:
        actor.SetPosition(0.001 * (number % 5), 0.0, 0.0)


def _fade(actors, number):
    for actor in actors:
        actor.GetProperty().SetOpacity(0.4 + 0.01 * (number % 5))


def _hide(actors, number):
    actors[0].SetVisibility(number % 2 == 0)


CHANGES = (
    Change("points", "all points move, closed convex meshes stay so", _scale),
    Change("dents", "some points move, the meshes are not convex", _dent),
    Change("series", "new data of each mesh, as read from a file", _replace),
    Change("growth", "one mesh has other triangles", _grow),
    Change("scalars", "other values at all points", _color),
    Change("lookup-table", "another range of the lookup table", _look_up),
    Change("moved", "all props move", _move),
    Change("opacity", "another opacity of all props", _fade),
    Change("visibility", "a prop comes and goes", _hide),
)
QUICK = CHANGES[:2]


class _Pair:
    """A method twice: whose data change, and whose data rest."""

    def __init__(self, stage, name, change):
        self.change = change
        self.contenders = [stage.contender(name) for _ in range(2)]
        self.times = [[], []]
        for contender in self.contenders:
            for actor in self.actors(contender):
                data = vtkPolyData()
                data.DeepCopy(actor.GetMapper().GetInput())
                actor.GetMapper().SetInputData(data)

    @staticmethod
    def actors(contender):
        """The translucent actors, list of vtkActor."""
        actors = contender.renderer.GetActors()
        actors.InitTraversal()
        return [actors.GetNextActor() for _ in range(actors.GetNumberOfItems())]

    def render(self, number, is_timed):
        """A frame of each."""
        for i, contender in enumerate(self.contenders):
            contender.turn(0.5)
            # The resting one changes once, so that both draw the same kind of data.
            if i == 0 or number == 0:
                self.change.apply(self.actors(contender), number)
            cpu = contender.render()[1]
            if is_timed:
                self.times[i].append(cpu)

    def close(self):
        """Frees both."""
        for contender in self.contenders:
            contender.close()


def measure(size, settings, is_quick, progress):
    """The results of all changes, list of dict: change, title, and by method the processor time in seconds of frames
    whose data change and rest, lists of float. size: (width, height). settings: rounds.Settings."""
    chosen, = catalogue.choose([SCENE])
    stage = Stage(chosen, size)
    results = []
    for change in QUICK if is_quick else CHANGES:
        pairs = {name: _Pair(stage, name, change) for name in (REFERENCE, *METHODS)}
        with capture() as captured:
            for number in range(WARM_UP + settings.frames):
                progress.show("%s: frame %d" % (change.name, number))
                for pair in pairs.values():
                    pair.render(number, number >= WARM_UP)
        for pair in pairs.values():
            pair.close()
        if captured.errors(1):
            raise Error("%s: %s" % (change.name, captured.errors(1)))
        results.append({"change": change.name, "title": change.title,
                        "changing": {name: pair.times[0] for name, pair in pairs.items()},
                        "resting": {name: pair.times[1] for name, pair in pairs.items()}})
    return results


def cost(result, method):
    """The processor time of a frame with the change as a multiple of one without: median of the rounds."""
    return rounds.ratio(numpy.array(result["changing"][method]), numpy.array(result["resting"][method]))[0]


def added(result, method):
    """What a method adds to unsorted blending with the change, as a multiple of what it adds without: of medians."""
    mine, of = ([numpy.median(result[kind][name]) for kind in ("changing", "resting")] for name in (method, REFERENCE))
    return float((mine[0] - of[0]) / (mine[1] - of[1]))


_HEAD = """# Data that change

Animations, time series and moved props: what a frame costs whose data have changed since the last one. This page was written by

```sh
{command}
```

on {machine}.

Processor time of all cores of a frame with a change, as a multiple of a frame without one; both of a camera that turns, in windows that take
turns; medians of {frames} frames, {size} pixels, scene `{scene}`. In parentheses what the method adds to unsorted blending (`blend`) with
the change, as a multiple of what it adds without: 1 means that the change costs us nothing of our own.
"""


def page(results, where, command, settings, size):
    """The page in Markdown, str. results: list of dict of measure(). where: str, the machine."""
    head = _HEAD.format(command=command, machine=where, frames=settings.frames, size="%d x %d" % size, scene=SCENE)
    rows = [[result["change"], result["title"], "%.2f" % cost(result, REFERENCE)] +
            ["%.2f (%.2f)" % (cost(result, method), added(result, method)) for method in METHODS]
            for result in results]
    return head + "\n" + table(["change", "what", "`%s`" % REFERENCE] + ["`%s`" % m for m in METHODS], rows) + "\n"
