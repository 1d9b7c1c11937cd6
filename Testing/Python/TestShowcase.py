# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkoit showcase: the pictures, the numbers."""

import os
import re
import unittest

import Support


class TestShowcase(Support.FolderTest):
    def test_showcase(self):
        done = self.vtkoit("showcase", "-o", "new/folder", "--size", "120x100")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        names = re.findall(r"new/folder/\S+\.png", done.stdout)
        self.assertEqual(len(set(names)), 9)
        for name in names:
            self.assertEqual(Support.read_picture(self.path(name)).shape, (100, 120, 3))
        self.assertEqual(sorted(os.listdir(self.path("new/folder"))),
                         sorted(os.path.basename(name) for name in names))
        ours = re.findall(r"vtkOIT auto .*png +(\d+) +([\d.]+) +([\d.]+) +([\d.]+)", done.stdout)
        theirs = re.findall(r"VTK's default .*png +(\d+) +([\d.]+) +([\d.]+) +([\d.]+)", done.stdout)
        self.assertEqual((len(ours), len(theirs)), (3, 3))
        for row, their_row in zip(ours, theirs):
            # Exact but for the rounding to 8 bits and the half-float colours.
            self.assertLess(float(row[2]), 1.0)
            self.assertLess(float(row[3]), 0.5)
            self.assertGreater(float(their_row[2]), 20.0)


if __name__ == "__main__":
    unittest.main()
