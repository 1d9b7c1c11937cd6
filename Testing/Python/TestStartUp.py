# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""bin/vtkoit-python, and what importing the package does and does not do."""

import subprocess
import sys
import unittest

import Support


def python(*arguments, text=None):
    return subprocess.run([Support.program("vtkoit-python"), *arguments], input=text,
                          env=Support.bare_environment(), capture_output=True, text=True,
                          check=False)


class TestVtkoitPython(Support.FolderTest):
    def succeeds(self, done, output):
        self.assertEqual((done.returncode, done.stderr, done.stdout), (0, "", output))

    def test_windows_are_headless(self):
        done = python("-c", "import vtkoit; from vtkoit.windows import make_window, context_of\n"
                      "print(vtkoit.backend(), context_of(make_window(None, (8, 8))).version[0])")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^(OSMesa|EGL) \d\n$")

    def test_like_python(self):
        self.succeeds(python("-c", "print(3)"), "3\n")
        self.succeeds(python("-", text="print(4)"), "4\n")
        with open(self.path("script.py"), "w", encoding="ascii") as file:
            file.write("import sys\nprint(__name__, sys.argv[1:])\n")
        self.succeeds(python(self.path("script.py"), "-x", "y z"), "__main__ ['-x', 'y z']\n")
        self.succeeds(python("-m", "vtkoit", "--version"), Support.run("--version").stdout)
        self.assertEqual(python("-c", "raise SystemExit(7)").returncode, 7)


class TestImport(unittest.TestCase):
    def plain(self, code):
        """Runs code in the Python below, started without vtkoit-python."""
        import os

        environment = Support.bare_environment()
        environment["PYTHONPATH"] = os.path.dirname(Support.PACKAGE)
        return subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True,
                              text=True, check=False)

    def test_import_does_not_force_headless(self):
        done = self.plain(
            "import os, vtkoit, vtkoit.vtkOITOSMesa\n"
            "from vtkmodules.vtkCommonCore import vtkObjectFactory\n"
            "names = [vtkObjectFactory.GetRegisteredFactories().GetItemAsObject(i).GetClassName()\n"
            "         for i in range(vtkObjectFactory.GetRegisteredFactories().GetNumberOfItems())]\n"
            "print(repr(vtkoit.backend()), 'VTK_DEFAULT_OPENGL_WINDOW' in os.environ,\n"
            "      any('OSMesa' in name for name in names))")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, "'' False False\n")

    def test_headless_explicitly_and_again(self):
        done = self.plain("import vtkoit\nprint(vtkoit.headless() == vtkoit.headless() != '')")
        self.assertEqual((done.returncode, done.stderr, done.stdout), (0, "", "True\n"))

    def test_all_names_are_there_and_documented(self):
        import vtkoit

        for name in vtkoit.__all__:
            self.assertTrue(getattr(vtkoit, name))
            if not name.startswith("__"):
                self.assertTrue(getattr(vtkoit, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
