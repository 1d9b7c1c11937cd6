# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command compare: pictures, differences and errors of the user's own data by every method."""

import csv
import json
import os
import unittest

import numpy
import Support
import vtkoit
from TestErrors import run_here
from vtkoit.compare import amplify


class TestCompare(Support.FolderTest):
    def setUp(self):
        super().setUp()
        Support.write_sphere(self.path("outer.vtp"), 2.0)
        Support.write_sphere(self.path("inner.vtp"), 1.0)

    def compare(self, *arguments):
        done = run_here(["compare", *arguments], self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def results(self, folder="comparison"):
        with open(self.path(folder + "/compare.json"), encoding="utf-8") as file:
            return {result["method"]: result for result in json.load(file)["results"]}

    def test_every_method(self):
        out = self.compare("outer.vtp", "inner.vtp", "--opacity", "0.3", "0.6", "--size", "60x50")
        results = self.results()
        self.assertLessEqual({"blend", "vtk-dual", *vtkoit.methods()}, set(results))
        for method, result in results.items():
            self.assertRegex(out, r"(?m)^  %s +\d" % method)
            for name in (method, method + "-difference"):
                pixels = Support.read_picture(self.path("comparison/%s.png" % name))
                self.assertEqual(pixels.shape, (50, 60, 3), name)
            self.assertEqual(result["triangles"], 2 * 1056)
            if result.get("exact"):
                self.assertLess(result["max"], 1.0, method)
        self.assertGreater(results["weighted-average"]["max"], 3.0)
        with open(self.path("comparison/compare.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.assertEqual([row["method"] for row in rows], list(results))

    def test_options_of_the_scene(self):
        Support.write_volume(self.path("a.vti"))
        out = self.compare("a.vti", "--isosurface", "120", "200", "--opacity", "0.4", "--size", "40x30",
                           "--camera", "x", "--background", "transparent", "--methods", "dual",
                           "-o", "out")
        self.assertRegex(out, r"(?m)^a.vti: 2 surfaces; 40 x 30, ")
        self.assertEqual(list(self.results("out")), ["blend", "dual"])
        self.assertLess(self.results("out")["dual"]["alpha_max"], 1.0)
        self.assertEqual(Support.read_picture(self.path("out/dual.png"))[0, 0].tolist(), [0, 0, 0])
        out = self.compare("a.vti", "--methods", "abuffer", "--size", "30x20")
        self.assertIn("chosen by Otsu's method", out)

    def test_differences(self):
        right = numpy.full((1, 4, 3), 100 / 255)
        color = numpy.array([[[100] * 3, [101] * 3, [110] * 3, [0] * 3]], dtype=numpy.uint8)
        self.assertEqual(amplify(color, right)[0, :, 0].tolist(), [0, 8, 152, 255])

    def test_refusals(self):
        for arguments, text in (
                (["nothing.vtp"], "no such file"), (["outer.vtp", "--methods", "x"], "unknown; the methods"),
                (["outer.vtp", "--size", "1"], "give WIDTHxHEIGHT"),
                (["outer.vtp", "--opacity", "2"], "not in the range"),
                (["outer.vtp", "-o", "inner.vtp"], "cannot be made")):
            done = run_here(["compare", *arguments], self.folder)
            self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
            self.assertRegex(done.stderr, r"^vtkoit compare: .*%s.*\n$" % text)
        self.assertFalse(os.path.exists(self.path("comparison")))


if __name__ == "__main__":
    unittest.main()
