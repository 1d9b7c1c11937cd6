# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The programs themselves: help, info, other working folders, pipes, progress on a terminal."""

import os
import pty
import subprocess
import sys
import unittest

import Support
import vtkoit
from vtkmodules.vtkCommonCore import vtkVersion


class TestHelp(unittest.TestCase):
    def test_help_everywhere(self):
        for arguments in ([], ["render"], ["compare"], ["info"], ["run"], ["showcase"], ["bench"]):
            for option in ("-h", "--help"):
                done = Support.run(*arguments, option)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn("usage: vtkoit", done.stdout)
                self.assertIn("example", done.stdout)

    def test_version(self):
        out = Support.run("--version").stdout
        self.assertRegex(out, r"^vtkOIT %s\nbuilt for VTK %s, Python 3\.\d+; windows: .*(OSMesa|EGL).*\n$" % (
            vtkoit.__version__, vtkVersion.GetVTKVersion()))


class TestInfo(unittest.TestCase):
    def test_rows(self):
        done = Support.run("info")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for text in (r"(?m)^VTK +9\.\d+\.\d+", r"(?m)^window +vtk\w+RenderWindow \(headless, \w+\)",
                     r"(?m)^OpenGL +\d\.\d", r"(?m)^renderer +\S", r"(?m)^vendor +\S",
                     r"(yes|no) +GL_EXT_shader_framebuffer_fetch",
                     r"abuffer +vtkOITABufferPass +runs",
                     r"auto takes A-buffer: its fragments fit into memory, at most [\d.]+ MiB"):
            self.assertRegex(done.stdout, text)

    def test_as_a_module(self):
        environment = Support.bare_environment()
        environment["PYTHONPATH"] = os.path.dirname(Support.PACKAGE)
        done = subprocess.run([sys.executable, "-m", "vtkoit", "info"], env=environment,
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, Support.run("info").stdout)


class TestPlaces(Support.FolderTest):
    def test_working_folder_with_misleading_names(self):
        for name in ("vtkoit", "vtkmodules", "numpy"):
            os.mkdir(self.path(name))
        for name in ("render.py", "errors.py", "argparse.py"):
            with open(self.path(name), "w", encoding="ascii") as file:
                file.write("raise SystemExit('the wrong module')\n")
        self.assertEqual(self.vtkoit("info").returncode, 0)

    def test_through_a_link(self):
        os.symlink(Support.program(), self.path("link"))
        done = subprocess.run([self.path("link"), "--version"], env=Support.bare_environment(),
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_reader_of_the_output_leaves(self):
        done = subprocess.run("'%s' info | true" % Support.program(), shell=True, cwd=self.folder,
                              env=Support.bare_environment(), capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.stderr, "")

    def test_progress_on_a_terminal_only(self):
        # Four million cells: takes more than a second to contour and smooth.
        Support.write_volume(self.path("a.vti"), 90)
        command = [Support.program(), "render", "a.vti", "--isosurface", "120", "150", "180",
                   "--size", "40x40", "-o", "a.png"]
        ours, theirs = pty.openpty()
        process = subprocess.Popen(command, cwd=self.folder, env=Support.bare_environment(),
                                   stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        text = b""
        while True:
            try:
                piece = os.read(ours, 4096)
            except OSError:
                break
            if not piece:
                break
            text += piece
        os.close(ours)
        self.assertEqual(process.wait(), 0)
        if text:  # nothing on a machine that needs less than a second
            self.assertTrue(text.endswith(b"\r\x1b[K"), text[-80:])
            self.assertIn(b"a.vti", text)
        done = self.vtkoit(*command[1:])
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
