# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page docs/accuracy-and-speed.md: tables and pictures of a run of the laboratory."""

import os

from ..errors import Error
from . import plots, tables
from .store import slug

PAGE = "accuracy-and-speed.md"
PICTURES = "pictures"
# Scenes whose tables and pictures are shown in full, as far as they were measured.
SHOWN = ("spheres", "isosurfaces", "small-props")
SHEET = ("blend", "vtk-weighted", "vtk-dual", "vtk-dual-4", "abuffer", "dual", "weighted-blended")

_HEAD = """# Accuracy and speed

What a frame costs and how wrong it is, for every method and next to VTK's own. This page was written by

```sh
{command}
```

on {machine}. It makes the page again on another machine; `--quick` gives first numbers in a minute, and
`vtkoit compare` does the same for your own data.

## How it is measured

- Every method has a window of its own with the same scene, all in one process. After a warm-up the methods take turns, a frame each,
  and before each frame the camera turns by half a degree. A time runs until `glFinish()` returns. What is shown are medians; the spread
  is the distance between the quartiles. Slow methods stop after some seconds, with fewer frames: see the column `frames`.
- Times are given as multiples of unsorted blending (`blend`) in the same rounds: other work on the machine disturbs all methods alike.
- The truth is a composite in double precision of all fragments that the A-buffer captured with float colours, sorted by depth;
  fragments of one depth count as one group. `peel` with `TransmittanceThreshold` 0, which shares no sorting with it, is compared with the
  truth where that ends in bearable time. Scenes of more than 24 million fragments take the picture of `abuffer` with float colours instead.
- Errors are those of the 8-bit window, in steps of 1/255, over the pixels that translucent props cover. A right picture is off by up to
  half a step, and by an RMSE of 0.29. The worse of two pictures counts: before and after all timed frames. Alpha is measured over a transparent background.
- The times are those of processor and GPU together. On a GPU its timer queries give its own share too (column `GPU`); a software
  renderer has none.
"""


def write(folder, machine, results, store, command):
    """Writes the page and its pictures into a folder, str. Raises Error.

    machine: dict, as from machine.describe(). results: list of dict. store: Store with their pictures.
    command: str, that makes the page.
    """
    pictures = os.path.join(folder, PICTURES)
    try:
        os.makedirs(pictures, exist_ok=True)
        scenes = tables.by_scene(results)
        text = [_HEAD.format(command=command, machine=where(machine))]
        text += ["## Time of a frame", _times(scenes), "## Against VTK's dual depth peeling",
                 _against_dual(scenes), "## Erroneous pixels", _errors(scenes),
                 "## Methods that are exact", _exact(scenes)]
        text += _families(results, pictures)
        for name in SHOWN:
            for mine in scenes:
                if mine[0]["scene"] == name:
                    text += _in_full(mine, store, pictures)
        with open(os.path.join(folder, PAGE), "w", encoding="utf-8") as file:
            file.write("\n\n".join(part.strip("\n") for part in text) + "\n")
    except OSError as error:
        raise Error("%s: cannot be written: %s" % (folder, error.strerror)) from None


def where(machine):
    """A machine.describe() in a sentence of a page, str."""
    return "%s, %d cores, load average at the start %s, %s, VTK %s, %s, %s" % (
        machine["cpu"], machine["cores"], machine["load"], machine["system"], machine["vtk"],
        machine["renderer"], machine["date"][:10])


def _plain(scenes):
    """The scenes that are no family, lists of results."""
    return [mine for mine in scenes if not mine[0].get("family")]


def table(head, rows):
    """A table in Markdown, str. head: list of str. rows: list of lists of str."""
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def _methods(scenes):
    return list(dict.fromkeys(r["method"] for mine in scenes for r in mine))


def _title(method):
    return "`%s`" % method.replace(":", " ").replace("MaximumNumberOfPeels", "Peels").replace(
        "NumberOfLayersPerPass", "K").replace("TransmittanceThreshold", "Threshold").replace(
        "FragmentPrecision=", "")


def _matrix(scenes, methods, cell):
    """A table of the scenes by the methods; cell: function of a result that returns str."""
    rows = []
    for mine in scenes:
        found = {r["method"]: r for r in mine}
        rows.append([mine[0]["scene"]] + [
            cell(found[m]) if m in found and found[m].get("ms") else "" for m in methods])
    return table(["scene"] + [_title(m) for m in methods], rows)


def _about(mine):
    first = mine[0]
    return "%s (%s; %s triangles, %s fragments, up to %d layer%s)" % (
        first["scene"], first["title"], format(first["triangles"], ","),
        format(first["truth_fragments"], ","), first["truth_layers"],
        "s"[:first["truth_layers"] != 1])


def _times(scenes):
    plain = _plain(scenes)
    if not plain:
        return "No scene was measured."
    methods = [m for m in _methods(plain) if m != "blend"]
    return "\n\n".join([
        "As multiples of unsorted blending, which is fast and wrong; %s." % _sizes(plain),
        _matrix(plain, methods, lambda r: "%.2f" % r["ratio"] if r["ratio"] < 10
                else "%.1f" % r["ratio"]),
        "The scenes:\n\n" + "\n".join("- " + _about(mine) for mine in plain)])


def _sizes(scenes):
    sizes = sorted({(mine[0]["width"], mine[0]["height"]) for mine in scenes})
    return ", ".join("%d x %d pixels" % size for size in sizes)


def _against_dual(scenes):
    """How many times as fast as VTK's dual depth peeling to the end."""
    methods = [m for m in _methods(scenes)
               if m.split(":")[0] in ("auto", "abuffer", "dual", "multilayer", "bucket",
                                      "bucket-pairs", "bucket-adaptive", "peel")
               and "Peels" not in m]
    rows = [mine for mine in scenes if any(r.get("ratio_to_vtk_dual") for r in mine)]
    if not rows:
        return "VTK's dual depth peeling was not measured."
    return "How many times as fast, in scenes of all kinds:\n\n" + _matrix(
        rows, methods,
        lambda r: "%.2f" % (1.0 / r["ratio_to_vtk_dual"]) if r.get("ratio_to_vtk_dual") else "")


def _errors(scenes):
    plain = _plain(scenes)
    return "\n\n".join([
        "Percent of the covered pixels with a channel more than one step off; in parentheses the largest error in steps.",
        _matrix(plain, _methods(plain), lambda r: "%s (%.1f)" % (
                "0" if r["over1"] == 0.0 else "%.3g" % r["over1"], r["max"]))])


def _exact(scenes):
    """The largest errors over all scenes of the methods that say that they are exact."""
    rows = []
    for method in _methods(scenes):
        mine = [r for scene in scenes for r in scene
                if r["method"] == method and r.get("max") is not None and r.get("exact")]
        bounded = [r for scene in scenes for r in scene
                   if r["method"] == method and r.get("max") is not None
                   and r.get("exact") is False and r["error_bound"] < 1.0]
        if not mine + bounded:
            continue
        worst = max(mine + bounded, key=lambda r: r["max"])
        alpha = max((r.get("alpha_max") or 0.0) for r in mine + bounded)
        rows.append([_title(method), str(len(mine)), str(len(bounded)), "%.2f" % worst["max"],
                     worst["scene"], "%.2f" % alpha,
                     str(sum(1 for r in mine + bounded if r["over1"] > 0.0))])
    return "Over all scenes. A method is exact in a frame, or tells a bound below 1 of its error.\n\n" + table(
        ["method", "scenes exact", "scenes within a bound", "largest error, steps", "in scene",
         "largest error of alpha", "scenes with a pixel more than 1 step off"], rows)


def _families(results, pictures):
    text = []
    for family in ("layers", "triangles", "pixels"):
        name = "bench-cost-%s.png" % family
        if plots.cost(os.path.join(pictures, name), results, family, dpi=70):
            text.append("![Cost growing with %s](%s/%s)" % (family, PICTURES, name))
    return ["## Cost growing with layers, triangles and pixels"] + text if text else []


def _in_full(mine, store, pictures):
    """A section about one scene."""
    scene = mine[0]["scene"]
    text = ["## The scene %s in full" % scene,
            "```text\n%s\n```" % "\n".join(tables.text(mine))]
    if scene == SHOWN[0]:
        text.append("```text\n%s\n```" % tables.LEGEND)
    name = "bench-time-error-%s.png" % slug(scene)
    if plots.time_error(os.path.join(pictures, name), mine, dpi=70):
        text.append("![Time against error](%s/%s)" % (PICTURES, name))
    if scene == SHOWN[0]:
        right = store.load_truth(scene, (mine[0]["width"], mine[0]["height"]))
        images = [(r["method"], store.picture(scene, r["method"])) for r in mine
                  if r["method"] in SHEET]
        name = "bench-contact-%s.png" % slug(scene)
        if right is not None and plots.contact_sheet(
                os.path.join(pictures, name), scene, right["color"],
                [(m, i) for m, i in images if i is not None], side=120, columns=8, dpi=80):
            text.append("![Pictures and differences](%s/%s)" % (PICTURES, name))
    return text

