# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command compare: one picture a method of the user's own data, and the difference to the right
one."""

import os

import numpy

from . import camera, contents, picture, scene
from .bench import contenders, machine, measure, record, tables, truth
from .bench.stage import SurfaceStage
from .bench.store import slug
from .errors import Error, printable
from .render import SceneOptions
from .windows import headless

SETTINGS = measure.Settings(frames=5, budget=1.5, turn=0.5, longest=0.0)
AMPLIFIED = 16  # differences, in their pictures


def run(arguments, progress):
    """Compares what the command line says; arguments: argparse.Namespace of cli. Raises Error."""
    options = SceneOptions(arguments)
    names = arguments.methods or [name for name in contenders.names()
                                  if ":" not in name and name != "vtk-sort"]
    for name in names:
        contenders.parse(name)
    names = list(dict.fromkeys([measure.REFERENCE] + names))
    drawn = contents.load(arguments.inputs, options, progress)
    try:
        headless()
        os.makedirs(arguments.output, exist_ok=True)
    except RuntimeError as error:
        raise Error(str(error)) from None
    except OSError as error:
        raise Error("%s: cannot be made: %s" % (arguments.output, error.strerror)) from None

    def make_renderer():
        renderer = scene.build(drawn.surfaces, options.style, drawn.volumes)
        camera.place(renderer, options.camera, options.up, options.zoom, arguments.parallel,
                     options.size[0] / options.size[1])
        return renderer

    name = printable(os.path.basename(os.path.normpath(arguments.inputs[0])))
    stage = SurfaceStage(name, contents.count(drawn), make_renderer, drawn.surfaces, options.size,
                         drawn.volumes)
    progress.begin("%s: truth" % name)
    right = truth.find(stage)._asdict()
    results = []
    for group in measure.groups(names, options.size[0] * options.size[1],
                                stage.facts()["triangles"]):
        for method, measured in measure.measure(stage, group, SETTINGS, progress):
            if method not in [result["method"] for result in results]:
                result, color = record.make(stage.facts(), method, right, measured)
                results.append(result)
                _save(arguments.output, method, color, right["color"])
    tables.relate(results)
    results.sort(key=lambda result: names.index(result["method"]))
    described = machine.describe()
    tables.write_csv(os.path.join(arguments.output, "compare.csv"), results, described)
    tables.write_json(os.path.join(arguments.output, "compare.json"), results, described, {})
    progress.clear()
    for note in drawn.notes:
        print(note)
    print(machine.line(described))
    print(tables.LEGEND)
    print("\n".join(tables.text(results)))
    print("%s: METHOD.png, METHOD-difference.png (%d times what is more than rounding), compare.csv, "
          "compare.json" % (arguments.output, AMPLIFIED))


def _save(folder, method, color, right):
    """Writes the picture of a method and its amplified difference; color: None for none."""
    if color is None:
        return
    picture.save(color, os.path.join(folder, "%s.png" % slug(method)))
    picture.save(amplify(color, right), os.path.join(folder, "%s-difference.png" % slug(method)))


def amplify(color, right, factor=AMPLIFIED):
    """The difference of a picture (array of uint8) to the right one (float array in [0, 1]), less
    the half step of rounding, times a factor, array of uint8."""
    difference = numpy.abs(color.astype(float) - 255.0 * numpy.clip(right, 0.0, 1.0))
    return numpy.clip(factor * numpy.maximum(0.0, difference - 0.5), 0, 255).astype(numpy.uint8)
