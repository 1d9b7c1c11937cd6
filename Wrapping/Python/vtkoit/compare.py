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
from .report import page
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
    shown = [page.Shown("right picture", picture.png_of(numpy.rint(255.0 * numpy.clip(right["color"], 0.0, 1.0)).astype(
        numpy.uint8)), None, "computed in double precision")]
    for group in measure.groups(names, options.size[0] * options.size[1],
                                stage.facts()["triangles"]):
        for method, measured in measure.measure(stage, group, SETTINGS, progress):
            if method not in [result["method"] for result in results]:
                result, color = record.make(stage.facts(), method, right, measured)
                results.append(result)
                if color is not None:
                    shown.append(_save(arguments.output, result, color, right["color"]))
    tables.relate(results)
    results.sort(key=lambda result: names.index(result["method"]))
    described = machine.describe()
    tables.write_csv(os.path.join(arguments.output, "compare.csv"), results, described)
    tables.write_json(os.path.join(arguments.output, "compare.json"), results, described, {})
    shown[1:] = sorted(shown[1:], key=lambda each: names.index(each.method))
    page.write(_page(name, drawn.notes, results, shown, described), os.path.join(arguments.output, "report.html"))
    progress.clear()
    for note in drawn.notes:
        print(note)
    print(machine.line(described))
    print(tables.LEGEND)
    print("\n".join(tables.text(results)))
    print("%s: report.html, METHOD.png, METHOD-difference.png (%d times what is more than rounding), compare.csv, "
          "compare.json" % (arguments.output, AMPLIFIED))


def _save(folder, result, color, right):
    """Writes the picture of a result, array of uint8, and its amplified difference; what the page shows of
    them, page.Shown."""
    difference = amplify(color, right)
    picture.save(color, os.path.join(folder, "%s.png" % slug(result["method"])))
    picture.save(difference, os.path.join(folder, "%s-difference.png" % slug(result["method"])))
    note = "colours off by up to %.1f of 255 steps, %.3g %% of the pixels by more than one; %.1f ms" % (
        result["max"], result["over1"], result["ms"])
    return page.Shown(result["method"], picture.png_of(color), picture.png_of(difference), note)


def _page(name, notes, results, shown, described):
    """The page.Page of a comparison. name, notes: str and list of str, of the scene."""
    rows = [[result["method"]] + (tables.cells(result) + [tables.drawn_by(result)] if result.get("ms")
                                  else ["-"] * len(tables.headings()) + [result["reason"]])
            for result in results]
    return page.Page(
        "Translucency of %s" % name, [tables.heading(results[0])] + notes, [page.Scene(name, shown)],
        "Differences are %d times what is more than the rounding to 8 bits; black is right." % AMPLIFIED,
        [page.Table("Time and errors of each method", ["method"] + tables.headings() + ["drawn by"], rows,
                    " ".join(tables.LEGEND.split()))],
        described)


def amplify(color, right, factor=AMPLIFIED):
    """The difference of a picture (array of uint8) to the right one (float array in [0, 1]), less
    the half step of rounding, times a factor, array of uint8."""
    difference = numpy.abs(color.astype(float) - 255.0 * numpy.clip(right, 0.0, 1.0))
    return numpy.clip(factor * numpy.maximum(0.0, difference - 0.5), 0, 255).astype(numpy.uint8)
