# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The laboratory's parts: the truth, the errors, the frontier, timing, scenes, methods, results on disk."""

import json
import os
import unittest
from unittest import mock

import numpy
import Support
import VolumeMarcher
import vtkoit
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkoit import colors
from vtkoit.bench import (
    accuracy,
    catalogue,
    clouds,
    contenders,
    families,
    gpu,
    measure,
    record,
    scene,
    stage,
    tables,
    truth,
)
from vtkoit.bench.store import Store, read_png
from vtkoit.errors import Error
from vtkoit.volumes import visible_range

class TestTruth(unittest.TestCase):
    def test_truth_of_a_scene(self):
        chosen, = catalogue.choose(["hull"])
        found = truth.find(stage.Stage(chosen, (64, 48)))
        self.assertEqual(found.source, "fragments")
        self.assertEqual(found.layers, 4)
        self.assertLess(found.cross_check, 0.51)
        self.assertTrue(0.1 < found.covered.mean() < 0.9)
        numpy.testing.assert_array_equal(found.color[0, 0], scene.BACKGROUND)
        self.assertEqual(found.alpha[0, 0], 0.0)
        # The hull's two spheres have opacities 1/4 and 1/5; between its parts nothing is opaque.
        self.assertAlmostEqual(float(found.alpha[24, 8 + 8]), 1 - (0.75 * 0.8) ** 2, places=5)


class TestErrors(unittest.TestCase):
    def test_made_up_pictures(self):
        right = numpy.full((10, 10, 3), 100 / 255)
        covered = numpy.zeros((10, 10), dtype=bool)
        covered[:, :5] = True
        pixels = numpy.full((10, 10, 3), 100, dtype=numpy.uint8)
        pixels[:, 5:] = 0  # not covered: does not count
        none = accuracy.measure(pixels, right, covered)
        self.assertAlmostEqual(none.max, 0.0)
        self.assertEqual((none.over0, none.over1, none.over8), (0, 0, 0))
        pixels[0, 0] = [101, 100, 100]
        pixels[1, 0] = [100, 97, 100]
        pixels[2, 0] = [100, 100, 120]
        errors = accuracy.measure(pixels, right, covered)
        self.assertAlmostEqual(errors.max, 20.0)
        self.assertAlmostEqual(errors.rmse, ((1 + 9 + 400) / 150) ** 0.5)
        self.assertAlmostEqual(errors.psnr, 20 * numpy.log10(255 / errors.rmse))
        self.assertAlmostEqual(errors.p99, 3 + 0.51 * 17)  # between the two largest of 50
        self.assertAlmostEqual(errors.over0, 6.0)
        self.assertAlmostEqual(errors.over1, 4.0)
        self.assertAlmostEqual(errors.over8, 2.0)

    def test_rounding_is_no_error(self):
        right = numpy.linspace(0, 1, 300).reshape(10, 10, 3)
        pixels = numpy.rint(255 * right).astype(numpy.uint8)
        errors = accuracy.measure(pixels, right, numpy.ones((10, 10), dtype=bool))
        self.assertLessEqual(errors.max, 0.5 + 1e-9)
        self.assertEqual((errors.over0, errors.over1), (0, 0))

    def test_nothing_covered(self):
        errors = accuracy.measure(numpy.zeros((2, 2, 3), numpy.uint8), numpy.ones((2, 2, 3)),
                                  numpy.zeros((2, 2), dtype=bool))
        self.assertEqual(errors, accuracy.Errors(0, 0, None, 0, 0, 0, 0))

    def test_alpha_has_one_channel(self):
        errors = accuracy.measure(numpy.full((2, 2), 255, numpy.uint8), numpy.full((2, 2), 0.8),
                                  numpy.ones((2, 2), dtype=bool))
        self.assertAlmostEqual(errors.max, 51.0)

    def test_frontier(self):
        points = [(5, 1), (1, 9), (2, 9), (3, 4), (4, 5), (9, 0.5), (10, 0.5), (3, 6)]
        self.assertEqual(accuracy.frontier(points), [1, 3, 0, 5])
        self.assertEqual(accuracy.frontier([]), [])


class TestTiming(unittest.TestCase):
    def test_medians_and_ratios(self):
        blend = [(0.010, 0.02), (0.010, 0.02), (0.010, 0.02), (0.050, 0.10)]
        result = measure.timing([(0.03, 0.04), (0.01, 0.06), (0.02, 0.08)], [(0.025, 0.1)], blend)
        self.assertEqual(result["frames"], 3)
        for key, value in (("ms", 20), ("ms_low", 15), ("ms_high", 25), ("cpu_ms", 60),
                           ("still_ms", 25), ("ratio", 2), ("cpu_ratio", 3), ("fps", 50)):
            self.assertAlmostEqual(result[key], value, msg=key)
        # The reference's fourth frame is from a round in which this one did not run.
        self.assertIsNone(measure.timing([(0.02, 0.1)], [], blend)["still_ms"])

    def test_timer_queries(self):
        """llvmpipe has timer queries, of the processor's time, which is known here."""
        chosen, = catalogue.choose(["one-sphere"])
        contender = stage.Stage(chosen, (200, 200)).contender("abuffer")
        contender.render()
        contender.render()
        contender.window.MakeCurrent()
        timer = gpu.Timer()
        self.assertTrue(timer.renderer)
        if timer.is_software():
            self.assertIsNone(contender.timer)
            contender.timer = timer
        for _ in range(3):
            seconds, _ = contender.render()
            self.assertGreater(contender.gpu_seconds, 0.0)
            # A query starts before the clock and ends before the frame is known to be done.
            self.assertLess(contender.gpu_seconds, seconds + 1.0)
        contender.close()

    def test_groups_fit_into_memory(self):
        names = ["a", "b", "blend", "c"]
        self.assertEqual(measure.groups(names, 10, 0, 10 ** 9), [["blend", "a", "b", "c"]])
        each = 1000 * 800
        self.assertEqual(measure.groups(names, 1000, 0, 3 * each), [["blend", "a", "b"], ["blend", "c"]])
        self.assertEqual(len(measure.groups(names, 1000, 0, 1)), 3)
        self.assertEqual(measure.groups(["blend"], 1, 1), [["blend"]])

    def test_ratios_to_vtk_dual(self):
        results = [{"method": "blend", "ratio": 1.0}, {"method": "vtk-dual", "ratio": 20.0},
                   {"method": "x", "ratio": 5.0, "cpu_ratio": None}, {"method": "y"}]
        tables.relate(results)
        self.assertEqual([r["ratio_to_vtk_dual"] for r in results], [0.05, 1.0, 0.25, None])


class TestRecord(unittest.TestCase):
    def test_the_worst_picture_counts(self):
        right = {"source": "fragments", "fragments": 4, "layers": 1, "cross_check": None,
                 "color": numpy.zeros((2, 2, 3)), "covered": numpy.ones((2, 2), dtype=bool)}
        good, bad = numpy.zeros((2, 2, 3), numpy.uint8), numpy.full((2, 2, 3), 7, numpy.uint8)
        for colors in ([good, bad], [bad, good]):
            result, color = record.make({"scene": "s"}, "m", right,
                                        measure.Measured({"ms": 1.0}, None, colors, None, ""))
            self.assertEqual((result["max"], result["ms"], result["scene"]), (7.0, 1.0, "s"))
            self.assertIs(color, bad)
        result, color = record.make({}, "m", right, record.not_run("it is Monday"))
        self.assertEqual((result["reason"], color, "max" in result), ("it is Monday", None, False))

    def test_frames_that_go_on(self):
        """What is measured before and after: the same picture of the same camera."""
        chosen, = catalogue.choose(["hull"])
        settings = measure.Settings(frames=2, budget=5.0, turn=3.0, longest=1.0)
        here = stage.Stage(chosen, (40, 30))
        found = dict(measure.measure(here, ["blend", "abuffer"], settings, mock.MagicMock()))
        first, last = found["abuffer"].colors
        numpy.testing.assert_array_equal(first, last)
        self.assertEqual(found["abuffer"].timing["frames"], 2)
        self.assertGreater(first.std(), 1.0)


class TestScenes(unittest.TestCase):
    def test_names(self):
        names = [s.name for s in catalogue.all_scenes()]
        self.assertEqual(len(set(names)), len(names))
        for name in ("spheres", "isosurfaces", "deep", "layers-1", "layers-256", "triangles-4M",
                     "pixels-4096", "coverage-0.01", "props-2k", *catalogue.QUICK):
            self.assertIn(name, names)

    def test_choosing(self):
        self.assertEqual([s.name for s in catalogue.choose(["layers"])],
                         ["layers-%d" % n for n in families.FAMILIES["layers"]])
        self.assertEqual([s.name for s in catalogue.choose(["layers-?", "hull", "layers-4"])],
                         ["layers-1", "layers-2", "layers-4", "layers-8", "hull"])
        self.assertEqual(len(catalogue.choose(None, True)), len(catalogue.QUICK))
        self.assertEqual(len(catalogue.choose(["volumes"])), len(clouds.VARIANTS) * len(clouds.LAYERS)
                         + len(clouds.OUTSIDE) * len(clouds.OUTSIDE_LAYERS))
        self.assertEqual([s.name for s in catalogue.choose(["volumes-60"])],
                         ["volumes-60-%d" % n for n in clouds.LAYERS]
                         + ["volumes-60-shaded-%d" % n for n in clouds.LAYERS])
        with self.assertRaisesRegex(Error, "no such scene or file"):
            catalogue.choose(["nothing"])

    def test_layers_are_what_they_say(self):
        for name, layers in (("layers-8", 8), ("coincident-0.5", 16), ("one-sphere", 2),
                             ("disjoint", 1)):
            chosen, = catalogue.choose([name])
            contender = stage.Stage(chosen, (40, 40)).contender("abuffer")
            contender.render()
            self.assertEqual(contender.statistics().layers, layers, name)
            contender.close()

    def test_families_change_one_thing(self):
        for family, key in (("triangles", "triangles"), ("props", "props")):
            values = [stage.Stage(s, (10, 10)).facts()[key]
                      for s in catalogue.choose([family]) if s.value < 2e5]
            self.assertEqual(values, sorted(set(values)), family)
        sizes = [s.size for s in catalogue.choose(["pixels"])]
        self.assertEqual(sizes, [(n, n) for n in families.FAMILIES["pixels"]])


class TestVolumes(unittest.TestCase):
    def stage(self, name, size=(24, 20)):
        chosen = [s for s in catalogue.all_scenes() if s.name == name]
        return stage.Stage(chosen[0], size)

    def marched(self, here):
        """The Stage of a family's scene by VolumeMarcher.picture()."""
        cloud, *layers = here.parts
        image = cloud.volume.data
        low, high = visible_range(cloud.volume)
        table = colors.transfer_function(cloud.colormap, low, high)
        given = VolumeMarcher.Cloud(
            vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1]), image.GetOrigin(),
            image.GetSpacing(), cloud.volume.opacities,
            [(value, *table.GetColor(value)) for value in numpy.linspace(low, high, 1025)], cloud.volume.length)
        squares = [VolumeMarcher.Square((0, 0, part.data.GetPoint(0)[2]), (0, 0, 1), part.data.GetPoint(1)[0],
                                        part.color, part.opacity) for part in layers]
        camera = VolumeMarcher.Camera((0, 0, 10), (0, 0, 0), (0, 1, 0), True, 0.8, 30.0, 0.1, 100.0)
        return VolumeMarcher.picture(camera, here.size, given, squares, (*scene.BACKGROUND, 1.0), samples=100)

    def test_what_a_family_is_made_of(self):
        for name, family, samples, shade, layers in (("volumes-60-4", "volumes-60", 60, False, 4),
                                                     ("volumes-240-shaded-0", "volumes-240-shaded", 240, True, 0)):
            here = self.stage(name)
            facts = here.facts()
            self.assertEqual((facts["family"], facts["value"], facts["props"]), (family, layers, 1 + layers))
            self.assertTrue(here.has_volumes())
            for one, factor in ((here, 1), (here.finer(8), 8)):
                volume, = stage.volumes_of(one.renderer())
                low, high = volume.GetBounds()[4:]
                self.assertAlmostEqual((high - low) / volume.GetMapper().GetSampleDistance(), samples * factor, places=3)
                self.assertEqual(bool(volume.GetProperty().GetShade()), shade)
        self.assertFalse(self.stage("one-sphere").has_volumes())

    def test_methods_against_fine_samples(self):
        """VTK's dual depth peeling and ours draw layers in a volume, blending draws the volume over them."""
        here = self.stage("volumes-60-4")
        right = truth.find(here)
        self.assertEqual((right.source, right.layers), ("samples", 4))
        self.assertLess(right.cross_check, 6.0)  # VTK rounds each peel to 8 bits
        expected, certain = self.marched(here)
        self.assertLess(numpy.abs(255 * (right.color - expected[..., :3]))[certain].max(), 1.2)
        errors = {}
        for name in ("blend", "vtk-dual", "auto", "abuffer"):
            contender = here.contender(name)
            contender.render()
            pixels = vtkoit.picture.grab(contender.window)[..., :3]
            contender.close()
            errors[name] = accuracy.measure(pixels, right.color, right.covered).max
        self.assertGreater(errors["blend"], 6.0)
        for name in ("auto", "abuffer"):
            self.assertLessEqual(errors[name], errors["vtk-dual"] + 1.0, name)

    def test_scenes_as_in_practice(self):
        for name in ("flow", "smoke"):
            contender = self.stage(name).contender("auto")
            contender.render()
            pixels = vtkoit.picture.grab(contender.window)[..., :3]
            self.assertGreater(pixels.std(), 10.0, name)
            self.assertGreater(contender.statistics().layers, 1, name)
            contender.close()


class TestContenders(unittest.TestCase):
    def test_parse(self):
        self.assertEqual(contenders.parse("multilayer:NumberOfLayersPerPass=16"),
                         ("multilayer", {"NumberOfLayersPerPass": "16"}))
        self.assertEqual(contenders.parse("vtk-dual"), ("vtk-dual", {}))
        for name, text in (("nothing", "unknown; the methods are: blend"), ("dual:x", "NAME=VALUE"),
                           ("dual:Nothing=1", "has no property"), ("vtk-dual:a=1", "no properties"),
                           ("multilayer:NumberOfLayersPerPass=5", "is refused")):
            with self.assertRaisesRegex(Error, text):
                contenders.parse(name)
        for name in contenders.names() + contenders.names(True):
            contenders.parse(name)
        self.assertLessEqual(set(vtkoit.methods()), set(contenders.names()))

    def test_every_method_draws(self):
        """Three squares one behind the other: the exact ones are right, unsorted blending is not."""
        chosen = scene.Scene(
            "", "", lambda: families.stack(3, opacity=0.5)[::-1], lambda r: scene.facing(r, 0.9))
        here = stage.Stage(chosen, (12, 10))
        right = truth.find(here)
        wrong = {"blend", "vtk-weighted", "weighted-average", "weighted-sum", "weighted-blended"}
        for name in contenders.names():
            with self.subTest(name):
                contender = here.contender(name)
                contender.render()
                pixels = vtkoit.picture.grab(contender.window)[..., :3]
                contender.close()
                errors = accuracy.measure(pixels, right.color, right.covered)
                if name in wrong:
                    self.assertGreater(errors.max, 3.0)
                else:
                    # VTK blends in 8 bits.
                    self.assertLess(errors.max, 3.0 if name.startswith("vtk-") else 1.0)

    def test_sorting_is_for_surfaces(self):
        for name, possible in (("spheres", True), ("molecule", False), ("foliage", False)):
            chosen, = catalogue.choose([name])
            self.assertEqual(not stage.Stage(chosen, (8, 8)).why_not("vtk-sort"), possible, name)


class TestStore(Support.FolderTest):
    def test_keeps_what_was_measured(self):
        store = Store(self.folder, {"frames": 3})
        self.assertIsNone(store.load("a/b", "x:y=1", (2, 3)))
        color = numpy.arange(18, dtype=numpy.uint8).reshape(3, 2, 3)
        store.save("a/b", "x:y=1", (2, 3), {"ms": 1.5}, color)
        again = Store(self.folder, {"frames": 3})
        self.assertEqual(again.load("a/b", "x:y=1", (2, 3)), {"ms": 1.5})
        numpy.testing.assert_array_equal(again.picture("a/b", "x:y=1"), color)
        self.assertEqual(again.outdated, set())
        self.assertIsNone(again.picture("a/b", "other"))

    def test_another_configuration_is_measured_again(self):
        Store(self.folder, {"frames": 3, "cpu": "a"}).save("s", "m", (2, 3), {"ms": 1})
        store = Store(self.folder, {"frames": 4, "cpu": "a"})
        self.assertIsNone(store.load("s", "m", (2, 3)))
        self.assertEqual(store.outdated, {"frames"})
        self.assertIsNone(store.load("s", "m", (4, 3)))
        self.assertEqual(store.outdated, {"frames", "size"})

    def test_damaged_files(self):
        store = Store(self.folder, {})
        store.save("s", "m", (2, 3), {"ms": 1})
        for text in ("", "{", "[]", json.dumps({"configuration": {}})):
            with open(store.path("s", "m.json"), "w", encoding="ascii") as file:
                file.write(text)
            self.assertIsNone(store.load("s", "m", (2, 3)))

    def test_truth(self):
        store = Store(self.folder, {"a": 1})
        self.assertIsNone(store.load_truth("s", (2, 2)))
        store.save_truth("s", (2, 2), {"color": numpy.eye(3)}, {"layers": 4})
        kept = store.load_truth("s", (2, 2))
        numpy.testing.assert_array_equal(kept["color"], numpy.eye(3))
        self.assertEqual(kept["layers"], 4)
        self.assertIsNone(store.load_truth("s", (3, 2)))
        self.assertIsNone(Store(self.folder, {"a": 2}).load_truth("s", (2, 2)))

    def test_folder_that_cannot_be(self):
        with open(self.path("file"), "w", encoding="ascii"):
            pass
        with self.assertRaisesRegex(Error, "cannot be made"):
            Store(self.path("file"), {})

    def test_read_png(self):
        pixels = numpy.arange(24, dtype=numpy.uint8).reshape(2, 4, 3)
        vtkoit.picture.save(pixels, self.path("a.png"))
        numpy.testing.assert_array_equal(read_png(self.path("a.png")), pixels)
        self.assertEqual(os.listdir(self.folder), ["a.png"])


if __name__ == "__main__":
    unittest.main()
