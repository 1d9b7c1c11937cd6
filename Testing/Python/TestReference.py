# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The right picture: known answers, and agreement of the A-buffer's fragments with an independent
rasterisation."""

import math
import unittest

import numpy
import Rasterizer
import Support
import vtkoit
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight
from vtkoit import reference

BACKGROUND = (0.2, 0.4, 0.6, 0.5)


def background(shape):
    return numpy.broadcast_to(numpy.array(BACKGROUND), (*shape, 4))


class TestComposite(unittest.TestCase):
    def compose(self, fragments, shape=(1, 1)):
        return reference.composite(numpy.array(fragments, dtype=numpy.float32), shape, background(shape))

    def test_nothing(self):
        pixels, layers = self.compose(numpy.zeros((0, 7)), (2, 3))
        numpy.testing.assert_array_equal(pixels, background((2, 3)))
        self.assertEqual(layers.sum(), 0)

    def test_equal_layers(self):
        for number, alpha in ((1, 0.5), (7, 0.25), (1000, 1 / 1024)):
            depth = numpy.arange(1, number + 1) / 2048
            fragments = [(0, 0, d, 0.75, 0.5, 0.25, alpha) for d in depth]
            pixels, layers = self.compose(fragments)
            left = (1.0 - alpha) ** number
            expected = (1 - left) * numpy.array([0.75, 0.5, 0.25, 1]) + left * numpy.array(BACKGROUND)
            numpy.testing.assert_allclose(pixels[0, 0], expected, rtol=1e-12)
            self.assertEqual(layers[0, 0], number)

    def test_place_and_order(self):
        # Rows of fragments count from below, rows of pixels from the top.
        fragments = [(2, 0, 0.75, 0, 1, 0, 0.5), (2, 0, 0.5, 1, 0, 0, 0.25), (0, 1, 0.5, 0, 0, 1, 1)]
        pixels, layers = self.compose(fragments, (2, 3))
        expected = Support.compose([(1, 0, 0), (0, 1, 0)], [0.25, 0.5], BACKGROUND)
        numpy.testing.assert_allclose(pixels[1, 2], expected, rtol=1e-12)
        numpy.testing.assert_allclose(pixels[0, 0], [0, 0, 1, 1])
        numpy.testing.assert_array_equal(layers, [[1, 0, 0], [0, 0, 2]])
        numpy.testing.assert_array_equal(pixels[0, 1], BACKGROUND)

    def test_coincident_fragments(self):
        # 1 - (1 - 1/2) (1 - 1/4) = 5/8; colour (1/2 red + 1/4 green) / (3/4).
        group = [(0, 0, 0.5, 1, 0, 0, 0.5), (0, 0, 0.5, 0, 1, 0, 0.25)]
        pixels, layers = self.compose(group)
        expected = Support.compose([(2 / 3, 1 / 3, 0)], [0.625], BACKGROUND)
        numpy.testing.assert_allclose(pixels[0, 0], expected, rtol=1e-12)
        self.assertEqual(layers[0, 0], 2)
        apart = [group[0], (0, 0, numpy.nextafter(numpy.float32(0.5), numpy.float32(1)), 0, 1, 0, 0.25)]
        pixels, _ = self.compose(apart)
        expected = Support.compose([(1, 0, 0), (0, 1, 0)], [0.5, 0.25], BACKGROUND)
        numpy.testing.assert_allclose(pixels[0, 0], expected, rtol=1e-12)

    def test_same_for_every_order(self):
        random = numpy.random.default_rng(8)
        fragments = numpy.c_[random.integers(0, 4, 200), random.integers(0, 3, 200),
                             random.integers(1, 9, 200) / 16, random.random((200, 4))]
        first, layers = self.compose(fragments, (3, 4))
        self.assertEqual(layers.sum(), 200)
        for _ in range(3):
            again, _ = self.compose(random.permutation(fragments), (3, 4))
            numpy.testing.assert_allclose(again, first, rtol=1e-12)


    def test_many_fragments_by_the_definition(self):
        random = numpy.random.default_rng(3)
        fragments = numpy.c_[random.integers(0, 4, 500), random.integers(0, 5, 500),
                             random.random((500, 5))].astype(numpy.float32)
        pixels, _ = self.compose(fragments, (5, 4))
        for row in range(5):
            for column in range(4):
                mine = fragments[(fragments[:, 0] == column) & (fragments[:, 1] == 4 - row)].astype(float)
                mine = mine[numpy.argsort(mine[:, 2])]
                expected = Support.compose(mine[:, 3:6], mine[:, 6], BACKGROUND)
                numpy.testing.assert_allclose(pixels[row, column], expected, rtol=1e-12)


class TestFragments(unittest.TestCase):
    def test_quads_by_the_abuffer(self):
        renderer = Support.quad_renderer()
        Support.add_quad(renderer, 0.5, (1, 0, 0), 0.5)
        Support.add_quad(renderer, 0.0, (0, 1, 0), 0.25)
        Support.add_quad(renderer, 0.0, (0, 0, 1), 0.25)
        for precision in ("half", "float"):
            instance = vtkoit.install(renderer, "abuffer", FragmentPrecision=precision)
            Support.draw_and(renderer, (24, 20), lambda: self.check(instance))

    def check(self, instance):
        fragments = reference.fragments_of(instance)
        self.assertEqual(len(fragments), instance.GetNumberOfFragments())
        pixels, layers = reference.composite(fragments, (20, 24), numpy.zeros((20, 24, 4)))
        self.assertEqual(layers[10, 12], 3)
        # Green and blue lie in one plane: 1 - (3/4)^2 of their mean.
        expected = Support.compose([(1, 0, 0), (0, 0.5, 0.5)], [0.5, 0.4375], (0, 0, 0, 0))
        numpy.testing.assert_allclose(pixels[10, 12], expected, atol=1e-6)

    def test_nothing_captured(self):
        self.assertEqual(reference.fragments_of(vtkoit.create("abuffer")).shape, (0, 7))


def rasterized(renderer, size, color=(0, 0, 0)):
    """(pixels, layers, certain) of a renderer over an opaque background, without OpenGL."""
    fragments, certain = Rasterizer.rasterize(renderer, size)
    behind = numpy.broadcast_to(numpy.array([*color, 1.0]), (size[1], size[0], 4))
    return (*reference.composite(fragments, (size[1], size[0]), behind), certain)


class TestRasterizer(unittest.TestCase):
    def test_stack_of_quads(self):
        renderer = Support.quad_renderer()
        Support.add_quad(renderer, 0.5, (1, 0, 0), 0.5)
        Support.add_quad(renderer, 0.0, (0, 1, 0), 0.25)
        pixels, layers, _ = rasterized(renderer, (40, 30), (0.2, 0.2, 0.2))
        expected = Support.compose([(1, 0, 0), (0, 1, 0)], [0.5, 0.25], (0.2, 0.2, 0.2, 1))
        self.assertTrue((layers[:, 6:34] == 2).all())
        numpy.testing.assert_allclose(pixels[15, 20], expected, rtol=1e-12)

    def test_ties_of_unlike_fragments(self):
        renderer = Support.quad_renderer()
        for color in ((1, 0, 0), (0, 1, 0)):
            Support.add_quad(renderer, 0.0, color, 0.5)
        _, layers, certain = rasterized(renderer, (40, 30))
        self.assertFalse(certain[layers == 2].any())
        renderer = Support.quad_renderer()
        for z in (0.0, 0.0, 0.5):
            Support.add_quad(renderer, z, (1, 1, 1), 0.5)
        _, layers, certain = rasterized(renderer, (40, 30))
        self.assertGreater(certain[layers == 3].mean(), 0.9)

    def test_each_pixel_of_shared_edges_is_covered_once(self):
        renderer = Support.quad_renderer()
        # The diagonal of the square runs through the centres of pixels.
        Support.add_quad(renderer, 0.0, (1, 1, 1), 0.5)
        renderer.GetActiveCamera().SetParallelScale(1.0)
        self.assertTrue((rasterized(renderer, (64, 64))[1] == 1).all())

    def test_sphere_by_its_formula(self):
        renderer = Support.quad_renderer()
        sphere = vtkSphereSource()
        sphere.SetRadius(0.7)
        sphere.SetThetaResolution(200)
        sphere.SetPhiResolution(200)
        actor = Support.add_actor(renderer, sphere, (1, 0.5, 0.25), 0.6)
        actor.GetProperty().SetAmbient(0.2)
        actor.GetProperty().SetDiffuse(0.8)
        pixels, layers, _ = rasterized(renderer, (90, 90))
        for row, column in ((45, 45), (30, 50), (60, 20)):
            x, y = ((column + 0.5) / 45 - 1) * 0.9, ((row + 0.5) / 45 - 1) * 0.9
            facing = math.sqrt(0.49 - x * x - y * y) / 0.7
            shade = (0.2 + 0.8 * facing) * numpy.array([1, 0.5, 0.25])
            expected = Support.compose([shade, shade], [0.6, 0.6], (0, 0, 0, 1))
            self.assertEqual(layers[row, column], 2)
            numpy.testing.assert_allclose(pixels[row, column], expected, atol=1e-3)

    def test_agrees_with_the_picture(self):
        for parallel in (False, True):
            renderer = Support.sphere_renderer()
            light = vtkLight()
            light.SetLightTypeToHeadlight()
            renderer.AddLight(light)
            renderer.SetBackgroundAlpha(1.0)
            renderer.GetActiveCamera().SetParallelProjection(parallel)
            renderer.ResetCamera()
            right, _, certain = rasterized(renderer, (160, 120), renderer.GetBackground())
            self.assertGreater(certain.mean(), 0.98)
            vtkoit.install(renderer)
            drawn = Support.draw(renderer, (160, 120))
            difference = numpy.abs(drawn - 255.0 * numpy.clip(right, 0.0, 1.0))[certain]
            # Rounding to 8 bits is half a unit; the rest is the half-float colours.
            self.assertLess(difference.max(), 1.0)
            self.assertLess(difference.mean(), 0.5)


if __name__ == "__main__":
    unittest.main()
