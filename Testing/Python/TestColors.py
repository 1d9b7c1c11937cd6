# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colours, colour maps, cameras, isovalues and labels: the parts of the command line that compute."""

import unittest

import numpy
import Support
from vtkoit import camera, colors, otsu
from vtkoit.errors import Captured, Error


class TestColors(unittest.TestCase):
    def test_parse(self):
        self.assertEqual(colors.parse_color("#ff0080"), (1.0, 0.0, 128 / 255.0))
        self.assertEqual(colors.parse_color("0,0.5,1"), (0.0, 0.5, 1.0))
        self.assertEqual(colors.parse_color("white"), (1.0, 1.0, 1.0))
        self.assertEqual(colors.parse_color("SteelBlue"), colors.parse_color("steel_blue"))

    def test_maps_end_where_they_should(self):
        for name in colors.COLORMAPS:
            function = colors.transfer_function(name, -2.0, 3.0)
            backwards = colors.transfer_function(name + "-r", -2.0, 3.0)
            numpy.testing.assert_allclose(function.GetColor(-2.0), backwards.GetColor(3.0),
                                       atol=1e-3)
            self.assertEqual(tuple(function.GetRange()), (-2.0, 3.0))

    def test_palette_has_no_two_alike(self):
        palette = [colors.palette_color(i) for i in range(48)]
        self.assertEqual(len(set(palette)), 48)
        self.assertTrue(all(0 <= c <= 1 for color in palette for c in color))


class TestCamera(unittest.TestCase):
    def test_the_box_fills_the_picture(self):
        for parallel in (False, True):
            for spec in ("iso", "x", "-z", (30.0, 60.0), (1.0, 1.0, 1.0)):
                renderer = Support.sphere_renderer()
                camera.place(renderer, spec, parallel=parallel, aspect=1.5)
                matrix = renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(1.5, -1, 1)
                bounds = renderer.ComputeVisiblePropBounds()
                corners = [camera._project(matrix, bounds[i], bounds[2 + j], bounds[4 + k])
                           for i in (0, 1) for j in (0, 1) for k in (0, 1)]
                largest = numpy.abs(numpy.array(corners)[:, :2]).max()
                self.assertAlmostEqual(largest, 0.95, delta=0.02)

    def test_direction_and_up(self):
        renderer = Support.sphere_renderer()
        camera.place(renderer, (90.0, 0.0), up=(0, 0, 1))
        numpy.testing.assert_allclose(
            renderer.GetActiveCamera().GetDirectionOfProjection(), (0, -1, 0), atol=1e-6)
        camera.place(renderer, "z", up=(0, 0, 1))
        numpy.testing.assert_allclose(
            renderer.GetActiveCamera().GetDirectionOfProjection(), (0, 0, -1), atol=1e-6)
        numpy.testing.assert_allclose(renderer.GetActiveCamera().GetViewUp(), (0, 1, 0))

    def test_refusals(self):
        for text in ("", "w", "1", "1,2,3,4", "nan,1,2"):
            with self.assertRaises(Error):
                camera.parse(text)


class TestOtsu(unittest.TestCase):
    def test_separates_three_classes(self):
        random = numpy.random.default_rng(1)
        values = numpy.concatenate([random.normal(center, 3.0, 5000) for center in (0, 100, 180)])
        low, high = otsu.thresholds(values)
        self.assertTrue(15 < low < 85 and 115 < high < 165, (low, high))

    def test_two_values_and_one(self):
        self.assertTrue(0 < otsu.thresholds([0, 0, 0, 10, 10], number=1)[0] <= 10)
        self.assertEqual(otsu.thresholds([4, 4, 4]), [])
        self.assertEqual(otsu.thresholds([]), [])
        self.assertEqual(otsu.thresholds([float("nan"), 1.0]), [])


class TestMessages(unittest.TestCase):
    def test_vtk_errors_become_one_line(self):
        captured = Captured()
        captured.text = (
            "\x1b[0m\x1b[31m2026-11-23 15:37:34.394 (   0.421s) [        CFC06040]"
            "vtkXMLStructuredDataRea:342    ERR| vtkXMLImageDataReader (0xa34e9a0): Error reading "
            "extent.\x1b[0m\n"
            "ERROR: In vtkXMLStructuredDataReader.cxx, line 342\n"
            "vtkXMLImageDataReader (0xa34e9a0): Error reading extent.\n\n"
            "Warning: In vtkX.cxx, line 3\nvtkX (0x1): careful\n\nlibrary: hm\n")
        self.assertEqual(captured.lines(), ["Error reading extent.", "careful", "library: hm"])
        self.assertEqual(captured.errors(), "Error reading extent")


if __name__ == "__main__":
    unittest.main()
