# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The target uninstall: what was installed goes, with what Python compiled of it, and nothing else."""

import os
import shutil
import subprocess
import unittest

import Support

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "CMake", "vtkOITUninstall.cmake")
INSTALLED = ("lib/libvtkOIT.so.0.2", "lib/python3/vtkoit/__init__.py", "lib/python3/vtkoit/bench/run.py",
             "include/vtkOIT/vtkOITPass.h", "bin/vtkoit")
COMPILED = ("lib/python3/vtkoit/__pycache__/__init__.cpython-311.pyc",
            "lib/python3/vtkoit/bench/__pycache__/run.cpython-311.opt-1.pyc")
OTHERS = ("lib/python3/__pycache__/other.cpython-311.pyc", "bin/other", "lib/python3/vtkoit/bench/mine.txt")


class TestUninstall(Support.FolderTest):
    def uninstall(self):
        return subprocess.run(["cmake", "-DBUILD=" + self.path("build"), "-P", SCRIPT], capture_output=True, text=True,
                              check=False)

    def test_uninstall(self):
        if not shutil.which("cmake"):
            self.skipTest("no cmake in PATH")
        prefix = self.path("vtkoit/prefix")  # below a folder that has our name by chance
        for name in INSTALLED + COMPILED + OTHERS:
            os.makedirs(os.path.dirname(os.path.join(prefix, name)), exist_ok=True)
            with open(os.path.join(prefix, name), "w", encoding="utf-8"):
                pass
        os.symlink("gone.so", os.path.join(prefix, "lib", "libvtkOIT.so"))
        os.mkdir(self.path("build"))
        with open(self.path("build/install_manifest.txt"), "w", encoding="utf-8") as file:
            file.write("\n".join(os.path.join(prefix, name) for name in INSTALLED + ("lib/libvtkOIT.so",)))
        done = self.uninstall()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("6 files removed", done.stdout)
        left = sorted(os.path.relpath(os.path.join(folder, name), prefix)
                      for folder, _, names in os.walk(prefix) for name in names)
        self.assertEqual(left, sorted(OTHERS))
        self.assertFalse(os.path.exists(os.path.join(prefix, "include", "vtkOIT")))
        self.assertTrue(os.path.isdir(os.path.join(prefix, "include")))

        done = self.uninstall()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("nothing was installed from", done.stderr)


if __name__ == "__main__":
    unittest.main()
