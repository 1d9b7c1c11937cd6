# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command bench with --skips, --costs and their like: a page about one question each."""

import json
import os

from ..errors import Error
from ..values import parse_size
from ..windows import headless
from . import changes, costs, document, first, growth, machine, plots, rounds, seedpage, seeds, skips

NAMES = ("skips", "costs", "growth", "first", "changes", "seeds")
PLAIN = {"growth": growth, "first": first, "changes": changes}  # which take and return the same
PAGES = {"seeds": seedpage.PAGE, **{name: study.PAGE for name, study in PLAIN.items()}}
FRAMES, QUICK_FRAMES = 9, 2
BUDGET, QUICK_BUDGET = 3.0, 0.5
SIZE = {"skips": "800x800", "costs": "400x400", "growth": "400x400", "first": "800x800", "changes": "400x400",
        "seeds": "400x400"}
QUICK_SIZE = "100x100"


def chosen(options):
    """The study that the command line asks for, str; None for none."""
    return next((name for name in NAMES if getattr(options, name)), None)


def run(name, options, settings, progress):
    """Makes the page of a study. options: argparse.Namespace of cli. settings: measure.Settings of the
    command line. Raises Error."""
    for other in ("scenes", "methods"):
        if getattr(options, other):
            raise Error("--%s has scenes and methods of its own; leave --%s out" % (name, other))
    size = parse_size(options.size or (QUICK_SIZE if options.quick else SIZE[name]))
    frames = QUICK_FRAMES if options.quick else FRAMES
    budget = QUICK_BUDGET if options.quick else BUDGET
    mine = rounds.Settings(
        frames if options.frames is None else settings.frames, settings.turn,
        budget if options.budget is None else settings.budget)
    draws = name == "growth" and not options.no_plots
    if draws:
        plots.matplotlib()  # its absence is told before the work
    try:
        headless()
    except RuntimeError as error:
        raise Error(str(error)) from None
    _make_folder(options.output)
    here = machine.describe()
    print(machine.line(here))
    results, text = _measure(name, options, size, mine, here, progress)
    progress.clear()
    print("\n" + text)
    with open(os.path.join(options.output, name + ".json"), "w", encoding="utf-8") as file:
        json.dump({"machine": here, "results": results}, file, indent=1)
        file.write("\n")
    for folder in filter(None, (options.output, options.document)):
        with open(os.path.join(folder, PAGES.get(name, name + ".md")), "w", encoding="utf-8") as file:
            file.write(text)
        if draws:
            growth.draw(folder, results)
    print("%s: %s, %s.json" % (options.output, PAGES.get(name, name + ".md"), name))


def _make_folder(folder):
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise Error("%s: cannot be made: %s" % (folder, error.strerror)) from None


def _measure(name, options, size, settings, here, progress):
    """(what JSON keeps, the page)."""
    progress.begin("%s" % name)
    about = (document.where(here), _command(name, options), settings, size)
    if name == "skips":
        results = skips.measure(skips.skips(options.quick), size, settings, progress)
        return results, skips.page(results, *about)
    if name == "costs":
        sizes = costs.QUICK if options.quick else costs.FULL
        results = costs.Study(size, settings, sizes, progress).run()
        return results, costs.page(results, *about)
    if name == "seeds":
        results = seeds.measure(size, settings, options.quick, progress)
        return results, seedpage.page(results, *about)
    study = PLAIN[name]
    results = study.measure(size, settings, options.quick, progress)
    return results, study.page(results, *about)


def _command(name, options):
    parts = ["vtkoit bench --%s" % name] + (["--quick"] if options.quick else [])
    for key in ("size", "frames", "budget"):
        if getattr(options, key) is not None:
            parts.append("--%s %s" % (key, getattr(options, key)))
    return " ".join(parts + ["--output DIR", "--document docs"])
