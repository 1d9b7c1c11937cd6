# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command bench with --skips and its like: the pages, and what is in them."""

import json
import os
import unittest
from unittest import mock

import numpy
import Support
from TestBenchCommand import BenchTest
from vtkoit.bench import (
    catalogue,
    changes,
    contenders,
    costs,
    first,
    growth,
    lights,
    rounds,
    scans,
    seedpage,
    seeds,
    skips,
    stage,
)
from vtkoit.errors import Error
from vtkoit.picture import grab

SETTINGS = rounds.Settings(frames=2, turn=0.5, budget=5.0)


def taken(summary, passes=1):
    times = numpy.array([1.0, 2.0])
    statistics = contenders.Statistics("", True, 0.0, passes, 1, 1, 1)
    return rounds.Taken(times, times, statistics, summary)


class TestRounds(unittest.TestCase):
    def test_ratio_of_rounds(self):
        # A round that something else disturbed by a factor of 10 counts like the others.
        slow, fast = numpy.array([3.0, 30.0, 3.3]), numpy.array([1.0, 10.0, 1.0])
        middle, low, high = rounds.ratio(slow, fast)
        self.assertAlmostEqual(middle, 3.0)
        self.assertAlmostEqual(low, 3.0)
        self.assertAlmostEqual(high, 3.15)

    def test_takes(self):
        chosen, = catalogue.choose(["one-sphere"])
        here = stage.Stage(chosen, (40, 40))
        found = rounds.take(here, ["blend", "auto"], SETTINGS, mock.MagicMock())
        self.assertEqual([len(mine.cpu) for mine in found.values()], [2, 2])
        self.assertIsNone(found["blend"].statistics)
        self.assertEqual(found["auto"].summary, "1 of 1 props blended: their order is known")
        still = rounds.take(here, ["auto"], SETTINGS._replace(turn=0.0), mock.MagicMock())
        self.assertEqual(still["auto"].summary, "whole frame reused")


class TestSkips(BenchTest):
    def test_page(self):
        os.mkdir(self.path("docs"))
        out = self.succeeds("--skips", "--quick", "--frames", "1", "--size", "60x60", "-o", "out",
                            "--document", "docs")
        page = self.read("docs", "skips.md")
        self.assertEqual(page, self.read("out", "skips.md"))
        self.assertIn(page, out)
        self.assertIn("vtkoit bench --skips --quick --size 60x60 --frames 1", page)
        rows = json.loads(self.read("out", "skips.json"))["results"]
        self.assertEqual([row["skip"] for row in rows], [row.name for row in skips.skips(True)])
        for row, skip in zip(rows, skips.skips(True)):
            self.assertRegex(page, r"(?m)^\| `%s` \| `\w+` \| %s \| [\d.]+ \| [\d.]+ \| -?\d+ %% \("
                             % (skip.name, row["scene"]))
            if skip.told:
                self.assertIn(skip.told, row["summary"])
        switches = {row["skip"]: row for row in rows}
        self.assertEqual(set(switches), {row.name for row in skips.skips()})
        self.assertLessEqual({"SkipInvisibleProps", "SkipSorting", "SkipHiddenFragments", "ReuseFrames",
                              "TransmittanceThreshold", "UseOcclusionQuery"}, set(switches))
        self.assertEqual(switches["ReuseFrames"]["passes_on"], 0)
        self.assertEqual(switches["ReuseFrames"]["passes_off"], 1)
        self.assertLess(switches["TransmittanceThreshold"]["passes_on"],
                        switches["TransmittanceThreshold"]["passes_off"])

    def test_a_frame_that_does_not_skip(self):
        row = skips.Skip("ReuseFrames", "spheres", "auto", "auto:ReuseFrames=0", skips.REUSED, 0.0)
        skips.check(row, taken(skips.REUSED), taken(""))
        with self.assertRaisesRegex(Error, 'auto does not skip: GetSkipSummary.. is "nothing"'):
            skips.check(row, taken("nothing"), taken(""))
        with self.assertRaisesRegex(Error, "auto:ReuseFrames=0 skips what is switched off"):
            skips.check(row, taken(skips.REUSED), taken(skips.REUSED))
        peeled = row._replace(told="")
        skips.check(peeled, taken("", 2), taken("", 3))
        with self.assertRaisesRegex(Error, "does not skip: 3 geometry passes, and 3 without"):
            skips.check(peeled, taken("", 3), taken("", 3))

    def test_a_scene_without_the_skip(self):
        row = skips.Skip("SkipSorting", "spheres", "auto", "auto:SkipSorting=0", skips.ORDERED, 0.5)
        with self.assertRaisesRegex(Error, "auto does not skip"):
            skips.measure([row], (30, 30), SETTINGS, mock.MagicMock())


class TestCosts(BenchTest):
    def test_constants(self):
        """Made-up times: 2 ns a fragment of blending, 5 ns by the A-buffer, 10 of each pixel."""
        def result(method, layers, ms):
            return {"method": method, "layers": layers, "cpu_ms": ms, "fragments": 1000 * layers}

        def mesh(method, number, ms):
            return {"method": method, "number": number, "triangles": number, "passes": 2, "cpu_ms": ms}

        layers, triangles = [], []
        for n in (1, 4, 16):
            layers.append(result("blend", n, 0.002 * n))
            layers += [result(m, n, 0.005 * n + 0.010) for m in costs.METHODS]
        for n in (1000, 3000):
            triangles += [mesh(m, n, 1.0 + 0.016 * n / 1000) for m in ("blend", *costs.METHODS)]
        rows, unit = costs.constants({"layers": layers, "triangles": triangles})
        self.assertAlmostEqual(unit, 2.0)
        by = dict(rows)
        self.assertAlmostEqual(by["a fragment, of 4 to 16 layers"]["blend"], 1.0)
        self.assertAlmostEqual(by["a fragment, of 4 to 16 layers"]["abuffer"], 2.5)
        self.assertAlmostEqual(by["a pixel of the screen stages"]["dual"], 5.0)
        self.assertAlmostEqual(by["a triangle in a geometry pass"]["multilayer"], 4.0)

    def test_page(self):
        self.succeeds("--costs", "--quick", "--frames", "1", "-o", "out")
        page = self.read("out", "costs.md")
        self.assertRegex(page, r"(?m)^\| a triangle in a geometry pass( \| -?[\d.]+){4} \|$")
        self.assertRegex(page, r"(?m)^\| 4 \| [\d.]+( \| [\d.]+ \(\d+\)){3} \|$")
        self.assertRegex(page, r"(?m)^\| 4 behind each other, 1,792 \| [\d.]+ \| [\d.]+ \(8\) \| [\d.]+ \(1\)")
        bands = json.loads(self.read("out", "costs.json"))["results"]["bands"]
        passes = [r["passes"] for r in bands if r["method"].startswith("abuffer")]
        self.assertGreater(max(passes), 1)
        for row in bands:
            self.assertLessEqual(row["bytes"], row["limit"])


class TestGrowth(BenchTest):
    def test_steps(self):
        results = [{"family": "pixels", "method": "auto", "value": value, "cpu_ms": ms}
                   for value, ms in ((512, 30.0), (256, 10.0), (1024, 120.0))]
        self.assertEqual(growth.steps(results, "pixels", "auto"),
                         [(256, 10.0, None), (512, 30.0, 0.75), (1024, 120.0, 1.0)])

    def test_page(self):
        out = self.succeeds("--growth", "--quick", "--frames", "1", "--no-plots", "--size", "40x40",
                            "-o", "out")
        page = self.read("out", "growth.md")
        self.assertIn(page, out)
        for family, least in (("layers", "1"), ("triangles", "1k"), ("pixels", "256"), ("crowd", "50")):
            self.assertRegex(page, r"(?m)^\| %s \| `blend` \| `auto` \|" % family)
            self.assertRegex(page, r"(?m)^\| %s \| [\d.]+ \| [\d.]+ \| [\d.]+ \|$" % least)
        self.assertRegex(page, r"(?m)^\| 100( \| [\d.]+ \([\d.]+\)){3} \|$")


class TestFirst(BenchTest):
    def test_page(self):
        out = self.succeeds("--first", "--quick", "--frames", "1", "--size", "40x40", "-o", "out")
        page = self.read("out", first.PAGE)
        self.assertIn(page, out)
        results = json.loads(self.read("out", "first.json"))["results"]
        self.assertEqual({row["cache"] for row in results}, {"cold", "warm"})
        for row in results:
            if row["method"] == "blend":
                self.assertEqual(row["frames"][0], 1.0)
                self.assertLess(row["frames"][2], 1.0)  # all is compiled
        self.assertRegex(page, r"(?m)^\| one-sphere \| 1.00 \(.*\) (\| [\d.]+ \([\d.]+, [\d.]+\) ){4}\|$")

    def test_a_process_that_fails(self):
        with self.assertRaisesRegex(Error, "nothing in one-sphere: its process ended with status 1"):
            first._run("one-sphere", "nothing", "40x40", "cold", self.path("."))


class TestChanges(BenchTest):
    def test_known_times(self):
        result = {"changing": {"blend": [2.0, 2.0], "auto": [3.0, 4.0]},
                  "resting": {"blend": [1.0, 1.0], "auto": [1.5, 2.0]}}
        self.assertAlmostEqual(changes.cost(result, "auto"), 2.0)
        self.assertAlmostEqual(changes.added(result, "auto"), 1.5 / 0.75)

    def test_page(self):
        self.succeeds("--changes", "--quick", "--frames", "2", "--size", "40x40", "-o", "out")
        page = self.read("out", changes.PAGE)
        for change in changes.QUICK:
            self.assertRegex(page, r"(?m)^\| %s \| %s \| [\d.]+ \| [\d.]+ \(-?[\d.]+\) \|"
                             % (change.name, change.title))

    def test_each_change_changes_the_picture(self):
        chosen, = catalogue.choose([changes.SCENE])
        for change in changes.CHANGES:
            pair = changes._Pair(stage.Stage(chosen, (60, 60)), "abuffer", change)
            contender = pair.contenders[0]
            pictures = []
            for number in (1, 2):
                change.apply(pair.actors(contender), number)
                contender.render()
                pictures.append(grab(contender.window))
            pair.close()
            if change.name != "series":  # the same data, of another address
                self.assertTrue((pictures[0] != pictures[1]).any(), change.name)


class TestLights(unittest.TestCase):
    def test_tables(self):
        self.assertAlmostEqual(lights.paper()[3][3], 410.0 / 78.0)
        rows = lights.passes_by_lights(passes=(1, 2), lights=(2, 3), size=(60, 40), frames=1)
        self.assertEqual([len(row) for row in rows], [2, 2])
        self.assertEqual(rows[0][0], 1.0)
        self.assertTrue(all(value > 0.0 for row in rows for value in row))
        page = lights.markdown(rows, lights.paper("much"), (1, 2), (2, 3))
        self.assertRegex(page, r"(?m)^\| 1 \| 1.00 \(1.00\) \| [\d.]+ \(1.41\) \|$")
        methods = lights.methods_by_lights(("blend", "deferred-abuffer"), (1,), size=(60, 40), frames=1)
        self.assertEqual(methods["blend", 1][1], 1.0)
        self.assertGreater(methods["deferred-abuffer", 1][0], 0.0)


class TestRefusals(BenchTest):
    def test_bad_input(self):
        self.fails("--skips", "--scenes", "spheres", text="leave --scenes out")
        self.fails("--costs", "--methods", "auto", text="leave --methods out")
        self.fails("--costs", "--skips", text="not allowed with", status=2)
        self.fails("--growth", "--document", "nowhere", text="no such folder")
        with open(self.path("file"), "w", encoding="ascii"):
            pass
        self.fails("--skips", "-o", "file", text="cannot be made")


class TestSeeds(BenchTest):
    def test_page(self):
        os.mkdir(self.path("docs"))
        self.succeeds("--seeds", "--quick", "--frames", "1", "--size", "60x60", "-o", "out",
                      "--document", "docs")
        page = self.read("docs", seedpage.PAGE)
        self.assertEqual(page, self.read("out", seedpage.PAGE))
        self.assertIn("vtkoit bench --seeds --quick --size 60x60 --frames 1", page)
        results = json.loads(self.read("out", "seeds.json"))["results"]
        # N + 1 passes, and one for two layers.
        for row in results["dual"]:
            self.assertEqual(row["passes"][seeds.PEEL], row["layers"] + 1)
            self.assertEqual(row["passes"][seeds.DUAL], (row["layers"] + 1) // 2)
        bucket, = results["buckets"]
        self.assertEqual(bucket["scene"], scans.scenes()[0].name)
        for name, passes in zip(seeds.BUCKETS, (1, 1, 2)):
            self.assertEqual(bucket["methods"][name + ":MaximumNumberOfPeels=1"]["passes"], passes)
            self.assertEqual(bucket["methods"][seeds.SHOT % name]["passes"], passes + 1)
            self.assertLess(bucket["methods"][seeds.SHOT % name]["over8"], 1.0)
        # What is left after a peel is what the next one draws.
        left = results["peels"][0]["fragments"]
        self.assertGreater(left[0], left[1])
        self.assertAlmostEqual(left[0] - left[1], results["peels"][0]["changed"][0])

    def test_verdict_follows_the_numbers(self):
        def row(error):
            methods = {name: {"speed": 1.0, "against_dual": 1.0, "passes": 1}
                       for base in seeds.BUCKETS
                       for name in (base, base + ":MaximumNumberOfPeels=1", seeds.SHOT % base)}
            for base in seeds.BUCKETS:
                methods[seeds.SHOT % base].update(over1=error, over8=0.0)
            return {"scene": "a", "triangles": 1, "layers": 1, "methods": methods}

        self.assertEqual(seedpage.buckets([row(0.2)] * 3).count("does not hold"), 2)
        self.assertNotIn("does not hold", seedpage.buckets([row(0.0), row(0.0), row(9.0)]))


if __name__ == "__main__":
    unittest.main()
