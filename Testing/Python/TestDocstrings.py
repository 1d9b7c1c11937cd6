# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""docstrings/compare.py, which is run by hand: what it calls different, and that it runs."""

import importlib.util
import os
import subprocess
import sys

import numpy
import Support

FOLDER = os.path.join(sys.path[0], "docstrings")
sys.path.insert(1, FOLDER)
import compare  # noqa: E402 # pylint: disable=wrong-import-position


class TestJudge(Support.FolderTest):
    """Pictures of 20 x 30 pixels; in some, something translucent covers a square."""

    def setUp(self):
        super().setUp()
        self.square = numpy.zeros((20, 30), dtype=bool)
        self.square[5:12, 8:20] = True

    def judge(self, changed=(), steps=0, translucent=True, with_vtkoit=1):
        """The counts for a picture that differs by steps in the pixels changed, (y, x)."""
        empty = numpy.full((20, 30, 3), 200, dtype=numpy.uint8)
        before = empty.copy()
        before[self.square] = (90, 100, 110)
        after = before.copy()
        for place in changed:
            after[place] += numpy.uint8(steps)
        opaque = before.copy()
        opaque[0, 29] = 0  # where one of the samples is covered that VTK leaves out
        for name, picture in (("empty", empty), ("before", before), ("after", after), ("opaque", opaque)):
            numpy.save(self.path(name + ".npy"), picture)
        told = {"picture": "before.npy", "translucent": int(translucent), "without": "empty.npy",
                "opaque": "opaque.npy"}
        judge = compare.Judge(self.folder, self.folder)
        judge.compare("example", {"pictures": [told]}, {"pictures": [{"picture": "after.npy"}] * with_vtkoit})
        return judge.counts

    def check(self, kind, counts):
        self.assertEqual(counts, {"same": 0, "differ": 0, "wrong": 0, kind: 1})

    def test_same(self):
        self.check("same", self.judge())
        self.check("same", self.judge([(0, 0)], compare.STEPS))

    def test_where_something_is_translucent(self):
        self.check("differ", self.judge([(8, 10)], 9))
        self.check("differ", self.judge([(8, 20 + compare.NEAR - 1), (12, 7)], 9))

    def test_elsewhere(self):
        self.check("wrong", self.judge([(8, 20 + compare.NEAR)], 9))
        self.check("wrong", self.judge([(8, 10), (19, 0)], 9))
        self.check("differ", self.judge([(8, 10), (0, 29)], 9))

    def test_nothing_is_translucent(self):
        self.check("same", self.judge(translucent=False))
        self.check("wrong", self.judge([(8, 10)], 1, translucent=False))

    def test_another_number_of_pictures(self):
        self.check("wrong", self.judge(with_vtkoit=2))
        self.check("wrong", self.judge(with_vtkoit=0))


class TestRun(Support.FolderTest):
    def test_one_example(self):
        """Three planes through each other, in three pictures: unsorted without vtkOIT."""
        if importlib.util.find_spec("pyvista") is None:
            self.skipTest("needs PyVista (Debian testing: python3-pyvista)")
        done = subprocess.run([sys.executable, os.path.join(FOLDER, "compare.py"), "-o", self.path("out"),
                               r"PlanesAssembly\.label_position$"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"\n1 examples of \d+; 0 cannot be drawn here, 0 are drawn by chance; "
                                      r"0 pictures are the same, 3 differ where something is translucent, 0 elsewhere\n$")
        self.assertTrue(os.path.isfile(self.path("out/report.html")))


if __name__ == "__main__":
    Support.main()
