# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The results as text, CSV and JSON."""

import csv
import json

from .measure import REFERENCE
from .truth import FINER

DUAL = "vtk-dual"

# Columns of the CSV file and, in this order, the keys of a result.
COLUMNS = (
    "scene", "family", "value", "method", "reason", "width", "height", "triangles", "props",
    "frames", "ms", "ms_low", "ms_high", "cpu_ms", "gpu_ms", "still_ms", "fps", "ratio", "cpu_ratio",
    "ratio_to_vtk_dual", "cpu_ratio_to_vtk_dual", "algorithm", "exact", "error_bound", "passes",
    "fragments", "layers", "bytes", "truth", "truth_fragments", "truth_layers", "cross_check",
    "max", "rmse", "psnr", "p99", "over0", "over1", "over8",
    "alpha_max", "alpha_rmse", "alpha_psnr", "alpha_p99", "alpha_over0", "alpha_over1",
    "alpha_over8")


def relate(results):
    """Adds to each result (dict) of one scene its ratios to VTK's dual depth peeling, in place."""
    dual = next((r for r in results if r["method"] == DUAL and r.get("ratio")), None)
    for result in results:
        for key in ("ratio", "cpu_ratio"):
            both = dual is not None and result.get(key) and dual.get(key)
            result[key + "_to_vtk_dual"] = result[key] / dual[key] if both else None


def by_scene(results):
    """Lists of results with the same scene, in their order."""
    scenes = {}
    for result in results:
        scenes.setdefault(result["scene"], []).append(result)
    return list(scenes.values())


def heading(result):
    """One line about the scene of a result, str."""
    text = "%s: %s; %d x %d, %s triangles, %d prop%s" % (
        result["scene"], result["title"], result["width"], result["height"],
        format(result["triangles"], ","), result["props"], "s"[:result["props"] != 1])
    if result.get("truth_fragments") is not None:
        text += ", %s fragments, up to %d layer%s" % (
            format(result["truth_fragments"], ","), result["truth_layers"],
            "s"[:result["truth_layers"] != 1])
    if result.get("truth"):
        text += "; truth: " + {"fragments": "fragments in double precision",
                               "abuffer": "the picture of abuffer with float colours",
                               "peel": "the picture of peel, in steps of 8 bits",
                               "samples": "the picture of abuffer with %d times the samples" % FINER}[result["truth"]]
        if result.get("cross_check") is not None:
            text += ", %s differs by at most %.2f steps" % (
                "vtk-dual with as many" if result["truth"] == "samples" else "peel", result["cross_check"])
    return text


_TEXT = (  # heading, key, format, width
    ("ms", "ms", "%.1f", 9), ("IQR", None, None, 6), ("frames", "frames", "%d", 7), ("GPU", "gpu_ms", "%.1f", 8),
    ("x blend", "ratio", "%.2f", 8), ("cpu x", "cpu_ratio", "%.2f", 7),
    ("x dual", "ratio_to_vtk_dual", "%.3f", 8), ("still", "still_ms", "%.1f", 9),
    ("passes", "passes", "%d", 7), ("MiB", None, None, 6), ("exact", None, None, 6),
    ("max", "max", "%.1f", 6), ("RMSE", "rmse", "%.2f", 6), ("PSNR", "psnr", "%.1f", 6),
    ("p99", "p99", "%.1f", 6), (">0 %", "over0", "%.2f", 7), (">1 %", "over1", "%.3f", 8),
    (">8 %", "over8", "%.3f", 8), ("a max", "alpha_max", "%.1f", 6),
    ("a >1 %", "alpha_over1", "%.2f", 7))


def headings():
    """What the cells of a result are, list of str."""
    return [title for title, _, _, _ in _TEXT]


def cells(result):
    """The numbers of a result that was measured, list of str."""
    found = []
    for title, key, form, _ in _TEXT:
        value = result.get(key) if key else None
        if title == "IQR":
            cell = "%.0f%%" % (100.0 * (result["ms_high"] - result["ms_low"]) / result["ms"])
        elif title == "MiB":
            cell = "-" if result.get("bytes") is None else "%.0f" % (result["bytes"] / 2 ** 20)
        elif title == "exact":
            cell = {True: "yes", False: "no", None: "-"}[result.get("exact")]
        else:
            cell = "-" if value is None else form % value
        found.append(cell)
    return found


def drawn_by(result):
    """What drew a result in its method's place or by its choice, str; empty for the method itself."""
    if result["reason"]:
        return "drawn by %s: %s" % (result["algorithm"], result["reason"])
    if result["method"].split(":")[0] == "auto":
        return "drawn by %s" % result["algorithm"]
    return ""


def text(results):
    """A table of the results of one scene, list of str, a line each."""
    width = max(len(result["method"]) for result in results)
    lines = [heading(results[0]),
             "  %-*s" % (width, "method") + "".join("%*s" % (w, h) for h, _, _, w in _TEXT)]
    for result in results:
        if result.get("ms") is None:
            lines.append("  %-*s  %s" % (width, result["method"], result["reason"]))
            continue
        row = ["%*s" % (column[3], cell) for column, cell in zip(_TEXT, cells(result))]
        told = drawn_by(result)
        lines.append("  %-*s" % (width, result["method"]) + "".join(row) + (told and "  " + told))
    return lines


LEGEND = """ms: median of a frame of a turning camera; IQR: between the quartiles, of the median; x blend, x dual:
as multiples of {0} and of {1}; cpu x: of {0}, in time of all cores; GPU: ms by its timer queries; still:
ms with a camera that does not turn.
max, RMSE, p99 in steps of 1/255, PSNR in dB, of the colours of covered pixels; >n %: pixels with a
channel more than n steps off, >0 for another value than the nearest; a: of alpha.""".format(
    REFERENCE, DUAL)


def write_csv(path, results, machine):
    """Writes all results to a file, the machine's description as comment lines before them."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        for key, value in machine.items():
            file.write("# %s: %s\n" % (key, value))
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for result in results:
            writer.writerow(["" if result.get(key) is None else result[key] for key in COLUMNS])


def write_json(path, results, machine, configuration):
    """Writes all results to a file with the machine's description and the configuration, dict."""
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"machine": machine, "configuration": configuration, "results": results}, file,
                  indent=1)
        file.write("\n")
