# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes between translucent surfaces against VolumeMarcher.py, which computes the right answer on the CPU.

A mapper takes samples, the right answer is an integral: what a volume alone is off by depends on the distance between
samples. With surfaces a picture may be off by one step of 255 more than that.
"""

import itertools
import unittest

import numpy
import VolumeMarcher
import VolumeScene
from VolumeMarcher import Ball, Camera, Cloud, Square

SIZE = (40, 36)
STEP = 1.0 + 1e-6  # of 255
WAYS = ("auto", "abuffer", "chain-auto")

PARALLEL = Camera((0, 0, 10), (0, 0, 0), (0, 1, 0), True, 1.0, 30.0, 1.0, 20.0)
PERSPECTIVE = Camera((3, 2, 9), (0, 0, 0), (0, 1, 0), False, 1.0, 12.0, 1.0, 20.0)
INSIDE = Camera((0.1, 0.15, 0.35), (0, 0, -1), (0, 1, 0), False, 1.0, 50.0, 0.01, 20.0)

# A slab from z = -0.6 to z = 0.6, through which 1 - 0.7 of the light gets on a way of 1: Beer and Lambert.
HALF = 0.6
SLAB = Cloud(numpy.full((9, 9, 9), 100, numpy.uint8), (-1.2, -1.2, -HALF), (0.3, 0.3, 0.15),
             [(0, 0.7), (255, 0.7)], [(0, 1.0, 0.6, 0.2), (255, 1.0, 0.6, 0.2)], 1.0)
DISTANCE = HALF / 12  # a whole number of samples on a parallel ray: the slab alone is right
STEPS = (HALF / 6 - 1e-4, DISTANCE, HALF / 30)

COLORS = [(0, 1, 0), (0, 0, 1), (1, 0, 0), (1, 1, 1), (0, 1, 1), (1, 0, 1)]
OPACITIES = [0.4, 0.5, 0.6, 0.3, 0.2, 0.7]


def _smooth_cloud():
    """A field of bumps, of which some are nearly opaque and others are nothing."""
    axis = numpy.linspace(-1, 1, 25)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    values = 128 + 100 * numpy.sin(3 * x + 1) * numpy.cos(2.5 * y) * numpy.sin(2 * z + 0.5)
    return Cloud(values.astype(numpy.float32), (-1, -1, -1), (1 / 12,) * 3, [(28, 0.0), (128, 0.1), (228, 0.9)],
                 [(28, 0.1, 0.2, 0.9), (128, 0.9, 0.9, 0.2), (228, 0.9, 0.1, 0.1)], 1.0)


SMOOTH = _smooth_cloud()


def planes(heights):
    """Squares across the z axis, list of Square."""
    return [Square((0, 0, z), (0, 0, 1), 0.9, COLORS[i % 6], OPACITIES[i % 6]) for i, z in enumerate(heights)]


def mixed_surfaces():
    """Squares in all directions and a ball, which cross each other and stand out of the smooth cloud."""
    tilted = numpy.array([0.48, 0.36, 0.8])
    return [Square((0, 0, 0.1), tuple(tilted), 0.9, (0, 0, 1), 0.5), Ball((0.2, 0.1, 0), 0.6, (0, 0.8, 0.2), 0.4),
            Square((0, 0.1, 0), (-0.6, 0, 0.8), 1.3, (1, 0, 0), 0.3), Square((0, 0, 1.2), (0, 0, 1), 0.5, (1, 1, 1), 0.4)]


_right = {}


def right_picture(camera, cloud, surfaces, **more):
    """VolumeMarcher.picture() in SIZE, computed once for all ways of drawing."""
    key = (camera, id(cloud), tuple(surfaces), repr(more))
    if key not in _right:
        samples = 1 if cloud is SLAB else 300  # a slab is the same all along a ray
        _right[key] = VolumeMarcher.picture(camera, SIZE, cloud, surfaces, samples=samples, **more)
    return _right[key]


def limit(alone):
    """What a picture may be off by, in steps, where the volume alone is off by so much, float."""
    return STEP if alone <= 0.5 else alone + STEP  # half a step is rounding


def error(pixels, right):
    """The largest difference in steps of 255 of a picture to (pixels, certain) of VolumeMarcher.picture()."""
    expected, certain = right
    return float((numpy.abs(pixels - 255.0 * expected) * certain[..., None]).max())


class VolumeTest(unittest.TestCase):
    """A test with a window for each way of drawing, made when it is first asked for."""

    @classmethod
    def setUpClass(cls):
        cls.windows = {}

    @classmethod
    def tearDownClass(cls):
        for window in cls.windows.values():
            window.close()

    def draw(self, way, camera, cloud, surfaces, distance=DISTANCE, background=(0, 0, 0, 1), opaque=()):
        """The picture, height x width x 4, in float. A way of vtkOIT's must say that it is right."""
        if way not in self.windows:
            self.windows[way] = VolumeScene.Window(way, SIZE)
        window = self.windows[way]
        props = [] if cloud is None else [VolumeScene.volume_of(cloud, distance)]
        props += [VolumeScene.actor_of(surface) for surface in surfaces]
        props += [VolumeScene.actor_of(surface, opaque=True) for surface in opaque]
        pixels = window.draw(camera, props, background[:3], background[3])
        if window.instance is not None:  # up to the default TransmittanceThreshold, half a step
            self.assertLessEqual(window.instance.GetErrorBound(), 1 / 512, way)
        return pixels

    def check(self, way, camera, cloud, surfaces, distance=DISTANCE, background=(0, 0, 0, 1)):
        """Compares a picture with the right one."""
        alone, off = [
            error(self.draw(way, camera, cloud, chosen, distance, background),
                  right_picture(camera, cloud, chosen, background=background)) for chosen in ([], surfaces)]
        certain = right_picture(camera, cloud, surfaces, background=background)[1]
        self.assertGreater(certain.mean(), 0.2)  # there is something to compare
        self.assertLessEqual(off, limit(alone), "%s: alone %.2f" % (way, alone))


class TestSlabs(VolumeTest):
    # In front of the slab, on its faces, inside it on a sample and between two, and behind it.
    HEIGHTS = (0.8, HALF, 0.2, 0.2 + 0.31 * DISTANCE, 0.0, -0.3, -HALF, -0.9)

    def test_slab_alone_is_right(self):
        for distance in STEPS:
            pixels = self.draw("auto", PARALLEL, SLAB, [], distance)
            self.assertLessEqual(error(pixels, right_picture(PARALLEL, SLAB, [])), 0.5)

    def test_marcher_knows_beer_and_lambert(self):
        pixels, _ = VolumeMarcher.picture(PARALLEL, SIZE, SLAB, planes([0.2]), (0, 0, 0, 0), samples=7)
        first, second = 0.3 ** (HALF - 0.2), 0.3 ** (HALF + 0.2)
        through = first * (1 - OPACITIES[0]) * second
        expected = (1 - first) * numpy.array([1, 0.6, 0.2]) + first * OPACITIES[0] * numpy.array(COLORS[0]) \
            + first * (1 - OPACITIES[0]) * (1 - second) * numpy.array([1, 0.6, 0.2])
        numpy.testing.assert_allclose(pixels[18, 20], [*expected, 1 - through], atol=1e-12)

    def test_one_plane_at_any_depth(self):
        for way, camera, height in itertools.product(WAYS, (PARALLEL, PERSPECTIVE), self.HEIGHTS):
            with self.subTest("%s, %s, z = %g" % (way, "parallel" if camera.parallel else "perspective", height)):
                # A ray in perspective does not cross a whole number of samples.
                self.check(way, camera, SLAB, planes([height]), DISTANCE if camera.parallel else DISTANCE / 8)

    def test_many_planes(self):
        for way, camera, distance in itertools.product(WAYS, (PARALLEL, PERSPECTIVE), STEPS):
            for heights in (self.HEIGHTS, tuple(numpy.linspace(0.7, -0.7, 16))):
                with self.subTest("%s, parallel %d, distance %g" % (way, camera.parallel, distance)):
                    self.check(way, camera, SLAB, planes(heights), distance)

    def test_transparent_background(self):
        for way in WAYS:
            with self.subTest(way):
                self.check(way, PARALLEL, SLAB, planes(self.HEIGHTS[::3]), background=(0, 0, 0, 0))

    def test_opaque_surface_inside(self):
        for way, camera in itertools.product(WAYS, (PARALLEL, PERSPECTIVE)):
            with self.subTest(way):
                opaque = Square((0.3, 0, -0.15), (0, 0, 1), 0.5, (0.2, 0.9, 0.4), 1.0)
                surfaces = planes([0.3, -0.4])
                alone, mixed = [
                    error(self.draw(way, camera, SLAB, chosen, opaque=[opaque]),
                          right_picture(camera, SLAB, chosen, opaque=[opaque])) for chosen in ([], surfaces)]
                self.assertLessEqual(mixed, limit(alone), "alone %.2f" % alone)

    def test_scenes_tell_right_from_wrong(self):
        """VTK's default, which draws the volume over everything, fails all that this file allows."""
        for height in (0.8, 0.2, 0.0, -0.3):
            right = right_picture(PARALLEL, SLAB, planes([height]))
            off = error(self.draw(VolumeScene.VTK_DEFAULT, PARALLEL, SLAB, planes([height])), right)
            self.assertGreater(off, 10.0, height)


class TestField(VolumeTest):
    def test_surfaces_in_all_directions(self):
        for way, camera in itertools.product(WAYS, (PARALLEL, PERSPECTIVE)):
            for distance in (0.1, 0.02):
                with self.subTest("%s, parallel %d, distance %g" % (way, camera.parallel, distance)):
                    self.check(way, camera, SMOOTH, mixed_surfaces(), distance)

    def test_camera_inside(self):
        for way in WAYS:
            with self.subTest(way):
                self.check(way, INSIDE, SMOOTH, mixed_surfaces()[:1] + planes([-0.2, -0.5]), 0.02)

    def test_converges_as_the_volume_alone(self):
        """The picture at a sample distance differs from that at an eighth no more than the volume's alone does."""
        for way, camera in itertools.product(("auto", "chain-auto"), (PARALLEL, PERSPECTIVE)):
            for distance in (0.1, 0.04):
                with self.subTest("%s, parallel %d, distance %g" % (way, camera.parallel, distance)):
                    alone, mixed = [
                        numpy.abs(self.draw(way, camera, SMOOTH, surfaces, distance)
                                  - self.draw(way, camera, SMOOTH, surfaces, distance / 8)).max()
                        for surfaces in ([], mixed_surfaces())]
                    self.assertGreater(alone, 0.0)
                    self.assertLessEqual(mixed, alone + STEP)


class TestInvariants(VolumeTest):
    """What must not change a picture."""

    def pictures(self, way, scenes):
        return [self.draw(way, PERSPECTIVE, SMOOTH, surfaces, 0.05) for surfaces in scenes]

    def test_order_of_drawing(self):
        surfaces = mixed_surfaces()
        for way in WAYS:
            first, *others = self.pictures(way, [surfaces, surfaces[::-1], surfaces[2:] + surfaces[:2]])
            for other in others:
                numpy.testing.assert_array_equal(first, other, way)

    def test_splitting_a_layer(self):
        """Two layers of 1 - sqrt(1 - a) in one place are one of a."""
        surfaces = mixed_surfaces()
        halves = [surface._replace(opacity=1 - (1 - surface.opacity) ** 0.5) for surface in surfaces]
        for way in WAYS:
            whole, split = self.pictures(way, [surfaces, halves + halves])
            self.assertLessEqual(numpy.abs(whole - split).max(), STEP, way)

    def test_layers_of_opacity_0(self):
        surfaces = mixed_surfaces()
        nothing = [Square((0, 0, z), (0, 0, 1), 0.9, (1, 1, 0), 0.0) for z in (0.9, 0.31, -0.2, -0.7)]
        for way in WAYS:
            without, with_them, only, alone = self.pictures(way, [surfaces, surfaces + nothing, nothing, []])
            self.assertLessEqual(numpy.abs(without - with_them).max(), STEP, way)
            self.assertLessEqual(numpy.abs(alone - only).max(), STEP, way)


if __name__ == "__main__":
    unittest.main()
