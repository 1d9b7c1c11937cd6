# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Procedural scenes that change one thing at a time: layers, triangles, pixels, coverage, opacity,
props, number of small props, coincident fragments, depth range."""

import numpy

from .scene import Part, Scene, append, facing, mesh, quads, rainbow, sphere

FAMILIES = {
    "layers": (1, 2, 4, 8, 16, 32, 64, 128, 256),
    "triangles": (1e3, 1e4, 1e5, 1e6, 4e6),
    "pixels": (256, 512, 1024, 2048, 4096),
    "coverage": (0.01, 0.1, 0.5, 1.0),
    "opacity": (0.01, 0.1, 0.5, 0.9, 0.99),
    "props": (1, 10, 100, 800, 2000),
    "crowd": (50, 100, 200, 400, 800, 1600, 3200),
    "coincident": (0.0, 0.25, 0.5, 1.0),
    "depth-range": (10.0, 1e3, 1e5, 1e7),
}


def scenes():
    """All of them, list of Scene, a family's in ascending order of its value."""
    makers = {"layers": _layers, "triangles": _triangles, "pixels": _pixels, "coverage": _coverage,
              "opacity": _opacity, "props": _props, "crowd": _crowd,
              "coincident": _coincident, "depth-range": _depth_range}
    return [makers[family](value)._replace(name="%s-%s" % (family, short(value)), family=family,
                                           value=float(value))
            for family, values in FAMILIES.items() for value in values]


def short(value):
    """A number as in a scene's name: 1k, 4M, 0.25, 1e5."""
    for unit, factor in (("M", 1e6), ("k", 1e3)):
        if value >= 1e3 and value % factor == 0 and value < 1e7:
            return "%d%s" % (value / factor, unit)
    return ("%g" % value).replace("e+0", "e")


def stack(count, half_width=1.0, half_height=1.0, opacity=0.05, spacing=0.02, middle=0.0):
    """Squares behind each other around a height on the z axis, in neither order: list of Part of kind "unlit"."""
    step = next(s for s in (37, 31, 29, 23, 1) if count % s or s == 1)
    result = []
    for i in ((n * step) % count for n in range(count)):
        z = middle + spacing * (i - 0.5 * (count - 1))
        x, y = half_width, half_height
        corners = [[(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)]]
        result.append(Part(quads(corners), rainbow(i / count), opacity, "unlit"))
    return result


def spheres(count=16, radius=0.55, opacity=0.4, resolution=64, seed=7):
    """Spheres that overlap around the origin, list of Part."""
    random = numpy.random.default_rng(seed)
    return [Part(sphere(random.uniform(-0.5, 0.5, 3), radius, resolution), rainbow(i / count), opacity)
            for i in range(count)]


def look_at_spheres(renderer):
    """The camera for spheres(): all of them, close."""
    renderer.ResetCamera()
    renderer.GetActiveCamera().Zoom(1.3)
    renderer.ResetCameraClippingRange()


def _layers(count):
    # A quarter of the window, so that the deepest stacks end in bearable time.
    return Scene("", "%d layer%s over a quarter of the window, opacity 0.05" % (
        count, "s"[:count != 1]),
                 lambda: stack(int(count), 0.5, 0.5), lambda r: facing(r, 1.0))


def _triangles(count):
    resolution = max(4, round((count / 8.0) ** 0.5))

    def make():
        return [Part(sphere((0, 0, 0), 1.0 - 0.2 * i, resolution), rainbow(i / 4), 0.35)
                for i in range(4)]

    def place(renderer):
        renderer.ResetCamera()

    return Scene("", "4 nested spheres of %s triangles in all" % format(int(count), ","), make, place)


def _pixels(side):
    return Scene("", "16 overlapping spheres at %d x %d" % (side, side), spheres, look_at_spheres,
                 (side, side))


def _coverage(fraction):
    half = fraction ** 0.5
    return Scene("", "8 layers over %g %% of the window" % (100 * fraction),
                 lambda: stack(8, half, half, 0.3), lambda r: facing(r, 1.0))


def _opacity(opacity):
    return Scene("", "16 overlapping spheres of opacity %g" % opacity,
                 lambda: spheres(opacity=opacity), look_at_spheres)


def _props(count):
    """2000 small spheres in count props: the same fragments."""
    total = 2000

    def make():
        places = numpy.random.default_rng(5).uniform(-1, 1, (total, 3))
        balls = [sphere(p, 0.09, 8) for p in places]
        groups = [balls[i::count] for i in range(count)]
        return [Part(append(group), rainbow(i / count), 0.3) for i, group in enumerate(groups)]

    return Scene("", "2000 small spheres in %d prop%s" % (count, "s"[:count != 1]), make, look_at_spheres)


def _crowd(count):
    """Each sphere is a prop: props, triangles and fragments grow alike."""

    def make():
        places = numpy.random.default_rng(6).uniform(-1, 1, (count, 3))
        return [Part(sphere(p, 0.05, 8), rainbow(i / count), 0.3) for i, p in enumerate(places)]

    def place(renderer):
        facing(renderer, 1.1)

    return Scene("", "%d small spheres, each a prop" % count, make, place)


def _coincident(fraction):
    """Of 16 layers, a fraction has the depth of its neighbour, and another colour."""

    def make():
        pairs = round(8 * fraction)
        result = []
        for i in range(16):
            level = i - (i % 2 if i // 2 < pairs else 0)
            z = 0.02 * (level - 7.5)
            corners = [[(-0.8, -0.8, z), (0.8, -0.8, z), (0.8, 0.8, z), (-0.8, 0.8, z)]]
            result.append(Part(quads(corners), rainbow(i / 16), 0.15, "unlit"))
        return result[::-1]

    return Scene("", "16 layers, %g %% of them coincident in pairs" % (100 * fraction), make,
                 lambda r: facing(r, 1.0))


def _depth_range(ratio):
    """Tilted sheets under a camera whose clipping planes are far apart."""
    far = 100.0

    def make():
        result = []
        for i in range(12):
            # Two families of sheets that cross each other.
            tilt = (0.2 if i % 2 else -0.2) * (1 + i / 12)
            z = 0.05 * (i - 5.5)
            points = [(x, y, z + tilt * x) for y in (-0.8, 0.8) for x in (-0.8, 0.8)]
            result.append(Part(mesh(points, [(0, 1, 3, 2)]), rainbow(i / 12), 0.2, "unlit"))
        return result

    def place(renderer):
        camera = renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 4)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 1, 0)
        camera.SetClippingRange(far / ratio if ratio >= 100 else 2.0,
                                far if ratio >= 100 else 2.0 * ratio)

    return Scene("", "12 sheets that cross, far plane %s times the near plane" % short(ratio), make,
                 place)
