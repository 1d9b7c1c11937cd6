# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of data files: the data sets of ../shared/data where they are present, and any file."""

import os

from .. import camera, colors, volumes
from ..errors import printable
from ..read import parse_raw, read_all
from ..scene import opacity_of
from ..surfaces import Request, make_surfaces
from .scene import Cloud, Part, Scene

ENVIRONMENT = "VTKOIT_DATA"


class Silent:
    """In the place of a progress.Progress."""

    def watch(self, algorithm, text):
        pass

    def begin(self, text):
        pass

    def show(self, text, fraction=None):
        pass


def folder():
    """The folder of data sets, str: $VTKOIT_DATA, or shared/data beside a folder above this one or
    above the working directory; None where there is none."""
    if os.environ.get(ENVIRONMENT):
        return os.environ[ENVIRONMENT]
    for start in (os.getcwd(), os.path.dirname(os.path.realpath(__file__))):
        while True:
            found = os.path.join(start, "shared", "data")
            if os.path.isfile(os.path.join(found, "ironProt.vtk")):
                return found
            parent = os.path.dirname(start)
            if parent == start:
                break
            start = parent
    return None


def scenes():
    """Those whose files are present, list of Scene."""
    here = folder()
    if here is None:
        return []

    def path(*names):
        return os.path.join(here, *names)

    slices = [path("headsq", "quarter.%d" % i) for i in range(1, 94)]
    found = [
        ("protein", "electron density, 8 nested isosurfaces", [path("ironProt.vtk")],
         {"isovalues": [30.0 + 25.0 * i for i in range(8)]}, [0.2]),
        ("head", "CT of a head: skin over bone", slices,
         {"isovalues": [500.0, 1150.0], "raw": "64x64:uint16", "spacing": (3.2, 3.2, 1.5)},
         [0.3, 0.8]),
        ("frog", "a frog, one surface a tissue", [path("froggy", "frogtissue.mhd")],
         {"labels": [], "smoothing": 20}, [0.35]),
        ("carotid", "isosurfaces of the speed in an artery", [path("carotid.vtk")],
         {"isovalues": [100.0, 200.0, 300.0, 400.0]}, [0.2, 0.3, 0.4, 0.5]),
        ("disk", "temperature in a flow reactor", [path("disk_out_ref.ex2")],
         {"isovalues": [350.0, 450.0, 550.0, 650.0, 750.0], "contour": "Temp"}, [0.3]),
    ]
    result = [_scene(name, title, paths, opacities, **request)
              for name, title, paths, request, opacities in found if os.path.exists(paths[0])]
    if os.path.exists(slices[0]):
        result.append(Scene("head-volume", "CT of a head as a volume, its skin and its bone as surfaces",
                            lambda: _head_volume(slices), _look_up))
    if os.path.exists(path("bunny.ply")):
        result.append(Scene("bunnies", "a scanned mesh of 69 k triangles, 9 times, overlapping",
                            lambda: _bunnies(path("bunny.ply")), _look))
    return result


def file_scene(path):
    """A Scene of a file that the user names, drawn as the command render draws it."""
    return _scene(printable(path), "the file %s" % printable(os.path.basename(path)), [path], None)


def _scene(name, title, paths, opacities, raw=None, spacing=None, isovalues=None, contour=None,
           labels=None, smoothing=20):
    def make():
        inputs = read_all(paths, Silent(), parse_raw(raw) if raw else None, spacing)
        surfaces, _ = make_surfaces(inputs, Request(isovalues, contour, labels, smoothing), Silent())
        parts = []
        for i, surface in enumerate(surfaces):
            opacity = opacity_of(i, len(surfaces)) if opacities is None \
                else opacities[min(i, len(opacities) - 1)]
            parts.append(Part(surface.data, colors.palette_color(i), opacity))
        return parts

    return Scene(name, title, make, _look)


def _look(renderer):
    camera.place(renderer)


def _head_volume(slices):
    inputs = read_all(slices, Silent(), parse_raw("64x64:uint16"), (3.2, 3.2, 1.5))
    surfaces, _ = make_surfaces(inputs, Request([500.0, 1150.0], None, None, 20), Silent())
    wanted = volumes.Request(None, [(500.0, 0.0), (900.0, 0.03), (1150.0, 0.03), (1400.0, 0.15)], 3.0, False)
    made, _ = volumes.make_volumes(inputs, wanted)
    return [Cloud(made[0], "inferno", (200.0, 1800.0), None)] + [
        Part(surface.data, color, opacity) for surface, color, opacity in
        zip(surfaces, ((0.9, 0.65, 0.5), (0.95, 0.93, 0.85)), (0.15, 0.5))]


def _look_up(renderer):
    camera.place(renderer, (60.0, 10.0), (0, 0, -1))


def _bunnies(path):
    from vtkmodules.vtkCommonTransforms import vtkTransform
    from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

    inputs = read_all([path], Silent())
    surfaces, _ = make_surfaces(inputs, Request(None, None, None, 20), Silent())
    data = surfaces[0].data
    length = data.GetLength()
    result = []
    for i in range(9):
        place = vtkTransform()
        place.RotateX(90)  # its y axis points up
        place.RotateY(40.0 * i)
        place.Translate(0.12 * length * (i % 3 - 1), 0.0, 0.12 * length * (i // 3 - 1))
        placed = vtkTransformPolyDataFilter()
        placed.SetTransform(place)
        placed.SetInputData(data)
        placed.Update()
        result.append(Part(placed.GetOutput(), colors.palette_color(i), 0.3))
    return result
