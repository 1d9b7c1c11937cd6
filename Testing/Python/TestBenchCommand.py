# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command bench as a whole: its tables and pictures, resuming, and what it refuses."""

import csv
import json
import os
import unittest
from unittest import mock

import Support
from TestErrors import run_here


class BenchTest(Support.FolderTest):
    def bench(self, *arguments):
        return run_here(["bench", *arguments], self.folder)

    def succeeds(self, *arguments):
        done = self.bench(*arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def fails(self, *arguments, text, status=1):
        done = self.bench(*arguments)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (status, 1), done.stderr)
        self.assertRegex(done.stderr, "^vtkoit bench: .*" + text)
        self.assertNotIn("internal error", done.stderr)

    def read(self, *names):
        with open(os.path.join(self.folder, *names), encoding="utf-8") as file:
            return file.read()


class TestRun(BenchTest):
    TINY = ("--scenes", "layers-4", "--size", "40x30", "--frames", "3", "-o", "out")

    def test_tables(self):
        out = self.succeeds(*self.TINY, "--no-plots", "--methods", "abuffer", "vtk-dual")
        self.assertRegex(out, r"(?m)^layers-4: 4 layers .*; 40 x 30, 8 triangles, 4 props, ")
        for method in ("blend", "abuffer", "vtk-dual"):
            self.assertRegex(out, r"(?m)^  %s +\d" % method)
        kept = json.loads(self.read("out", "bench.json"))
        self.assertIn("llvmpipe", kept["machine"]["renderer"] + "llvmpipe")
        for key in ("cpu", "cores", "vtk", "renderer", "date"):
            self.assertTrue(kept["machine"][key], key)
        by_method = {result["method"]: result for result in kept["results"]}
        self.assertEqual(list(by_method), ["blend", "abuffer", "vtk-dual"])
        exact = by_method["abuffer"]
        # A quarter of the window, four times.
        self.assertEqual(exact["fragments"], 4 * 15 * 15)
        self.assertEqual((exact["layers"], exact["passes"], exact["exact"]), (4, 1, True))
        self.assertLess(exact["max"], 0.6)
        self.assertEqual((exact["over1"], exact["alpha_over1"]), (0, 0))
        self.assertEqual(exact["frames"], 3)
        self.assertLessEqual(exact["ms_low"], exact["ms"])
        self.assertGreater(by_method["blend"]["max"], 1.0)
        self.assertEqual(by_method["blend"]["ratio"], 1.0)
        self.assertEqual(by_method["vtk-dual"]["ratio_to_vtk_dual"], 1.0)
        lines = self.read("out", "bench.csv").splitlines()
        self.assertIn("# renderer: %s" % kept["machine"]["renderer"], lines)
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        self.assertEqual([row["method"] for row in rows], list(by_method))
        self.assertEqual(float(rows[1]["ms"]), exact["ms"])

    def test_goes_on(self):
        arguments = (*self.TINY, "--no-plots", "--methods")
        self.succeeds(*arguments, "abuffer")
        kept = os.path.join("out", "results", "layers-4", "abuffer.json")
        before = self.read(kept)
        out = self.succeeds(*arguments, "abuffer", "dual")
        self.assertEqual(self.read(kept), before)  # not measured again
        self.assertNotIn("measured again", out)
        self.assertRegex(out, r"(?m)^  dual +\d")
        # Interrupted while one was measured.
        os.remove(self.path(kept))
        self.succeeds(*arguments, "abuffer", "dual")
        self.assertNotEqual(self.read(kept), before)
        # Another configuration does not mix with it.
        before = self.read(kept)
        out = self.succeeds(*arguments, "abuffer", "--frames", "2")
        self.assertIn("measured again, because of another: frames", out)
        self.assertNotEqual(self.read(kept), before)
        self.assertEqual(json.loads(self.read("out", "bench.json"))["results"][1]["frames"], 2)

    def test_variants_and_files(self):
        Support.write_sphere(self.path("ball.vtp"))
        out = self.succeeds("--scenes", "ball.vtp", "--size", "50x40", "--frames", "1", "--no-plots",
                            "--methods", "multilayer:NumberOfLayersPerPass=4",
                            "bucket:MaximumNumberOfPeels=1,DepthRange=exact")
        self.assertRegex(out, r"(?m)^ball.vtp: the file ball.vtp")
        self.assertRegex(out, r"(?m)^  multilayer:NumberOfLayersPerPass=4 +\d")
        names = os.listdir(self.path("bench/results/ball.vtp"))
        self.assertIn("multilayer_NumberOfLayersPerPass=4.json", names)
        self.assertIn("truth.npz", names)

    def test_what_cannot_run_says_why(self):
        out = self.succeeds("--scenes", "foliage", "--size", "30x30", "--frames", "1", "--no-plots",
                            "--methods", "vtk-sort")
        self.assertRegex(out, r"(?m)^  vtk-sort  sorts polygons of one colour a prop")

    def test_list(self):
        out = self.succeeds("--list")
        for name in ("spheres", "layers-256", "vtk-sort", "multilayer:NumberOfLayersPerPass=16"):
            self.assertRegex(out, r"(?m)^ [* ]%s\b" % name)
        self.assertFalse(os.path.exists(self.path("bench")))

    def test_pictures_and_page(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("needs Matplotlib (Debian: python3-matplotlib)")
        os.mkdir(self.path("docs"))
        self.succeeds("--scenes", "layers-1", "layers-2", "spheres", "--size", "32x32", "--frames", "1",
                      "--methods", "vtk-dual", "abuffer", "-o", "out", "--document", "docs")
        for name in ("time-error-spheres", "time-error-layers-2", "contact-spheres", "cost-layers"):
            with open(self.path("out/%s.png" % name), "rb") as file:
                self.assertEqual(file.read(4), b"\x89PNG", name)
        page = self.read("docs", "accuracy-and-speed.md")
        self.assertIn("vtkoit bench --scenes layers-1 layers-2 spheres --methods vtk-dual abuffer", page)
        self.assertRegex(page, r"(?m)^\| scene \| `vtk-dual` \| `abuffer` \|$")
        self.assertRegex(page, r"(?m)^\| spheres \| [\d.]+ \| [\d.]+ \|$")
        for line in page.split("]("):
            if line.startswith("pictures/"):
                self.assertTrue(os.path.exists(self.path("docs/" + line.split(")")[0])), line)


class TestRefusals(BenchTest):
    def test_bad_input(self):
        self.fails("--scenes", "nothing", text="no such scene or file")
        self.fails("--methods", "nothing", text="unknown; the methods are: blend vtk-weighted")
        self.fails("--methods", "dual:Depth", text="give METHOD:NAME=VALUE")
        self.fails("--methods", "vtk-peel:a=1", text="no properties here")
        self.fails("--size", "0x5", text="give WIDTHxHEIGHT")
        self.fails("--frames", "0", text="give 1 to 10000")
        self.fails("--budget", "0", text="give seconds above 0")
        self.fails("--frames", "x", text="invalid int", status=2)
        self.fails("--document", "nowhere", text="no such folder")
        with open(self.path("file"), "w", encoding="ascii") as file:
            file.write("no folder")
        self.fails("--scenes", "disjoint", "--no-plots", "-o", "file", text="cannot be made")
        self.fails("--scenes", "file", "--no-plots", "--methods", "abuffer", text="has no extension")

    def test_without_matplotlib(self):
        with mock.patch.dict("sys.modules", {"matplotlib": None}):
            self.fails("--scenes", "disjoint", text=r"python3-matplotlib\); --no-plots leaves them out")
            self.succeeds("--scenes", "disjoint", "--size", "20x20", "--frames", "1", "--no-plots",
                          "--methods", "abuffer")


if __name__ == "__main__":
    unittest.main()
