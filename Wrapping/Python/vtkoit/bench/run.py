# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command bench: every method in every scene, measured side by side, compared with the truth."""

import os
import time

from ..errors import Error
from ..values import parse_size
from ..windows import headless
from . import (
    catalogue,
    contenders,
    document,
    machine,
    measure,
    plots,
    record,
    studies,
    tables,
    truth,
)
from .stage import Stage
from .store import Store, slug

# What an interrupted run may not mix with; changes when results mean something else.
FORMAT = 3

FULL = measure.Settings(frames=15, budget=3.0, turn=0.5, longest=10.0)
QUICK = measure.Settings(frames=5, budget=1.0, turn=0.5, longest=4.0)
SIZE, QUICK_SIZE = "800x800", "300x300"


def run(options, progress):
    """Measures what the command line says; options: argparse.Namespace of cli. Raises Error."""
    scenes = catalogue.choose(options.scenes, options.quick)
    if options.list:
        print(listing())
        return
    if options.document and not os.path.isdir(options.document):
        raise Error("--document %s: there is no such folder" % options.document)
    study = studies.chosen(options)
    if study:
        studies.run(study, options, _settings(options), progress)
        return
    names = options.methods or contenders.names(options.quick)
    for name in names:
        contenders.parse(name)
    names = list(dict.fromkeys([measure.REFERENCE] + names))
    size = parse_size(options.size or (QUICK_SIZE if options.quick else SIZE))
    settings = _settings(options)
    if not options.no_plots:
        plots.matplotlib()  # its absence is told before the work
    try:
        headless()
    except RuntimeError as error:
        raise Error(str(error)) from None
    laboratory = Laboratory(options.output, names, size, settings, progress)
    print(machine.line(laboratory.machine))
    if machine.is_busy(laboratory.machine):
        print("Other work keeps this machine busy: ratios of processor time (cpu x) say more than others.")
    print(tables.LEGEND)
    start = time.monotonic()
    for scene in scenes:
        results = laboratory.run_scene(scene)
        progress.clear()
        print("\n" + "\n".join(tables.text(results)), flush=True)
        laboratory.write()
    laboratory.draw(scenes, options.no_plots)
    if options.document:
        document.write(options.document, laboratory.machine, laboratory.results, laboratory.store,
                       _command(options))
    progress.clear()
    if laboratory.store.outdated:
        print("\nmeasured again, because of another: %s"
              % ", ".join(sorted(laboratory.store.outdated)))
    print("\n%s: bench.csv, bench.json%s; %d scenes, %.0f s" % (
        options.output, "" if options.no_plots else ", *.png", len(scenes),
        time.monotonic() - start))


def _settings(options):
    settings = QUICK if options.quick else FULL
    if options.frames is not None:
        if not 1 <= options.frames <= 10000:
            raise Error("--frames %d: give 1 to 10000" % options.frames)
        settings = settings._replace(frames=options.frames)
    if options.budget is not None:
        if not 0.0 < options.budget <= 3600.0:
            raise Error("--budget %g: give seconds above 0, at most 3600" % options.budget)
        settings = settings._replace(budget=options.budget)
    return settings


def _command(options):
    parts = ["vtkoit bench"]
    parts += ["--quick"] if options.quick else []
    for name in ("scenes", "methods"):
        if getattr(options, name):
            parts.append("--%s %s" % (name, " ".join(getattr(options, name))))
    for name in ("size", "frames", "budget"):
        if getattr(options, name) is not None:
            parts.append("--%s %s" % (name, getattr(options, name)))
    return " ".join(parts + ["--output DIR", "--document docs"])


def listing():
    """All scenes and methods, a line each, str."""
    lines = ["scenes (* in --quick; a pattern such as layers-* or a file can be given, too):"]
    for scene in catalogue.all_scenes():
        lines.append(" %s%-16s %s" % ("*" if scene.name in catalogue.QUICK else " ", scene.name,
                                      scene.title))
    lines.append("methods (* in --quick; with properties: METHOD:NAME=VALUE,NAME=VALUE):")
    quick = contenders.names(True)
    for name in contenders.names():
        lines.append(" %s%-16s %s" % ("*" if name in quick else " ", name,
                                      contenders.VTK.get(name, "")))
    return "\n".join(line.rstrip() for line in lines)


class Laboratory:
    """Measures scenes, keeps results in a folder, and takes from there what was measured before."""

    def __init__(self, folder, names, size, settings, progress):
        self.folder = folder
        self.names = names
        self.size = size
        self.settings = settings
        self.progress = progress
        self.machine = machine.describe()
        self.configuration = {
            "format": FORMAT, "frames": settings.frames, "budget": settings.budget,
            **{key: self.machine[key] for key in ("cpu", "cores", "renderer", "vtk", "library")}}
        self.store = Store(folder, self.configuration)
        self.results = []

    def run_scene(self, scene):
        """The results of a scene, list of dict, in the order of the names."""
        size = scene.size or self.size
        names = [name for name in self.names if ":" not in name or not scene.family] \
            if self.names[1:] == contenders.names()[1:] else self.names
        found = {name: self.store.load(scene.name, name, size) for name in names}
        pending = [name for name in names if found[name] is None]
        if pending:
            self.progress.begin("%s: making the scene" % scene.name)
            stage = Stage(scene, size)
            right = self._truth(stage)
            for name in list(pending):
                reason = self._too_slow(scene, name)
                if reason:
                    pending.remove(name)
                    found[name] = self._keep(stage, name, right, record.not_run(reason))
            triangles = stage.facts()["triangles"]
            for group in measure.groups(pending, size[0] * size[1], triangles):
                for name, measured in measure.measure(stage, group, self.settings, self.progress):
                    if found.get(name) is None:
                        found[name] = self._keep(stage, name, right, measured)
        results = [found[name] for name in names]
        tables.relate(results)
        self.results += results
        return results

    def _truth(self, stage):
        """The truth as dict; kept from an earlier run where it can be."""
        name = stage.facts()["scene"]
        kept = self.store.load_truth(name, stage.size)
        if kept is None:
            self.progress.show("%s: truth" % name)
            right = truth.find(stage)
            arrays = {key: getattr(right, key) for key in ("color", "alpha", "covered")}
            facts = {key: getattr(right, key)
                     for key in ("source", "fragments", "layers", "cross_check")}
            self.store.save_truth(name, stage.size, arrays, facts)
            kept = {**arrays, **facts}
        return kept

    def _too_slow(self, scene, name):
        """Why a method is left out of a scene: a smaller one of the family took too long."""
        if (scene.family or "").split("-")[0] not in ("layers", "triangles", "pixels", "volumes"):
            return ""
        for result in self.results:
            if result["family"] == scene.family and result["method"] == name and \
                    result["value"] < scene.value:
                if result.get("ms") and result["ms"] > 1000.0 * self.settings.longest:
                    return "left out: a frame of %s takes %.0f s" % (
                        result["scene"], result["ms"] / 1000.0)
                if result["reason"].startswith("left out"):
                    return result["reason"]
        return ""

    def _keep(self, stage, name, right, measured):
        """The result (dict) of a Measured, saved."""
        result, color = record.make(stage.facts(), name, right, measured)
        self.store.save(result["scene"], name, stage.size, result, color)
        return result

    def write(self):
        """Writes the tables of what was measured so far."""
        tables.write_csv(os.path.join(self.folder, "bench.csv"), self.results, self.machine)
        tables.write_json(os.path.join(self.folder, "bench.json"), self.results, self.machine,
                          self.configuration)

    def draw(self, scenes, no_plots):
        """Writes the diagrams and the contact sheets."""
        if no_plots:
            return
        for results in tables.by_scene(self.results):
            name = slug(results[0]["scene"])
            self.progress.show("plots: %s" % name)
            plots.time_error(os.path.join(self.folder, "time-error-%s.png" % name), results)
            self.draw_sheet(os.path.join(self.folder, "contact-%s.png" % name), results)
        for family in dict.fromkeys(scene.family for scene in scenes if scene.family):
            plots.cost(os.path.join(self.folder, "cost-%s.png" % family), self.results, family)

    def draw_sheet(self, path, results):
        """Writes the contact sheet of the results of one scene."""
        first = results[0]
        right = self.store.load_truth(first["scene"], (first["width"], first["height"]))
        pictures = []
        for result in results:
            image = self.store.picture(first["scene"], result["method"])
            if image is not None and result.get("rmse") is not None:
                caption = "%s\nmax %.1f, RMSE %.2f" % (
                    result["method"].replace(":", "\n"), result["max"], result["rmse"])
                pictures.append((caption, image))
        if right is not None:
            plots.contact_sheet(path, "%s: %s" % (first["scene"], first["title"]), right["color"],
                                pictures)
