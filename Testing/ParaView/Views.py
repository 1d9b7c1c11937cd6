# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests share that pvpython runs: scenes, pictures, the settings page.

Environment: VTKOIT_PLUGIN, the path of the plugin; VTKOIT_PYTHON, the folder of the package vtkoit that was built
for the VTK of this ParaView.
"""

import os
import sys
import tempfile
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

PLUGIN = os.environ["VTKOIT_PLUGIN"]
SIZE = (120, 90)
ALPHA = 0.2  # of each layer of the stack
COLORS = numpy.array([[255, 0, 0], [0, 255, 0], [0, 0, 255]])
HEIGHTS = numpy.array([i * 7 % 20 / 20.0 for i in range(20)])  # in the order of drawing

sys.path.insert(0, os.environ["VTKOIT_PYTHON"])


def expected(background):
    """What the stack looks like, by the definition. background: r, g, b, a, multiplied by a, from 0 to 255."""
    result = numpy.zeros(4)
    transmittance = 1.0
    for i in numpy.argsort(-HEIGHTS):
        result += transmittance * ALPHA * numpy.array([*COLORS[i % 3], 255.0])
        transmittance *= 1.0 - ALPHA
    return result + transmittance * numpy.asarray(background, dtype=float)


def load_plugin(remote=False):
    simple.LoadPlugin(PLUGIN, remote=remote)


def page():
    """The settings page, or None."""
    return simple.GetSettingsProxy("Translucency")


def write_stack(path):
    """Squares over each other, in an order that is neither that of their heights nor its reverse."""
    corners = numpy.array([(-9, -9), (9, -9), (9, 9), (-9, 9)], dtype=float)
    points = numpy.concatenate([numpy.column_stack([corners, numpy.full(4, z)]) for z in HEIGHTS])
    data = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(coordinates)
    cells = vtkCellArray()
    cells.SetData(4, numpy_to_vtkIdTypeArray(numpy.arange(len(points)), deep=True))
    data.SetPolys(cells)
    colors = numpy_to_vtk(COLORS[numpy.arange(len(HEIGHTS)) % 3].astype(numpy.uint8), deep=True)
    colors.SetName("Colors")
    data.GetCellData().SetScalars(colors)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.Write()


class ViewTest(unittest.TestCase):
    """With a folder of its own, and without views left by others."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="paraview-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def make_view(self, **properties):
        view = simple.CreateView("RenderView")
        self.addCleanup(self.delete, view)
        properties = {"ViewSize": SIZE, "OrientationAxesVisibility": 0, "UseColorPaletteForBackground": 0,
                      "Background": [0, 0, 0], **properties}
        for name, value in properties.items():
            setattr(view, name, value)
        return view

    @staticmethod
    def delete(view):
        """A view, unless its session has ended."""
        connection = servermanager.ActiveConnection
        if view.SMProxy and connection and view.GetSession() == connection.Session:
            simple.Delete(view)

    def show_stack(self, view):
        """The stack as it fills the view, unlit. Returns its source."""
        write_stack(self.path("stack.vtp"))
        source = simple.XMLPolyDataReader(FileName=[self.path("stack.vtp")])
        shown = simple.Show(source, view)
        simple.ColorBy(shown, ("CELLS", "Colors"))
        shown.MapScalars = 0
        shown.Opacity = ALPHA
        shown.Ambient = 1.0
        shown.Diffuse = 0.0
        view.CameraPosition = [0, 0, 5]
        view.CameraFocalPoint = [0, 0, 0]
        view.CameraParallelProjection = 1
        view.CameraParallelScale = 1
        return source

    def show_scene(self, view):
        """Surfaces through each other, lit and coloured as they come. Returns the source of the smooth ones."""
        wavelet = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
        contours = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[90, 130, 170, 210])
        shown = simple.Show(contours, view)
        simple.ColorBy(shown, ("POINTS", "RTData"))
        shown.Opacity = 0.3
        box = simple.Show(simple.Box(XLength=20, YLength=6, ZLength=6), view)
        box.Opacity = 0.4
        box.DiffuseColor = box.AmbientColor = [0, 0.6, 1]
        view.CameraPosition = [30, 25, 40]
        view.CameraFocalPoint = [0, 0, 0]
        view.CameraViewUp = [0, 1, 0]
        return contours

    def picture(self, view, **options):
        """What a screenshot of the view has: height x width x components, int."""
        path = self.path("picture.png")
        simple.SaveScreenshot(path, view, ImageResolution=SIZE, **options)
        return read_picture(path)


def read_picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).astype(int)


def main():
    """As Support.main() of the other tests: exit status 125 when all tests were skipped."""
    result = unittest.main(exit=False, argv=[sys.argv[0], "-v", *sys.argv[1:]]).result
    nothing = result.wasSuccessful() and len(result.skipped) == result.testsRun
    sys.stdout.flush()
    sys.exit(not result.wasSuccessful() or (125 if nothing else 0))


__all__ = ["ALPHA", "SIZE", "ViewTest", "expected", "load_plugin", "main", "page", "read_picture", "servermanager",
           "simple"]
