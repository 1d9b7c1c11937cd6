# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Some of the random scenes of fuzz/SceneFuzzer.py, and that it finds what it looks for."""

import contextlib
import io
import os
import signal
import sys
import time
import unittest

import Support

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "fuzz"))

import describe  # noqa: E402
import SceneFuzzer  # noqa: E402
import supervise  # noqa: E402


class TestSceneFuzzer(Support.FolderTest):
    """Draws in children only: a process that has drawn cannot fork."""

    def test_scenes(self):
        self.assertEqual(SceneFuzzer.main(["--seed", "1", "--count", "12", "--folder", self.folder]), 0)
        self.assertEqual(os.listdir(self.folder), [])

    def test_wrong_order_is_found(self):
        """VTK's own blending, which is not sorted, taken for a method that says it is right."""
        arguments = ["--seed", "3", "--count", "1", "--methods", "abuffer", "vtk", "--folder", self.folder]
        self.assertEqual(SceneFuzzer.main(arguments), 1)
        left = os.listdir(self.folder)
        self.assertIn("scene-3-abuffer-1.png", left)
        self.assertIn("scene-3-vtk-1.png", left)
        # Again from the file, in a child of its own.
        replay = os.path.join(self.folder, "scene-3-small.json")

        def again(_seed):
            return {"failed": SceneFuzzer.main(["--methods", "abuffer", "vtk", "--replay", replay])}

        self.assertEqual(supervise.run([0], again)["failed"], 1)

    def test_crash_and_hang_are_failures(self):
        def case(seed):
            if seed == 1:
                os.kill(os.getpid(), signal.SIGSEGV)
            if seed == 3:
                time.sleep(600.0)
            return {"drawn": 1}

        before, supervise.SECONDS = supervise.SECONDS, 2
        try:
            with contextlib.redirect_stdout(io.StringIO()) as printed:
                sums = supervise.run(range(5), case)
        finally:
            supervise.SECONDS = before
        self.assertEqual(dict(sums), {"seeds": 5, "drawn": 3, "failed": 2})
        self.assertEqual(printed.getvalue(), "seed 1: crashed by signal 11\nseed 3: no end after 2 s\n")

    def test_description_is_all_of_a_scene(self):
        """The same seed gives the same scene, another one another."""
        import json
        import random

        texts = [json.dumps(describe.scene(random.Random(seed), 64)) for seed in (5, 5, 6)]
        self.assertEqual(texts[0], texts[1])
        self.assertNotEqual(texts[0], texts[2])


if __name__ == "__main__":
    unittest.main()
