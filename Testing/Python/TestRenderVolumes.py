# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkoit render --volume and vtkoit compare --volume: image data as volumes, alone and with surfaces inside."""

import json
import math
import os
import unittest

import numpy
import Support
from TestErrors import run_here
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkoit import colors, volumes

SIZE = (30, 24)
ABOVE = ["--camera", "z", "--up", "y", "--parallel", "--samples", "0"]
# Cubes of 10 in each direction: half of the light gets through a way of 4.
FUNCTION = ["--opacity-function", "0:0.5", "255:0.5", "--opacity-length", "4", "--range", "0,255"]


def write_image(path, values, spacing=(1, 1, 1), name="density"):
    image = vtkImageData()
    image.SetDimensions(*values.shape[::-1])
    image.SetSpacing(*spacing)
    array = numpy_to_vtk(values.ravel(), deep=True)
    array.SetName(name)
    image.GetPointData().SetScalars(array)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def write_plane(path, z):
    """A square over all of the cube, at a height."""
    plane = vtkPlaneSource()
    plane.SetOrigin(0, 0, z)
    plane.SetPoint1(10, 0, z)
    plane.SetPoint2(0, 10, z)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputConnection(plane.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


class VolumeTest(Support.FolderTest):
    def setUp(self):
        super().setUp()
        write_image(self.path("cube.vti"), numpy.full((11, 11, 11), 100, numpy.uint8))

    def render(self, *arguments, size=SIZE):
        """The picture, and what was printed."""
        done = run_here(["render", *arguments, "--size", "%dx%d" % size, "-o", "out.png"], self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return Support.read_picture(self.path("out.png")), done.stdout

    def fails(self, *arguments, text):
        done = run_here(["render", *arguments, "-o", "out.png"], self.folder)
        self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (1, "", 1), done.stderr)
        self.assertNotIn("internal error", done.stderr)
        self.assertRegex(done.stderr, "^vtkoit render: .*" + text)
        self.assertFalse(os.path.exists(self.path("out.png")))


class TestPictures(VolumeTest):
    def test_beer_and_lambert(self):
        """A cube of constant density over white: 1/2 of the light gets through each 4 of its 10."""
        pixels, text = self.render("cube.vti", "--volume", *FUNCTION, *ABOVE)
        through = 0.5 ** (10 / 4)
        color = numpy.array(colors.sequential_color(100 / 255))
        numpy.testing.assert_allclose(pixels[12, 15], 255 * (through + (1 - through) * color), atol=1.5)
        numpy.testing.assert_array_equal(pixels[0, 0], [255, 255, 255])
        self.assertIn("1 volume, 0 surfaces, 0 polygons, no translucent surface", text)
        self.assertNotIn("opacity-function", text)  # nothing was chosen

    def test_transparent_background(self):
        pixels, _ = self.render("cube.vti", "--volume", *FUNCTION, *ABOVE, "--background", "transparent")
        self.assertAlmostEqual(int(pixels[12, 15, 3]), 255 * (1 - 0.5 ** 2.5), delta=1.5)
        self.assertEqual(pixels[0, 0, 3], 0)

    def test_a_surface_inside_is_in_its_place(self):
        for z in (2, 7.3):
            write_plane(self.path("plane.vtp"), z)
            for files in (["cube.vti", "--volume", "plane.vtp"], ["plane.vtp", "cube.vti", "--volume"],
                          ["--volume", "plane.vtp", "cube.vti"]):
                pixels, text = self.render(*files, *FUNCTION, *ABOVE, "--color", "red", "--opacity", "0.6")
                self.assertIn("1 volume, 1 surface,", text)
                first, second = 0.5 ** ((10 - z) / 4), 0.5 ** (z / 4)
                color = numpy.array(colors.sequential_color(100 / 255))
                # The plane is lit: its colour is known as far as that it has no green and no blue.
                rest = (1 - first) * color + first * 0.4 * ((1 - second) * color + second)
                numpy.testing.assert_allclose(pixels[12, 15, 1:], 255 * rest[1:], atol=1.5, err_msg="%s" % files)

    def test_isosurface_and_volume_of_one_file(self):
        Support.write_volume(self.path("a.vti"))
        both, text = self.render("a.vti", "--volume", "--isosurface", "150", size=(80, 60))
        self.assertRegex(text, r"a.vti: a volume with the opacities [\d.:e -]+ for every [\d.]+ of length, chosen by "
                               r"Otsu's method \(RTData ranges from [\d.]+ to [\d.]+\); --opacity-function sets them")
        self.assertIn("1 volume, 1 surface,", text)
        surface, _ = self.render("a.vti", "--isosurface", "150", size=(80, 60))
        volume, text = self.render("a.vti", "--volume", size=(80, 60))
        self.assertIn("1 volume, 0 surfaces,", text)
        for one in (surface, volume):
            self.assertGreater(numpy.abs(both.astype(int) - one).max(), 20)

    def test_labels(self):
        Support.write_labels(self.path("a.mha"))
        _, text = self.render("a.mha", "--volume", "--labels", "7")
        self.assertIn("all labels but 0 alike", text)
        self.assertIn("1 volume, 1 surface,", text)

    def test_other_arrays_and_numbers(self):
        values = numpy.linspace(-5, 5, 11 ** 3).reshape(11, 11, 11).astype(numpy.float32)
        values[3, 4, 5] = math.nan
        values[5, 5, 5] = math.inf
        write_image(self.path("a.vti"), values)
        _, text = self.render("a.vti", "--volume", "--contour", "density", "--opacity-function", "-5:0", "5:0.2")
        self.assertIn("a.vti: 2 values of density are not finite, drawn as the smallest one", text)
        vectors = numpy.stack(3 * [numpy.nan_to_num(values, posinf=0.0)], axis=-1)
        image = vtkImageData()
        image.SetDimensions(11, 11, 11)
        array = numpy_to_vtk(vectors.reshape(-1, 3), deep=True)
        array.SetName("speed")
        image.GetPointData().SetVectors(array)
        writer = vtkXMLImageDataWriter()
        writer.SetInputData(image)
        writer.SetFileName(self.path("b.vti"))
        writer.Write()
        _, text = self.render("b.vti", "--volume")
        self.assertIn("magnitude of speed", text)

    def test_volumes_that_overlap_are_told(self):
        """Their order is known to nobody: one line, and the picture."""
        write_image(self.path("other.vti"), numpy.full((11, 11, 11), 100, numpy.uint8), (1.1, 1.1, 1.1))
        write_plane(self.path("plane.vtp"), 4)
        done = run_here(["render", "cube.vti", "other.vti", "plane.vtp", "--volume", *FUNCTION, *ABOVE, "--opacity", "0.5",
                         "--size", "20x20", "-o", "out.png"], self.folder)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^vtkoit render: warning: .*overlap.*\n$")
        self.assertIn("2 volumes, 1 surface,", done.stdout)

    def test_shade(self):
        Support.write_volume(self.path("a.vti"))
        unlit, _ = self.render("a.vti", "--volume")
        lit, _ = self.render("a.vti", "--volume", "--shade")
        self.assertGreater(numpy.abs(lit.astype(int) - unlit).max(), 5)

    def test_compare(self):
        write_plane(self.path("plane.vtp"), 4)
        done = run_here(["compare", "cube.vti", "plane.vtp", "--volume", *FUNCTION, "--camera", "z", "--up", "y",
                         "--parallel", "--color", "red", "--opacity", "0.6", "--size", "24x20",
                         "--methods", "vtk-dual", "auto"], self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"(?m)^cube.vti: 1 volume, 1 surface; .* truth: the picture of abuffer with 8 times the "
                                      r"samples, vtk-dual with as many differs by at most [\d.]+ steps$")
        with open(self.path("comparison/compare.json"), encoding="utf-8") as file:
            results = {result["method"]: result for result in json.load(file)["results"]}
        self.assertGreater(results["blend"]["max"], 10.0)
        self.assertLessEqual(results["auto"]["max"], 1.0)
        self.assertLessEqual(results["auto"]["alpha_max"], 1.0)
        self.assertTrue(results["auto"]["exact"])


class TestRefusals(VolumeTest):
    def test_what_is_no_image_data(self):
        Support.write_sphere(self.path("a.vtp"))
        self.fails("a.vtp", "--volume", text="--volume is for image data .*; a.vtp holds a vtkPolyData")
        write_image(self.path("flat.vti"), numpy.zeros((1, 5, 5), numpy.uint8))
        self.fails("flat.vti", "--volume", text="--volume is for image data with samples in three dimensions")
        self.fails("cube.vti", "--volume", "--contour", "none", text="has no array none; it has: density")

    def test_opacity_function(self):
        for given, text in ((["5"], "'5' is not VALUE:OPACITY; give VALUE:OPACITY in ascending order"),
                            (["5:0", "x:1"], "'x:1' is not VALUE:OPACITY"), (["1:2:3"], "'1:2:3' is not"),
                            (["5:0", "9:1.5"], "9:1.5: give VALUE:OPACITY"), (["5:-0.1"], "5:-0.1: give"),
                            (["5:nan"], "5:nan: give"), (["inf:1"], "inf:1: give"), (["5:0,5:1"], "5:1: comes after 5"),
                            (["9:0", "5:1"], "5:1: comes after 9")):
            self.fails("cube.vti", "--volume", "--opacity-function", *given, text="--opacity-function.*" + text)
        for option in (["--opacity-function", "5:0"], ["--opacity-length", "2"], ["--shade"]):
            self.fails("cube.vti", *option, text="%s is about volumes; give --volume, too" % option[0])
        for length in ("0", "-1", "x", "nan"):
            self.fails("cube.vti", "--volume", "--opacity-length", length, text="--opacity-length: ")

    def test_nothing_to_see(self):
        write_image(self.path("even.vti"), numpy.full((5, 5, 5), 0.5, numpy.float32))
        self.fails("even.vti", "--volume", text="all values of density are 0.5; give --opacity-function")
        self.fails("cube.vti", "--volume", "--opacity-function", "0:0", "50:0", "101:0",
                   text="nothing of it would be seen: all opacities are 0 where density is, from 100 to 100")
        write_image(self.path("nan.vti"), numpy.full((5, 5, 5), math.nan, numpy.float32))
        self.fails("nan.vti", "--volume", text="the array density holds no finite number")


class TestParts(unittest.TestCase):
    def test_visible_range(self):
        image = vtkImageData()
        image.SetDimensions(11, 1, 1)
        image.GetPointData().SetScalars(numpy_to_vtk(numpy.arange(11.0), deep=True))
        for points, expected in (([(3, 0), (6, 1)], (3, 10)), ([(3, 1), (6, 0)], (0, 6)), ([(-9, 0), (20, 1)], (0, 10)),
                                 ([(2, 0), (4, 1), (5, 0)], (2, 5)), ([(20, 0), (30, 1)], None), ([(5, 0)], None)):
            volume = volumes.Volume("", image, points, 1.0, False, False)
            self.assertEqual(volumes.visible_range(volume), expected, points)

    def test_function_is_what_is_said(self):
        points = volumes.parse_opacities(["1:0,2:0.5", "4:1"])
        self.assertEqual(points, [(1.0, 0.0), (2.0, 0.5), (4.0, 1.0)])
        function = vtkPiecewiseFunction()
        for point in points:
            function.AddPoint(*point)
        for value, opacity in ((0, 0), (1.5, 0.25), (3, 0.75), (9, 1)):
            self.assertAlmostEqual(function.GetValue(value), opacity)


if __name__ == "__main__":
    unittest.main()
