# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""draw.py --list: prints the names of the examples in PyVista's docstrings that draw.
draw.py FOLDER NAME...: runs those, and writes what they show into FOLDER, with a line of JSON for each into
FOLDER/results: the file of each picture, whether something in it is translucent, and what stopped the example.

A process for compare.py, which starts it with and without vtkOIT: nothing here knows of vtkOIT.
"""

import contextlib
import doctest
import importlib
import io
import json
import os
import pkgutil
import random
import sys
import tempfile
import warnings

import numpy
import pyvista
from vtkmodules.vtkRenderingCore import vtkActor, vtkPropCollection, vtkVolume


def find():
    """The examples that draw: dict of name to doctest.DocTest."""
    warnings.simplefilter("ignore")
    found, places = {}, set()
    names = [each.name for each in pkgutil.walk_packages(pyvista.__path__, "pyvista.", onerror=lambda name: None)]
    for name in ["pyvista", *names]:
        try:
            module = importlib.import_module(name)
        except Exception:  # pylint: disable=broad-exception-caught # a part that needs what is not there
            continue
        for test in doctest.DocTestFinder().find(module, name):
            text = "".join(example.source for example in test.examples)
            place = (test.filename, test.lineno)
            # What is downloaded is not there in every place that this runs in.
            if (".plot(" in text or ".show(" in text) and "download" not in text and place not in places:
                places.add(place)
                found[test.name] = test
    return found


class Recorder:
    """Takes the place of Plotter.show() and keeps the pictures of an example."""

    def __init__(self, folder):
        self.folder = folder
        self.pictures = []
        self.number = 0
        show = pyvista.Plotter.show
        recorder = self

        def record(plotter, *arguments, auto_close=None, **options):
            result = show(plotter, *arguments, auto_close=False, **options)
            recorder.record(plotter)
            if auto_close is not False:
                plotter.close()
            return result

        pyvista.Plotter.show = record

    def record(self, plotter):
        # Those of widgets, too, whose renderers PyVista does not list.
        props = [prop for renderer in plotter.render_window.GetRenderers() for prop in renderer.GetViewProps()
                 if is_translucent(prop)]
        kept = {"picture": self.save(plotter), "translucent": len(props)}
        if props:
            # Where they are: what looks other without them. In a multisampled window VTK draws translucent meshes
            # by one sample of a pixel, opaque ones by all.
            actors = [actor for prop in props for actor in actors_of(prop)]
            forced = [actor.GetForceOpaque() for actor in actors]
            for actor in actors:
                actor.ForceOpaqueOn()
            kept["opaque"] = self.save(plotter)
            for actor, before in zip(actors, forced):
                actor.SetForceOpaque(before)
            for prop in props:
                prop.SetVisibility(False)
            kept["without"] = self.save(plotter)
            for prop in props:
                prop.SetVisibility(True)
        self.pictures.append(kept)

    def save(self, plotter):
        self.number += 1
        name = "%d-%d.npy" % (os.getpid(), self.number)
        plotter.render_window.Render()  # screenshot() takes what was drawn last
        numpy.save(os.path.join(self.folder, name), plotter.screenshot(None, return_img=True)[..., :3])
        return name


def actors_of(prop):
    """The actors that a prop is made of: list of vtkActor."""
    actors = vtkPropCollection()
    prop.GetActors(actors)
    return [actors.GetItemAsObject(i) for i in range(actors.GetNumberOfItems())
            if isinstance(actors.GetItemAsObject(i), vtkActor)]


def is_translucent(prop):
    """Volumes are drawn between the translucent meshes, so they count as such."""
    return bool(prop.GetVisibility() and (prop.HasTranslucentPolygonalGeometry() or isinstance(prop, vtkVolume)))


def run(test):
    """Runs an example. Returns what stopped it, str, empty when nothing did."""
    random.seed(0)
    numpy.random.seed(0)
    pyvista.global_theme.restore_defaults()
    pyvista.OFF_SCREEN = True
    scope = dict(test.globs)
    for example in test.examples:
        if example.options.get(doctest.SKIP):
            continue
        try:
            with contextlib.redirect_stdout(io.StringIO()):
                exec(compile(example.source, test.name, "single"), scope)  # pylint: disable=exec-used
        except (Exception, SystemExit) as error:  # pylint: disable=broad-exception-caught # an example may do anything
            if not example.exc_msg:
                return "%s: %s" % (type(error).__name__, " ".join(str(error).split())[:120])
    return ""


def main(arguments):
    found = find()
    if arguments == ["--list"]:
        print("\n".join(found))
        return
    folder = os.path.abspath(arguments[0])
    recorder = Recorder(folder)
    with open(os.path.join(folder, "results"), "a", encoding="utf-8") as results, \
            tempfile.TemporaryDirectory() as elsewhere:
        os.chdir(elsewhere)  # where examples write files
        for name in arguments[1:]:
            results.write(json.dumps({"begun": name}) + "\n")
            results.flush()
            recorder.pictures = []
            stopped = run(found[name])
            pyvista.close_all()
            results.write(json.dumps({"name": name, "stopped": stopped, "pictures": recorder.pictures}) + "\n")
            results.flush()
        sys.stdout.flush()
        os._exit(0)  # whatever plotters do at the end of Python


if __name__ == "__main__":
    main(sys.argv[1:])
