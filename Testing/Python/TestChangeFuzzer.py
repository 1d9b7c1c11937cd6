# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Some of the changes of fuzz/ChangeFuzzer.py, and that it finds an old picture."""

import os
import sys
import unittest
from unittest import mock

import Support

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "fuzz"))

import ChangeFuzzer  # noqa: E402
import changes  # noqa: E402
from stage import Stage  # noqa: E402


class TestChangeFuzzer(Support.FolderTest):
    """Draws in children only: a process that has drawn cannot fork."""

    def test_changes(self):
        self.assertEqual(ChangeFuzzer.main(["--seed", "1", "--count", "2", "--folder", self.folder]), 0)
        self.assertEqual(os.listdir(self.folder), [])

    def test_old_picture_is_found(self):
        """Passes that show their first frame for ever, where VTK alone would not."""
        draw = Stage.draw

        def draw_once(stage):
            if not stage.passes:
                return draw(stage)
            if not hasattr(stage, "first"):
                stage.first = draw(stage)
            return stage.first

        with mock.patch.object(Stage, "draw", draw_once):
            arguments = ["--seed", "2", "--count", "1", "--folder", self.folder]
            self.assertEqual(ChangeFuzzer.main(arguments), 1)
        left = os.listdir(self.folder)
        for name in ("changes-2.json", "changes-2-small.json", "changes-2-kept.png", "changes-2-fresh.png"):
            self.assertIn(name, left)

    def test_every_change_is_applied(self):
        """Each level of each change has the part that it names in a stage."""
        for name, (level, part, _weight, _edit) in changes.CHANGES.items():
            with self.subTest(name):
                self.assertIn(level, ("prop", "renderer", "scene"))
                if level == "renderer":
                    self.assertTrue(callable(getattr(Stage, "set_" + part)))


if __name__ == "__main__":
    unittest.main()
