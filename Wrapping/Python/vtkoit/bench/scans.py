# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of one mesh that is seen through itself, as the documents have them: scanned meshes and isosurfaces of
measured data where ../shared/data is present, and surfaces of formulas."""

import os

from .. import camera
from ..read import parse_raw, read_all
from ..surfaces import Request, make_surfaces
from . import data
from .scene import Part, Scene

COLOR = (0.8, 0.6, 0.35)
OPACITY = 0.3


def scenes():
    """Those whose files are present, list of Scene."""
    here = data.folder()
    found = []
    if here is not None:
        slices = [os.path.join(here, "headsq", "quarter.%d" % i) for i in range(1, 94)]
        raw = {"raw": "64x64:uint16", "spacing": (3.2, 3.2, 1.5)}
        found = [
            ("bunny", "a scanned mesh", [os.path.join(here, "bunny.ply")], {}),
            ("bone", "bone in a CT of a head", slices, dict(raw, isovalues=[1150.0])),
            ("skin", "skin in a CT of a head", slices, dict(raw, isovalues=[500.0])),
            ("density", "electron density of a protein", [os.path.join(here, "ironProt.vtk")],
             {"isovalues": [100.0]}),
            ("artery", "speed in an artery", [os.path.join(here, "carotid.vtk")], {"isovalues": [200.0]}),
        ]
    result = [_scene(name, title, _reader(paths, **request))
              for name, title, paths, request in found if os.path.exists(paths[0])]
    return result + [_scene("boy", "Boy's surface", _boy), _scene("wavelet", "isosurface of vtkRTAnalyticSource", _wavelet)]


def _scene(name, title, make):
    return Scene(name, title, lambda: [Part(make(), COLOR, OPACITY)], camera.place)


def _reader(paths, isovalues=None, raw=None, spacing=None):
    def make():
        inputs = read_all(paths, data.Silent(), parse_raw(raw) if raw else None, spacing)
        surfaces, _ = make_surfaces(inputs, Request(isovalues, None, None, 20), data.Silent())
        return surfaces[0].data

    return make


def _boy():
    from vtkmodules.vtkCommonComputationalGeometry import vtkParametricBoy
    from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource

    source = vtkParametricFunctionSource()
    source.SetParametricFunction(vtkParametricBoy())
    source.SetUResolution(150)
    source.SetVResolution(150)
    source.Update()
    return source.GetOutput()


def _wavelet():
    from vtkmodules.vtkFiltersCore import vtkContourFilter
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-40, 40, -40, 40, -40, 40)
    surface = vtkContourFilter()
    surface.SetInputConnection(source.GetOutputPort())
    surface.SetValue(0, 150)
    surface.Update()
    return surface.GetOutput()
