# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Diagrams and contact sheets, by Matplotlib, which nothing else needs."""

import math

import numpy

from ..errors import Error
from ..version import PYTHON_VERSION
from . import accuracy

# What a method that is right leaves in 8 bits, and where the axis of errors ends.
FLOOR = 0.2  # steps
AMPLIFIED = 16.0  # differences on contact sheets

_COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#882255", "#44aa99",
           "#999933", "#aa4499", "#332288", "#117733")
_MARKERS = "osD^vPX<>ph*"
_FAMILY_TITLES = {
    "layers": "layers", "triangles": "triangles", "pixels": "pixels of a side",
    "coverage": "covered part of the window", "opacity": "opacity", "props": "props of the same 2000 spheres", "crowd": "props",
    "coincident": "coincident part of the layers", "depth-range": "far plane / near plane"}
_LINEAR = ("opacity", "coincident")


def matplotlib():
    """matplotlib.pyplot, drawing into files. Raises Error where it is not installed."""
    try:
        import matplotlib as library

        library.use("Agg")
        from matplotlib import pyplot
    except ImportError:
        raise Error("plots need Matplotlib for Python %s (Debian: python3-matplotlib); --no-plots "
                    "leaves them out" % PYTHON_VERSION) from None
    return pyplot


def _style(method, methods):
    """Colour, marker and line of a method: VTK's are grey and dashed."""
    if method == "blend" or method.startswith("vtk-"):
        theirs = [m for m in methods if m == "blend" or m.startswith("vtk-")]
        number = theirs.index(method)
        gray = "%.2f" % (0.1 + 0.6 * number / max(1, len(theirs) - 1))
        return {"color": gray, "marker": _MARKERS[number % len(_MARKERS)], "linestyle": "--"}
    ours = [m for m in methods if m != "blend" and not m.startswith("vtk-")]
    number = ours.index(method)
    return {"color": _COLORS[number % len(_COLORS)],
            "marker": _MARKERS[(number // len(_COLORS) + number) % len(_MARKERS)],
            "linestyle": "-"}


def time_error(path, results, dpi=90):
    """Time of a frame against error of one scene's results (list of dict), with the frontier: the
    methods that no other one beats in both. Writes a PNG file."""
    shown = [r for r in results if r.get("ms") and r.get("rmse") is not None]
    if not shown:
        return False
    pyplot = matplotlib()
    figure, axes = pyplot.subplots(figsize=(7.6, 4.6), dpi=dpi)
    methods = [r["method"] for r in results]
    points = [(r["ms"], max(FLOOR, r["rmse"])) for r in shown]
    best = [points[i] for i in accuracy.frontier(points)]
    # Steps: between two methods of the frontier, the better one is not to be had for less.
    steps = [(best[0][0], 10.0 * max(p[1] for p in points))]
    for x, y in best:
        steps += [(x, steps[-1][1]), (x, y)]
    steps.append((1.6 * max(p[0] for p in points), best[-1][1]))
    axes.plot(*zip(*steps), color="0.75", linewidth=1.5, zorder=1, label="frontier")
    for result, (x, y) in zip(shown, points):
        style = _style(result["method"], methods)
        axes.plot([x], [y], style["marker"], color=style["color"], markersize=8, zorder=2,
                  markeredgecolor="white", label=result["method"])
        axes.hlines(y, result["ms_low"], result["ms_high"], color=style["color"], linewidth=1)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(0.7 * min(p[0] for p in points), 1.5 * max(p[0] for p in points))
    axes.set_ylim(0.8 * FLOOR, 2.0 * max(p[1] for p in points))
    _plain_ticks(axes)
    axes.axhline(1.0 / math.sqrt(12.0), color="0.85", linewidth=1, zorder=0)
    axes.set_xlabel("milliseconds of a frame (median, line: quartiles)")
    axes.set_ylabel("RMSE of covered pixels, steps of 1/255")
    axes.set_title("%s: %s" % (results[0]["scene"], results[0]["title"]), fontsize=10)
    _finish(figure, axes, pyplot, path)
    return True


def cost(path, results, family, dpi=90):
    """Time of a frame growing with what a family of scenes changes. Writes a PNG file."""
    mine = [r for r in results if r.get("family") == family and r.get("ms")]
    if len({r["value"] for r in mine}) < 2:
        return False
    pyplot = matplotlib()
    figure, axes = pyplot.subplots(figsize=(7.6, 4.6), dpi=dpi)
    methods = list(dict.fromkeys(r["method"] for r in mine))
    for method in methods:
        line = sorted((r["value"], r["ms"]) for r in mine if r["method"] == method)
        style = _style(method, methods)
        axes.plot(*zip(*line), label=method, markersize=5, linewidth=1.2, **style)
    values = sorted({r["value"] for r in mine})
    if family not in _LINEAR:
        # From 0 on, linear as far as the second value.
        axes.set_xscale("symlog", linthresh=values[1]) if values[0] == 0.0 else axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xticks(values)
    axes.set_xticks([], minor=True)
    from .families import short

    axes.set_xticklabels([short(value) for value in values])
    _plain_ticks(axes, x=False)
    axes.set_xlabel(_FAMILY_TITLES.get(family, family))
    axes.set_ylabel("milliseconds of a frame")
    sizes = sorted({(r["width"], r["height"]) for r in mine})
    axes.set_title("cost growing with %s%s" % (
        _FAMILY_TITLES.get(family, family),
        ", %d x %d" % sizes[0] if len(sizes) == 1 else ""), fontsize=10)
    _finish(figure, axes, pyplot, path)
    return True


def _plain_ticks(axes, x=True):
    """Ticks of log axes at 1, 2, 5, 10, ... as plain numbers."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    for axis in [axes.xaxis, axes.yaxis] if x else [axes.yaxis]:
        axis.set_major_locator(LogLocator(base=10.0, subs=(1.0, 2.0, 5.0)))
        axis.set_major_formatter(FuncFormatter(lambda value, _: "%g" % value))
        axis.set_minor_formatter(NullFormatter())


def _finish(figure, axes, pyplot, path):
    axes.grid(True, color="0.93", linewidth=0.8, zorder=0)
    axes.legend(fontsize=7, loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False)
    figure.tight_layout()
    figure.savefig(path)
    pyplot.close(figure)


def contact_sheet(path, title, truth, pictures, side=190, columns=6, dpi=100):
    """Image and amplified difference of each method. Writes a PNG file.

    truth: float array, height x width x 3, in [0, 1]. pictures: list of (str, array of uint8, height
    x width x 3); the caption is the str. side: int, pixels of the longer side of a picture.
    """
    if not pictures:
        return False
    pyplot = matplotlib()
    right = numpy.rint(255.0 * numpy.clip(truth, 0.0, 1.0)).astype(numpy.uint8)
    tiles = [("truth", right, None)]
    for caption, picture in pictures:
        difference = numpy.abs(picture.astype(float) - 255.0 * numpy.clip(truth, 0.0, 1.0))
        tiles.append((caption, picture, numpy.clip(
            AMPLIFIED * numpy.maximum(0.0, difference - 0.5), 0, 255).astype(numpy.uint8)))
    columns = min(columns, len(tiles))
    rows = -(-len(tiles) // columns)
    height, width = truth.shape[:2]
    scale = side / max(height, width)
    tile = (scale * width / dpi, scale * height / dpi)
    figure, axes = pyplot.subplots(
        2 * rows, columns, squeeze=False, dpi=dpi,
        figsize=(columns * (tile[0] + 0.06), rows * (2 * tile[1] + 0.4) + 0.4))
    for axis in axes.ravel():
        axis.set_axis_off()
    for number, (caption, image, difference) in enumerate(tiles):
        row, column = 2 * (number // columns), number % columns
        axes[row][column].imshow(image, interpolation="antialiased")
        axes[row][column].set_title(caption, fontsize=6.5, pad=2)
        if difference is not None:
            axes[row + 1][column].imshow(difference, interpolation="nearest")
    figure.suptitle("%s; below: %g times the difference beyond rounding" % (title, AMPLIFIED),
                    fontsize=8)
    figure.subplots_adjust(left=0.005, right=0.995, bottom=0.005,
                           top=1.0 - 0.5 / figure.get_figheight(), wspace=0.03, hspace=0.08)
    figure.savefig(path)
    pyplot.close(figure)
    return True
