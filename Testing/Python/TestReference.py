# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The CPU reference: known answers, and agreement with what the A-buffer draws."""

import math
import unittest

import numpy
import Support
import vtkoit
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight
from vtkoit import reference


class TestCompose(unittest.TestCase):
    def test_nothing(self):
        numpy.testing.assert_array_equal(reference.compose([], [], (0.1, 0.2, 0.3, 1)),
                                         [0.1, 0.2, 0.3, 1])

    def test_equal_layers(self):
        for number, alpha in ((1, 0.5), (2, 0.1), (64, 0.1), (1000, 0.001)):
            result = reference.compose([(0.8,) * 3] * number, [alpha] * number, (0.1,) * 3 + (0,))
            left = (1.0 - alpha) ** number
            numpy.testing.assert_allclose(
                result, [0.8 * (1 - left) + 0.1 * left] * 3 + [1 - left], rtol=1e-12)

    def test_opaque_hides(self):
        result = reference.compose([(1, 0, 0), (0, 1, 0), (0, 0, 1)], [0.5, 1.0, 0.7], (1, 1, 1, 1))
        numpy.testing.assert_allclose(result, [0.5, 0.5, 0, 1])


class TestComposite(unittest.TestCase):
    def test_equals_compose_in_any_order(self):
        random = numpy.random.default_rng(3)
        number, shape = 500, (5, 4)
        fragments = reference.Fragments(
            random.integers(0, 20, number), random.random(number), random.random((number, 3)),
            random.random(number))
        background = (0.2, 0.3, 0.4, 0.5)
        pixels, layers, tied = reference.composite(fragments, shape, background)
        self.assertEqual(layers.sum(), number)
        self.assertFalse(tied.all())
        for pixel in range(20):
            mine = numpy.nonzero(fragments.pixel == pixel)[0]
            mine = mine[numpy.argsort(fragments.depth[mine])]
            expected = reference.compose(fragments.color[mine], fragments.alpha[mine], background)
            numpy.testing.assert_allclose(pixels[pixel // 4, pixel % 4], expected, rtol=1e-12)

    def test_ties_of_unlike_fragments(self):
        depth = numpy.array([0.5, 0.5, 0.25, 0.25])
        color = numpy.array([(1, 0, 0), (0, 1, 0), (1, 1, 1), (1, 1, 1)], dtype=float)
        fragments = reference.Fragments(numpy.array([0, 0, 1, 1]), depth, color, numpy.full(4, 0.5))
        _, _, tied = reference.composite(fragments, (1, 3), (0, 0, 0, 0))
        numpy.testing.assert_array_equal(tied, [[True, False, False]])


class TestRender(unittest.TestCase):
    def test_stack_of_quads(self):
        renderer = Support.quad_renderer((0.2, 0.2, 0.2))
        Support.add_quad(renderer, 0.5, (1, 0, 0), 0.5)
        Support.add_quad(renderer, 0.0, (0, 1, 0), 0.25)
        result = reference.render(renderer, (40, 30))
        expected = reference.compose([(1, 0, 0), (0, 1, 0)], [0.5, 0.25], (0.2, 0.2, 0.2, 1))
        self.assertTrue((result.layers[:, 6:34] == 2).all())
        numpy.testing.assert_allclose(result.pixels[15, 20], expected, rtol=1e-12)

    def test_each_pixel_of_shared_edges_is_covered_once(self):
        renderer = Support.quad_renderer()
        # The diagonal of the square runs through the centres of pixels.
        Support.add_quad(renderer, 0.0, (1, 1, 1), 0.5)
        renderer.GetActiveCamera().SetParallelScale(1.0)
        self.assertTrue((reference.render(renderer, (64, 64)).layers == 1).all())

    def test_sphere_by_its_formula(self):
        renderer = Support.quad_renderer()
        sphere = vtkSphereSource()
        sphere.SetRadius(0.7)
        sphere.SetThetaResolution(200)
        sphere.SetPhiResolution(200)
        actor = Support.add_actor(renderer, sphere, (1, 0.5, 0.25), 0.6)
        actor.GetProperty().SetAmbient(0.2)
        actor.GetProperty().SetDiffuse(0.8)
        result = reference.render(renderer, (90, 90))
        for row, column in ((45, 45), (30, 50), (60, 20)):
            x, y = ((column + 0.5) / 45 - 1) * 0.9, ((row + 0.5) / 45 - 1) * 0.9
            facing = math.sqrt(0.49 - x * x - y * y) / 0.7
            shade = (0.2 + 0.8 * facing) * numpy.array([1, 0.5, 0.25])
            expected = reference.compose([shade, shade], [0.6, 0.6], (0, 0, 0, 1))
            self.assertEqual(result.layers[row, column], 2)
            numpy.testing.assert_allclose(result.pixels[row, column], expected, atol=1e-3)

    def test_agrees_with_the_abuffer(self):
        for parallel in (False, True):
            renderer = Support.sphere_renderer()
            light = vtkLight()
            light.SetLightTypeToHeadlight()
            renderer.AddLight(light)
            renderer.SetBackgroundAlpha(1.0)
            renderer.GetActiveCamera().SetParallelProjection(parallel)
            renderer.ResetCamera()
            truth = reference.render(renderer, (160, 120))
            self.assertGreater(truth.certain.mean(), 0.98)
            vtkoit.install(renderer)
            largest, mean = reference.difference(Support.draw(renderer, (160, 120)), truth)
            # Rounding to 8 bits is half a unit; the rest is the half-float colours.
            self.assertLess(largest, 1.0)
            self.assertLess(mean, 0.5)

    def test_difference(self):
        truth = reference.Reference(numpy.zeros((2, 2, 4)), numpy.zeros((2, 2)),
                                    numpy.array([[True, True], [False, True]]))
        pixels = numpy.zeros((2, 2, 4), dtype=numpy.uint8)
        pixels[0, 0] = [3, 0, 0, 0]
        pixels[1, 0] = 200
        self.assertEqual(reference.difference(pixels, truth), (3.0, 0.25))


if __name__ == "__main__":
    unittest.main()
