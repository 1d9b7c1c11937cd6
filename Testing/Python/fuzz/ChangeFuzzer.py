# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""A window that is kept while its scene changes shows what a new window with a new pass shows.

    build/bin/vtkoit-python Testing/Python/fuzz/ChangeFuzzer.py --seconds 0      # without end
    build/bin/vtkoit-python Testing/Python/fuzz/ChangeFuzzer.py --seed 1234 --count 1

Each seed is a random scene and a dozen changes, one to three between frames; after them the kept window
draws one to four frames, and each must be the first one of a new window. Bit by bit; of auto within one
step of 255, because a layer that it has kept is rounded once more than what it draws at once (to 2^-23).
Where VTK alone shows an old picture after the same changes (a glyph mapper does not see a new colour), and a
new pass does not help, or where VTK alone leaves an error of OpenGL too (selected cells with visible edges),
the scene is left there and counted apart.
"""

import copy
import json
import random
import sys

import changes
import describe
import supervise
import verdict
from stage import Stage

CHANGES_OF_A_SEED = 12


def make_case(seed, size):
    rng = random.Random(seed)
    scene = describe.scene(rng, size)
    scene["method"] = describe.pick(rng, changes.METHODS)
    scene["values"] = {"TransmittanceThreshold": 0.0}
    weights = {name: weight for name, (_, _, weight, _) in changes.CHANGES.items()}
    steps = []
    while sum(len(step["changes"]) for step in steps) < CHANGES_OF_A_SEED:
        names = [describe.pick(rng, weights) for _ in range(rng.choice([1, 1, 1, 2, 3]))]
        steps.append({"changes": [[name, rng.randrange(10**6)] for name in names],
                      "frames": rng.choice([1, 2, 3, 3, 4])})
    return {"scene": scene, "steps": steps}


def apply(name, seed, scene, stage):
    """Edits the description, and brings the window in line with it."""
    level, part, _, edit = changes.CHANGES[name]
    rng = random.Random(seed)
    in_place = rng.random() < 0.5
    if level == "prop":
        number = rng.choice(list(scene["props"]))
        edit(rng, scene["props"][number])
        describe.settle(scene)
        stage.set_prop(number, scene["props"][number], part, in_place)
    elif level == "renderer":
        at = rng.randrange(len(scene["renderers"]))
        edit(rng, scene["renderers"][at])
        describe.settle(scene)
        getattr(stage, "set_" + part)(stage.renderers[at], scene["renderers"][at])
    else:
        edit(rng, scene)
        describe.settle(scene)
        stage.set_scene(scene, part)


def run(case, method=None):
    """(what is wrong, str; frames by name; description of the scene then; counts). method: str, to see
    whether another one, or VTK alone, does the same."""
    scene = copy.deepcopy(case["scene"])

    def make_stage():
        return Stage(scene, method or scene["method"], scene["values"] if not method else {})

    stage = make_stage()
    stage.fixed = bool(method)
    counts = {"changes": 0, "compared": 0}
    try:
        stage.draw()
        for step in case["steps"]:
            for name, seed in step["changes"]:
                apply(name, seed, scene, stage)
                counts["changes"] += 1
            frames = [stage.draw() for _ in range(step["frames"])]
            new = make_stage()
            fresh = new.draw()
            new.close()
            allowed = 1 if scene["method"] == "auto" and not method else 0
            text = judge(frames, fresh, allowed)
            counts["compared"] += len(frames) if fresh.exact else 0
            if text:
                names = " ".join(name for name, _ in step["changes"])
                replaced = stage.replaced(scene).draw() if not method else fresh
                worst, pixels = verdict.differ(replaced, fresh)
                if not method and vtk_alone_does(case, text, worst):
                    # The rest of the case would show no more than that.
                    return "", {}, scene, dict(counts, left_out=1)
                text = "%s after %s: %s; a new pass in the kept window: %d steps, %d pixels" % (
                    scene["method"], names, text, worst, pixels)
                return text, {"kept": frames[-1], "fresh": fresh, "replaced": replaced}, scene, counts
    finally:
        stage.close()
    return "", {}, scene, counts


def vtk_alone_does(case, text, worst):
    """Whether what is wrong is VTK's own: an old picture where a new pass shows the same (worst: its
    difference in steps), because what a mapper keeps is not ours, or an error of OpenGL."""
    return (worst > 1 or text.startswith("OpenGL error")) and bool(run(case, "vtk")[0])


def judge(frames, fresh, allowed):
    for number, frame in enumerate(frames, 1):
        worst, pixels = verdict.differ(frame, fresh)
        if worst > allowed and frame.exact and fresh.exact:
            return "frame %d (%s) and that of a new window (%s): %d steps, %d pixels" % (
                number, frame.words, fresh.words, worst, pixels)
        text = verdict.complaint(frame) or verdict.complaint(fresh)
        if text:
            return text
    return ""


def fewer(case):
    """The case without the changes, frames and props that it does not need to fail."""
    def fails(candidate):
        try:
            return bool(run(candidate)[0])
        except (IndexError, KeyError):  # a change of what is not there
            return False

    for i in reversed(range(len(case["steps"]))):
        candidate = dict(case, steps=case["steps"][:i] + case["steps"][i + 1:])
        if fails(candidate):
            case = candidate
    for i, step in enumerate(case["steps"]):
        for j in reversed(range(len(step["changes"]))):
            left = dict(case["steps"][i], changes=case["steps"][i]["changes"][:j] + case["steps"][i]["changes"][j + 1:])
            candidate = dict(case, steps=case["steps"][:i] + [left] + case["steps"][i + 1:])
            if fails(candidate):
                case = candidate
    scene = verdict.smaller(case["scene"], lambda scene: fails(dict(case, scene=scene)))
    return dict(case, scene=scene)


def report(seed, case, text, frames, options):
    print("seed %d: %s" % (seed, text), flush=True)
    verdict.keep(options.folder, "changes-%d" % seed, case, frames)
    small = fewer(case)
    text, frames, _, _ = run(small)
    path = verdict.keep(options.folder, "changes-%d-small" % seed, small, frames)
    print("  the least that fails: %s; %s\n  VTK alone: %s\n"
          "  again: ChangeFuzzer.py --size %d --seed %d --count 1, or --replay %s.json"
          % (text, [step["changes"] for step in small["steps"]], run(small, "vtk")[0] or "right", options.size,
             seed, path), flush=True)


def main(arguments):
    options = verdict.parser(__doc__.split("\n", 1)[0], "scenes that change").parse_args(arguments)
    if options.replay:
        with open(options.replay, encoding="utf-8") as file:
            text = run(json.load(file))[0]
        print(text or "right")
        return 1 if text else 0

    def case(seed):
        made = make_case(seed, options.size)
        text, frames, _, counts = run(made)
        if text:
            report(seed, made, text, frames, options)
        elif options.verbose:
            print("seed %d: %s" % (seed, counts))
        return dict(counts, failed=int(bool(text)))

    sums = supervise.run(verdict.seeds(options), case)
    print("%d scenes, %d changes, %d frames compared, %d scenes left at what VTK alone does wrong, %d failed" % (
        sums["seeds"], sums["changes"], sums["compared"], sums["left_out"], sums["failed"]))
    return 1 if sums["failed"] or sums["compared"] < sums["seeds"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
