# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Random scenes by several exact methods: pictures that are said to be right are the same.

    build/bin/vtkoit-python Testing/Python/fuzz/SceneFuzzer.py --seconds 0      # without end
    build/bin/vtkoit-python Testing/Python/fuzz/SceneFuzzer.py --seed 1234 --count 1

The methods share mappers and the rasteriser, but neither how they store fragments nor how they order
them. So whatever a prop is, they must agree within one step of 255, the rounding of what is blended to 8
bits at most once. Nothing is left out at outlines: all of them draw the same triangles in the same window.
A frame may say that it is not exact, in a line; then it is not compared. What VTK alone complains of in
the same scene is not counted.
"""

import json
import random
import sys

import describe
import supervise
import verdict
from stage import Stage

# All fragments as they are, and none left out.
EXACT = {"FragmentPrecision": "float", "TransmittanceThreshold": 0.0}


def draw(scene, method):
    """The first frame and the third, of a window of its own: by then auto knows what it can leave out,
    and composites what it has kept."""
    stage = Stage(scene, method, EXACT)
    try:
        return stage.draw(), stage.draw(), stage.draw()
    finally:
        stage.close()


def look_at(scene, methods):
    """(what is wrong, str; frames by name; number of methods that were compared)."""
    frames = {}
    for method in methods:
        for number, frame in zip((1, 2, 3), draw(scene, method)):
            if frame.exact or number == 1:
                frames["%s-%d" % (method, number)] = frame
    texts = {name: verdict.complaint(frame) for name, frame in frames.items()}
    if any(texts.values()) and methods != ["vtk"]:
        alone = [verdict.complaint(frame) for frame in draw(scene, "vtk")]
        texts = {name: text for name, text in texts.items() if text not in alone}
    problems = ["%s: %s" % (name, text) for name, text in texts.items() if text]
    exact = {name: frame for name, frame in frames.items() if frame.exact}
    first = next(iter(exact), "")
    others = {}
    for name, frame in exact.items():
        others.setdefault(verdict.differ(exact[first], frame), []).append(name)
    problems += ["%s and %s: %d steps, %d pixels" % (first, " ".join(names), worst, pixels)
                 for (worst, pixels), names in others.items() if worst > 1]
    return "; ".join(problems), frames, len({name.split("-")[0] for name in exact})


def report(seed, scene, problem, frames, options):
    print("seed %s: %s" % (seed, problem), flush=True)
    verdict.keep(options.folder, "scene-%s" % seed, scene, frames)
    reduced = verdict.smaller(scene, lambda s: bool(look_at(s, options.methods)[0]))
    problem, frames, _ = look_at(reduced, options.methods)
    path = verdict.keep(options.folder, "scene-%s-small" % seed, reduced, frames)
    alone, _, _ = look_at(reduced, ["vtk"])
    print("  the least that fails: %s\n  VTK alone, frame by frame: %s\n"
          "  again: SceneFuzzer.py --size %d --seed %s --count 1, or --replay %s.json"
          % (problem, alone or "right", options.size, seed, path), flush=True)


def main(arguments):
    parser = verdict.parser(__doc__.split("\n", 1)[0], "scenes")
    parser.add_argument("--methods", nargs="+", default=["abuffer", "auto", "peel"])
    options = parser.parse_args(arguments)
    if options.replay:
        with open(options.replay, encoding="utf-8") as file:
            problem, frames, _ = look_at(json.load(file), options.methods)
        print(problem or "right", {name: frame.words for name, frame in frames.items()})
        return 1 if problem else 0

    def case(seed):
        scene = describe.scene(random.Random(seed), options.size)
        problem, frames, number = look_at(scene, options.methods)
        if problem:
            report(seed, scene, problem, frames, options)
        elif options.verbose:
            print("seed %d: %s" % (seed, {name: frame.words for name, frame in frames.items()}))
        return {"compared": int(number > 1), "failed": int(bool(problem)),
                "layered": int(any(frame.layers > 2 for frame in frames.values()))}

    sums = supervise.run(verdict.seeds(options), case)
    print("%d scenes, %d compared, %d with more than 2 layers, %d failed" % (
        sums["seeds"], sums["compared"], sums["layered"], sums["failed"]))
    # Random scenes that hardly ever have something to order would say nothing.
    weak = sums["compared"] < 0.9 * sums["seeds"] or sums["layered"] < 0.2 * sums["seeds"]
    return 1 if sums["failed"] or (sums["seeds"] >= 20 and weak) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
