# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the automatic choice rests on: the cost of fragments, pixels, triangles and bands by each method, and
all of them in limited memory."""

import collections

import numpy

from . import families, rounds
from .document import table
from .measure import REFERENCE
from .scene import Part, Scene, facing, mesh, rainbow, sphere
from .stage import Stage

PAGE = "costs.md"
METHODS = ("abuffer", "multilayer", "dual")
BANDS = (1, 2, 4, 8)  # of the A-buffer, about

Sizes = collections.namedtuple("Sizes", "layers triangles closed bands")
Sizes.__doc__ = """What is swept: layers, list of int; triangles of a prop, list of int; closed, list of int, closed
props in an order; bands, list of int."""
FULL = Sizes([1, 4, 16, 32, 64, 128], [1000, 10000, 100000], [16, 64, 256], BANDS)
QUICK = Sizes([1, 4, 8], [1000, 10000], [4], BANDS[:2])


def crossing(count, resolution=1, opacity=0.05):
    """Lit sheets that cross each other, over a quarter of the window: list of Part. resolution: squares
    along a side of each."""
    steps = numpy.linspace(-0.5, 0.5, resolution + 1)
    result = []
    for i in range(count):
        slope = 1.8 * ((i + 0.5) / count - 0.5)
        points = [(x, y, slope * x) for y in steps for x in steps]
        row = resolution + 1
        cells = [(a, a + 1, a + row + 1, a + row)
                 for a in (y * row + x for y in range(resolution) for x in range(resolution))]
        result.append(Part(mesh(points, cells), rainbow(i / count), opacity))
    return result


def _scene(name, title, make):
    return Scene(name, title, make, lambda renderer: facing(renderer, 1.0))


def _sheets(layers, resolution=1, opacity=0.05):
    name = "%d sheets of %s triangles" % (layers, format(2 * resolution ** 2, ","))
    if opacity != 0.05:
        name += ", opacity %g" % opacity
    return _scene(name, "sheets that cross each other",
                  lambda: crossing(layers, resolution, opacity))


def _row(count, resolution):
    """Closed spheres behind each other."""
    def make():
        return [Part(_flat_sphere(0.1 * (i - 0.5 * count), resolution), rainbow(i / count), 0.2)
                for i in range(count)]

    return _scene("%d behind each other" % count, "flattened spheres", make)


def _grid(count, resolution):
    """Closed spheres beside each other, whose rectangles touch."""
    side = round(count ** 0.5)

    def make():
        step = 2.0 / side
        return [Part(sphere((step * (i % side + 0.5) - 1, step * (i // side + 0.5) - 1, 0), 0.48 * step,
                            resolution), rainbow(i / count), 0.2) for i in range(side * side)]

    return _scene("%d beside each other" % (side * side), "spheres", make)


def _flat_sphere(z, resolution):
    from vtkmodules.vtkCommonTransforms import vtkTransform
    from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

    place = vtkTransform()
    place.Translate(0.0, 0.0, z)
    place.Scale(1.0, 1.0, 0.05)
    placed = vtkTransformPolyDataFilter()
    placed.SetTransform(place)
    placed.SetInputData(sphere((0, 0, 0), 0.5, resolution))
    placed.Update()
    return placed.GetOutput()


class Study:
    """Takes all measurements; each method is a list of results by case."""

    def __init__(self, size, settings, sizes, progress):
        """size: (width, height). settings: rounds.Settings. sizes: Sizes."""
        self.size = size
        self.settings = settings
        self.sizes = sizes
        self.progress = progress

    def run(self):
        """All results, dict of lists of dict."""
        return {"layers": self._layers(), "triangles": self._triangles(), "bands": self._bands(),
                "closed": self._closed()}

    def _take(self, scene, names, size=None, **facts):
        stage = Stage(scene, size or self.size)
        taken = rounds.take(stage, [REFERENCE, *names], self.settings, self.progress)
        results = []
        for name in [REFERENCE, *names]:
            mine = taken[name]
            told = mine.statistics
            results.append({
                **facts, "scene": scene.name, "method": name, "triangles": stage.facts()["triangles"],
                "ms": float(1000.0 * numpy.median(mine.seconds)),
                "cpu_ms": float(1000.0 * numpy.median(mine.cpu)),
                "ratio": rounds.ratio(mine.cpu, taken[REFERENCE].cpu)[0],
                "passes": 1 if told is None else told.passes,
                "fragments": None if told is None else told.fragments,
                "bytes": 0 if told is None else told.bytes, "summary": mine.summary})
        return results

    def _layers(self):
        return [r for n in self.sizes.layers for r in self._take(_sheets(n), METHODS, layers=n)]

    def _triangles(self):
        # Few pixels: what grows is the work on vertices.
        results = []
        for number in self.sizes.triangles:
            scene = _sheets(4, round((number / 2) ** 0.5))
            results += self._take(scene, METHODS, (64, 64), number=number)
        return results

    def _bands(self):
        layers = self.sizes.layers[2]
        fine = 100 if self.sizes is FULL else 20
        results = []
        for scene in (_sheets(layers), _sheets(layers, fine), _sheets(2 * layers),
                      _sheets(4 * layers, fine // 2, 0.5)):
            whole = self._take(scene, ["abuffer"])[1]
            for bands in self.sizes.bands:
                # As much as that many bands of fragments need, with what each band needs besides.
                limit = max(2 ** 20, int(1.15 * whole["fragments"] * 16 / bands))
                names = ["%s:MaximumBufferSize=%d" % (m, limit) for m in METHODS]
                results += self._take(scene, names, bands=bands, limit=limit)
        return results

    def _closed(self):
        results = []
        for count in self.sizes.closed:
            for make, resolution in ((_row, 16), (_row, 64), (_grid, 16), (_grid, 48)):
                results += self._take(make(count, resolution), ["auto", "auto:SkipSorting=0"],
                                      resolution=resolution)
        return results


def constants(results):
    """What things cost: list of (what, dict of method to float), as multiples of a fragment of unsorted
    blending, and nanoseconds of that, float. results: dict of lists of dict, of Study.run()."""
    by = {(r["method"], r["layers"]): r for r in results["layers"]}
    steps = sorted({r["layers"] for r in results["layers"]})
    pixels = by["abuffer", 1]["fragments"]
    every = (REFERENCE, *METHODS)

    def slope(method, low, high):
        rise = by[method, high]["cpu_ms"] - by[method, low]["cpu_ms"]
        return rise / ((high - low) * pixels)

    few = [n for n in steps if n <= 32]
    unit = slope(REFERENCE, few[1], few[-1])
    rows = [("a fragment, of %d to %d layers" % (few[1], few[-1]),
             {m: slope(m, few[1], few[-1]) / unit for m in every})]
    if steps[-1] > few[-1]:
        rows.append(("a fragment, of %d to %d layers" % (few[-1], steps[-1]),
                     {m: slope(m, few[-1], steps[-1]) / unit for m in every}))
    rows.append(("a pixel of the screen stages", {
        m: (by[m, few[0]]["cpu_ms"] / pixels - slope(m, few[0], few[1])) / unit for m in METHODS}))
    mine = {(r["method"], r["number"]): r for r in results["triangles"]}
    numbers = sorted({r["number"] for r in results["triangles"]})
    rows.append(("a triangle in a geometry pass", {
        m: (mine[m, numbers[-1]]["cpu_ms"] - mine[m, numbers[0]]["cpu_ms"]) / unit / (
            mine[m, numbers[-1]]["triangles"] * mine[m, numbers[-1]]["passes"] -
            mine[m, numbers[0]]["triangles"] * mine[m, numbers[0]]["passes"]) for m in every}))
    return rows, 1e6 * unit


_HEAD = """# What the automatic choice rests on

What fragments, pixels, triangles and bands cost by the methods between which [vtkOITAutoPass](vtkOITAutoPass.md) chooses. This
page was written by

```sh
{command}
```

on {machine}.

All times are processor time of all cores; unsorted blending and the methods take turns in one process, a frame each, after a warm-up,
up to {frames} frames of {size} pixels while the camera turns. The scenes are lit sheets that cross each other over a quarter of the window.
`multilayer` and `dual` with their default `TransmittanceThreshold`. "x" is a multiple of unsorted blending in the same rounds.

## Constants

As multiples of a fragment of unsorted blending, which is {unit:.1f} ns here. Differences between two scenes, divided by
what there is more of.
"""


def page(results, where, command, settings, size):
    """The page in Markdown, str. results: dict of lists of dict, of Study.run(). where: str, the machine."""
    rows, unit = constants(results)
    every = (REFERENCE, *METHODS)
    parts = [_HEAD.format(command=command, machine=where, frames=settings.frames,
                          size="%d x %d" % size, unit=unit),
             table(["cost of"] + ["`%s`" % m for m in every],
                   [[what] + [_number(by.get(m)) for m in every] for what, by in rows]),
             "## Layers", "x blend; in parentheses the geometry passes.",
             _cases(results["layers"], "layers", METHODS, lambda r: str(r["layers"])),
             "## Triangles", "4 sheets in 64 x 64 pixels: few fragments.",
             _cases(results["triangles"], "triangles of the scene", METHODS,
                    lambda r: format(r["triangles"], ",")),
             "## Limited memory",
             "`MaximumBufferSize` such that the fragments of an A-buffer take about 1, 2, 4 and 8 times as much; the same limit for all.",
             _cases(results["bands"], "scene, limit", METHODS, lambda r: "%s, %.1f MiB" % (
                 r["scene"], r["limit"] / 2 ** 20)),
             "## Closed convex props", "Blended, far faces before near ones (`auto`), or sorted (`auto:SkipSorting=0`).",
             _cases(results["closed"], "props, triangles in all", ("auto", "auto:SkipSorting=0"),
                    lambda r: "%s, %s" % (r["scene"], format(r["triangles"], ",")))]
    return "\n\n".join(part.strip("\n") for part in parts) + "\n"


def _number(value):
    return "" if value is None else "%.2f" % value if abs(value) < 10.0 else "%.0f" % value


def _cases(results, head, methods, label):
    """A table of the cases by the methods. label: function of a result that returns str."""
    rows = {}
    for r in results:
        rows.setdefault(label(r), {})[r["method"].partition(":MaximumBufferSize")[0]] = r
    return table([head, "`%s` ms" % REFERENCE] + ["`%s`" % m for m in methods], [
        [name, "%.1f" % by[REFERENCE]["cpu_ms"]] +
        ["%s (%d)" % (_number(by[m]["ratio"]), by[m]["passes"]) for m in methods]
        for name, by in rows.items()])
