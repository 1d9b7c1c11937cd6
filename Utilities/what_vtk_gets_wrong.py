# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes docs/what-vtk-gets-wrong.md: VTK's own passes in the scenes of the stress suite.

python3 Utilities/what_vtk_gets_wrong.py [--build DIRECTORY] [--results FILE] [--output FILE]

Runs every test of the label stress that is for all methods with each contender (Testing/Cxx/
Contenders.h) and makes a page of the results. With --results the file of an earlier run is used,
when it exists, and otherwise written.
"""

import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CONTENDERS = {
    "vtk-weighted": "`vtkOrderIndependentTranslucentPass`",
    "vtk-dual": "`vtkDualDepthPeelingPass`",
    "vtk-peel": "`vtkDepthPeelingPass`",
    "control": "`vtkOITABufferPass`",
}
WORST_CASES = 12
OWN_RULES = (15, 29, 30, 34)


def find_tests(build):
    """Command lines, without the method, of the stress tests that run for every method."""
    listing = subprocess.run(
        ["ctest", "--test-dir", build, "--show-only=json-v1", "-L", "stress"],
        check=True, capture_output=True, text=True)
    for test in json.loads(listing.stdout)["tests"]:
        if test["name"].endswith("-abuffer"):
            yield test["command"][:2]


def run_tests(build, results):
    """Appends the comparisons of all tests and contenders to the file."""
    for command in find_tests(build):
        for contender in CONTENDERS:
            print(command[1], contender, file=sys.stderr, flush=True)
            try:
                run = subprocess.run(
                    [*command, contender, "--results", str(results)], check=False,
                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600)
                problem = f"exit status {run.returncode}" if run.returncode else None
            except subprocess.TimeoutExpired:
                problem = "no end after 10 minutes"
            if problem:
                with open(results, "a", encoding="utf-8") as file:
                    file.write(json.dumps({"test": command[1], "contender": contender,
                                           "problem": problem}) + "\n")


def read_scenes():
    """Number to scene, from the table in docs/stress-tests.md."""
    text = (ROOT / "docs" / "stress-tests.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (\d+) \| ([^|]*) \|", text, re.MULTILINE)
    return {int(number): scene for number, scene in rows}


def is_wrong(result, channel):
    return result[channel] > result[f"allowed_{channel}"]


def format_error(error):
    return "not finite" if error >= 1e30 else f"{error:.3f}" if error >= 0.0005 else f"{error:.1g}"


def make_cell(results):
    """What a contender makes of the scenes of a number."""
    if not results:
        return "-"
    parts = []
    for channel, name in (("color", "colour"), ("alpha", "alpha")):
        wrong = [result[channel] for result in results if is_wrong(result, channel)]
        if wrong:
            parts.append(f"{name} {format_error(max(wrong))} ({len(wrong)}/{len(results)})")
    return ", ".join(parts) or "right"


def make_page(lines):
    heads = [line for line in lines if "vtk" in line]
    problems = [line for line in lines if "problem" in line]
    by_cell = collections.defaultdict(list)
    for line in lines:
        if line.get("number", 0) > 0:
            by_cell[line["number"], line["contender"]].append(line)
    scenes = read_scenes()
    rows = ["| no. | scene | " + " | ".join(CONTENDERS) + " |", "|---" * (2 + len(CONTENDERS)) + "|"]
    for number, scene in sorted(scenes.items()):
        cells = [make_cell(by_cell[number, contender]) for contender in CONTENDERS]
        if number not in OWN_RULES and any(cell != "-" for cell in cells):
            rows.append(f"| {number} | {scene} | " + " | ".join(cells) + " |")
    yield from PAGE_HEAD.format(vtk=heads[0]["vtk"], renderer=heads[0]["renderer"]).splitlines()
    yield from rows
    yield ""
    yield "## The largest colour errors"
    for contender, name in CONTENDERS.items():
        wrong = {}
        for (number, other), results in by_cell.items():
            for result in results:
                key = (number, result["test"])
                if other == contender and number not in OWN_RULES and is_wrong(result, "color"):
                    if key not in wrong or result["color"] > wrong[key]["color"]:
                        wrong[key] = result
        if not wrong:
            continue
        yield ""
        yield f"{name}, `{contender}`; the worst comparison of a number and test, at most {WORST_CASES}:"
        yield ""
        yield "| error | no. | test | comparison |"
        yield "|---|---|---|---|"
        ranked = sorted(wrong.items(), key=lambda item: -item[1]["color"])[:WORST_CASES]
        for (number, test), result in ranked:
            yield f"| {format_error(result['color'])} | {number} | {test} | {result['what']} |"
    if problems:
        yield ""
        yield "## Tests that did not run to their end"
        yield ""
        for line in problems:
            yield f"- {line['test']}, `{line['contender']}`: {line['problem']}"


PAGE_HEAD = """\
# What VTK's own passes get wrong

Made by `python3 Utilities/what_vtk_gets_wrong.py`, not written by hand. VTK {vtk}, OpenGL renderer {renderer}.

The scenes are those of [the stress suite](stress-tests.md), with the same answers. Contenders:

- `vtk-weighted`: `vtkOrderIndependentTranslucentPass`, VTK's default.
- `vtk-dual`: `vtkDualDepthPeelingPass`, that is `UseDepthPeelingOn()`, with as many peels as it asks for.
- `vtk-peel`: `vtkDepthPeelingPass`, with as many peels as it asks for.
- `control`: vtkOIT's `vtkOITABufferPass` in the same place, to show that the comparison itself is right.

All draw into a window of 8 bits a channel, over a background of alpha 0.4, without multisampling unless a comparison names the
samples. A comparison is wrong when a channel of some pixel is off by more than the test allows and three steps of 255 on top, so that
rounding alone is not called wrong. Cells give the largest error of a colour channel and of alpha, in [0, 1], and how many of the
comparisons are wrong. Coincident faces of different colours may be in any order here. Left out are float framebuffers and what needs
them (16 to 19, 33), and rules and properties of vtkOIT's own (15, 29, 30, 34).

"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--build", default=str(ROOT / "build"), help="build folder (build)")
    parser.add_argument("--results", type=pathlib.Path, help="file of the comparisons, JSON lines")
    parser.add_argument("--output", type=pathlib.Path,
                        default=ROOT / "docs" / "what-vtk-gets-wrong.md", help="the page")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        results = arguments.results or pathlib.Path(folder) / "results.jsonl"
        if not results.exists():
            run_tests(arguments.build, results)
        lines = [json.loads(line) for line in results.read_text(encoding="utf-8").splitlines()]
    if not any("vtk" in line for line in lines):
        sys.exit(f"{results}: no results; build the tests first (Utilities/test.sh)")
    arguments.output.write_text("\n".join(make_page(lines)) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
