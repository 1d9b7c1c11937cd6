# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the Python tests share: running the command line, small files, small scenes."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import vtkoit
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
from vtkmodules.util.numpy_support import vtk_to_numpy

# bin/vtkoit, whether this is a build tree or an installation.
PACKAGE = os.path.dirname(os.path.realpath(vtkoit.__file__))


def program(name="vtkoit"):
    """The path of bin/NAME above the package."""
    folder = PACKAGE
    while not os.path.isfile(os.path.join(folder, "bin", name)):
        parent = os.path.dirname(folder)
        if parent == folder:
            raise RuntimeError("no bin/%s above %s" % (name, PACKAGE))
        folder = parent
    return os.path.join(folder, "bin", name)


def bare_environment():
    """This environment without what bin/vtkoit-python and displays put into it."""
    return {name: value for name, value in os.environ.items()
            if name not in ("PYTHONPATH", "DISPLAY", "LD_LIBRARY_PATH", "LD_PRELOAD",
                            "VTK_DEFAULT_OPENGL_WINDOW")}


def run(*arguments, cwd=None, name="vtkoit", timeout=None, **variables):
    """Runs bin/NAME with the arguments and environment variables; the subprocess.CompletedProcess
    with text. timeout: float, seconds after which it is ended by an exception."""
    return subprocess.run([program(name), *arguments], cwd=cwd, env={**bare_environment(), **variables},
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False, timeout=timeout)


def main():
    """Runs the tests of the program; exit status 125 when all of them were skipped."""
    result = unittest.main(exit=False).result
    nothing = result.wasSuccessful() and len(result.skipped) == result.testsRun
    sys.exit(not result.wasSuccessful() or (125 if nothing else 0))


class FolderTest(unittest.TestCase):
    """A test with a folder of its own below the working directory: self.folder."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix=type(self).__name__ + "-", dir=os.getcwd())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def vtkoit(self, *arguments):
        return run(*arguments, cwd=self.folder)


def write_sphere(path, radius=1.0, resolution=24):
    sphere = vtkSphereSource()
    sphere.SetRadius(radius)
    sphere.SetThetaResolution(resolution)
    sphere.SetPhiResolution(resolution)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputConnection(sphere.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def write_spheres(path):
    """Three spheres through each other, in one data set."""
    append = vtkAppendPolyData()
    for i in range(3):
        sphere = vtkSphereSource()
        sphere.SetCenter(0.35 * i, 0.2 * i, 0.3 * i)
        sphere.SetRadius(0.6)
        sphere.SetThetaResolution(32)
        sphere.SetPhiResolution(32)
        append.AddInputConnection(sphere.GetOutputPort())
    writer = vtkXMLPolyDataWriter()
    writer.SetInputConnection(append.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def write_volume(path, half=10):
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-half, half, -half, half, -half, half)
    writer = vtkXMLImageDataWriter()
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def write_labels(path):
    """A label volume of two cuboids, labels 3 and 7; 7 touches the border of the volume."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData

    values = numpy.zeros((16, 20, 24), dtype=numpy.uint8)
    values[4:9, 5:15, 4:10] = 3
    values[4:16, 5:15, 12:20] = 7
    image = vtkImageData()
    image.SetDimensions(24, 20, 16)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    writer = vtkMetaImageWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def read_picture(path):
    """A PNG file as an array of uint8, height x width x components, top row first."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


def add_actor(renderer, source, color, opacity, lighting=True):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetLighting(lighting)
    renderer.AddActor(actor)
    return actor


def add_quad(renderer, z, color, opacity):
    """An unlit square from -1 to 1 at a height z."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-1, -1, z)
    plane.SetPoint1(1, -1, z)
    plane.SetPoint2(-1, 1, z)
    return add_actor(renderer, plane, color, opacity, lighting=False)


def quad_renderer(background=(0, 0, 0), alpha=1.0):
    """A renderer that looks down on the square, which fills the picture."""
    renderer = vtkRenderer()
    renderer.SetBackground(*background)
    renderer.SetBackgroundAlpha(alpha)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.9)
    camera.SetPosition(0, 0, 5)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetClippingRange(0.1, 10)
    return renderer


def sphere_renderer():
    """Three spheres inside and through each other, around an opaque one."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for i, color in enumerate([(0.8, 0.2, 0.2), (0.2, 0.7, 0.3), (0.2, 0.3, 0.9), (1, 1, 0)]):
        sphere = vtkSphereSource()
        sphere.SetCenter(0.5 * i, 0.2 * i, 0.1 * i)
        sphere.SetThetaResolution(32)
        sphere.SetPhiResolution(32)
        sphere.SetRadius(0.8 - 0.1 * i)
        add_actor(renderer, sphere, color, 0.4 if i < 3 else 1.0)
    renderer.ResetCamera()
    return renderer


def compose(colors, alphas, background):
    """Layers front to back over a background, by the definition: C = sum of T_i a_i c_i + T C_background.

    colors: n x 3. alphas: n. background: (r, g, b, a), premultiplied, as the result, an array.
    """
    import numpy

    transmittance = 1.0
    result = numpy.zeros(4)
    for color, alpha in zip(colors, alphas):
        result += transmittance * alpha * numpy.array([*color, 1.0])
        transmittance *= 1.0 - alpha
    return result + transmittance * numpy.asarray(background, dtype=float)


def draw(renderer, size=(120, 100)):
    """What a new window shows of the renderer, as picture.grab()."""
    return draw_and(renderer, size, lambda: None)


def draw_and(renderer, size, look):
    """Renders into a new window and calls look() while it is there; the picture as picture.grab()."""
    from vtkoit import picture
    from vtkoit.windows import make_window

    window = make_window(renderer, size)
    window.Render()
    pixels = picture.grab(window)
    look()
    window.RemoveRenderer(renderer)
    window.Finalize()
    return pixels
