# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkoit run, and the libraries that it brings into programs that know nothing of vtkOIT."""

import os
import re
import subprocess
import sys
import unittest

import Support
from vtkoit import application
from vtkoit.errors import Error

# Draws by VTK alone; without a display, because bin/vtkoit-python runs it.
SCRIPT = """
import sys
sys.path.insert(0, %r)
import Support
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass
import vtkmodules.vtkRenderingOpenGL2
from vtkoit.windows import make_window
renderer = Support.sphere_renderer()
for argument in sys.argv[2:]:
    exec(argument)
window = make_window(renderer, (120, 100))
window.Render()
shot = vtkWindowToImageFilter()
shot.SetInput(window)
shot.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(shot.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
print(renderer.GetUseDepthPeeling())
""" % sys.path[0]

INSTALL = "import vtkoit; vtkoit.install(renderer)"
SILENT = "print = lambda _: sys.stdout.write('0\\n')"
OPAQUE = "[each.GetProperty().SetOpacity(1) for each in renderer.GetActors()]"
LIBRARY = os.path.join(os.path.dirname(os.path.realpath(application.__file__)), application.LIBRARIES)
AUTOLOAD = os.path.normpath(os.path.join(LIBRARY, "autoload", "libvtkOITAutoload.so"))
PRELOAD = os.path.normpath(os.path.join(LIBRARY, "preload", "libvtkOITPreload.so"))


class ScriptTest(Support.FolderTest):
    def draw(self, *arguments, run=(), **variables):
        """What the script wrote on standard error, and its picture.

        arguments: of the script. run: those of vtkoit run, or None for no vtkoit run.
        """
        with open(self.path("script.py"), "w", encoding="utf-8") as file:
            file.write(SCRIPT)
        script = [self.path("script.py"), self.path("picture.png"), *arguments]
        if run is None:
            done = Support.run(*script, name="vtkoit-python", **variables)
        else:
            done = Support.run("run", *run, Support.program("vtkoit-python"), *script, **variables)
        self.assertEqual((done.returncode, done.stdout), (0, "0\n"), done.stderr)
        return done.stderr, Support.read_picture(self.path("picture.png")).tobytes()


class TestRun(ScriptTest):
    pictures = None  # by VTK, and by install(): drawn once

    def setUp(self):
        super().setUp()
        if TestRun.pictures is None:
            # Installed, the renderer has peeling on, which the script prints.
            TestRun.pictures = self.draw(run=None)[1], self.draw(INSTALL, SILENT, run=None)[1]
        self.stock, self.right = TestRun.pictures

    def test_the_picture_is_that_of_install(self):
        self.assertNotEqual(self.stock, self.right)
        self.assertEqual(self.draw(), ("", self.right))
        self.assertEqual(self.draw("renderer.SetPass(vtkRenderStepsPass())"), ("", self.right))

    def test_nothing_translucent(self):
        self.assertEqual(self.draw(OPAQUE), ("", self.draw(OPAQUE, run=None)[1]))

    def test_method_and_log(self):
        errors, picture = self.draw(run=("--method", "abuffer", "--log"))
        self.assertEqual(picture, self.right)
        self.assertEqual(len(errors.splitlines()), 2, errors)
        self.assertRegex(errors, r"(?m)^vtkoit: vtkOpenGLRenderer reached when it was made, method abuffer$")
        self.assertRegex(errors, r"(?m)^vtkoit: vtkOpenGLRenderer: 2 frames, 2 exact; the last one by A-buffer, "
                                 r"1 geometry passes, \d+ fragments, up to \d+ in a pixel$")

    def test_off(self):
        self.assertEqual(self.draw(VTKOIT_AUTOLOAD="0"), ("", self.stock))
        self.assertEqual(self.draw(run=("--respect",)), ("", self.stock))

    def test_wrong_values(self):
        for name, value in (("VTKOIT_METHOD", "zbuffer"), ("VTKOIT_AUTOLOAD", "always"), ("VTKOIT_LOG", "much")):
            errors, picture = self.draw(**{name: value})
            self.assertEqual(picture, self.stock)
            self.assertRegex(errors, r"^vtkoit: %s=%s is not known; give [^\n]*; translucency is left to VTK\n$"
                             % (name, value))

    def test_preload(self):
        # VTK's autoload is off: only the constructors are replaced.
        for peeling in ("0", "1"):
            errors, picture = self.draw("renderer.SetUseDepthPeeling(%s)" % peeling,
                                        SILENT, run=None, LD_PRELOAD=PRELOAD, VTKOIT_LOG="1")
            self.assertEqual(picture, self.right)
            self.assertRegex(errors, "vtkOpenGLRenderer reached in place of its vtk[A-Za-z]+Pass, method auto\n")
        self.assertEqual(self.draw(run=("--preload",)), ("", self.right))
        self.assertEqual(self.draw(run=None, LD_PRELOAD=PRELOAD, VTKOIT_AUTOLOAD="0"), ("", self.stock))


class TestOtherVTK(unittest.TestCase):
    """Libraries that stand in for other VTKs, see Autoload/CMakeLists.txt."""

    def load(self, *libraries, **variables):
        code = "import ctypes, sys\nfor each in sys.argv[1:]: ctypes.CDLL(each)\nprint(%s)" % (
            "any('libvtkOIT.so' in line for line in open('/proc/self/maps'))")
        done = subprocess.run([sys.executable, "-c", code, *libraries], capture_output=True, text=True,
                              check=False, env={**Support.bare_environment(), **variables})
        self.assertEqual((done.returncode, done.stdout), (0, "False\n"), done.stderr)
        return done.stderr

    def refused(self, text, *libraries):
        self.assertRegex(self.load(*libraries, AUTOLOAD),
                         "^vtkoit: this program has [^\n]*%s[^\n]*; translucency is left to VTK\n$" % text)

    def test_refused(self):
        folder = os.environ.get("VTKOIT_TEST_LIBRARIES", "")
        self.assertTrue(folder, "ctest sets VTKOIT_TEST_LIBRARIES")
        stand_ins = {name: os.path.join(folder, name, os.listdir(os.path.join(folder, name))[0])
                     for name in os.listdir(folder)}
        self.refused("its VTK built in, and vtkOIT was built for libvtkCommonCore")
        self.refused("libvtkCommonCore-pv0.1.so.1, and vtkOIT was built for libvtkCommonCore", stand_ins["paraview"])
        self.refused("VTK 0.0.1, and vtkOIT was built for VTK", stand_ins["version"])
        self.refused("two VTKs", stand_ins["paraview"], stand_ins["version"])

    def test_programs_without_vtk(self):
        self.assertEqual(self.load(LD_PRELOAD=PRELOAD), "")


class TestEnvironment(unittest.TestCase):
    def setUp(self):
        for name in ("VTK_AUTOLOAD_PATH", "VTKOIT_AUTOLOAD", "VTKOIT_METHOD", "VTKOIT_LOG", "LD_PRELOAD"):
            os.environ.pop(name, None)

    def test_what_is_known_of_programs(self):
        for program in ("python3", "/usr/bin/mayavi2"):
            variables = application.environment(program)
            self.assertEqual(variables["VTK_AUTOLOAD_PATH"], os.path.dirname(AUTOLOAD))
            self.assertNotIn("LD_PRELOAD", variables)
            self.assertNotIn("VTKOIT_AUTOLOAD", variables)
        self.assertEqual(application.environment("/usr/bin/f3d")["LD_PRELOAD"], PRELOAD)
        self.assertNotIn("LD_PRELOAD", application.environment("f3d", preload=False))
        self.assertEqual(application.environment("pvpython")["VTKOIT_AUTOLOAD"], "respect")

    def test_what_was_there_is_kept(self):
        os.environ.update(VTK_AUTOLOAD_PATH="/a:/b", LD_PRELOAD="/c.so")
        self.addCleanup(self.setUp)
        for _ in range(2):
            variables = application.environment("x", preload=True)
            self.assertEqual(variables["VTK_AUTOLOAD_PATH"], os.path.dirname(AUTOLOAD) + ":/a:/b")
            self.assertEqual(variables["LD_PRELOAD"], PRELOAD + ":/c.so")
            os.environ.update(variables)

    def test_errors(self):
        with self.assertRaisesRegex(Error, "^method zbuffer: unknown"):
            application.environment("python3", method="zbuffer")
        for arguments, text in ((("no-such-program",), "no-such-program: no such program"),
                                ((), "give the program to run, such as: vtkoit run mayavi2")):
            done = Support.run("run", *arguments)
            self.assertEqual((done.returncode, done.stderr), (1, "vtkoit run: %s\n" % text))

    def test_status_and_arguments_are_those_of_the_program(self):
        done = Support.run("run", "--log", "sh", "-c", "echo $1 $VTKOIT_LOG; exit 7", "x", "--log")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (7, "--log 1\n", ""))
        self.assertRegex(Support.run("run", "env").stdout, re.escape("VTK_AUTOLOAD_PATH=" + os.path.dirname(AUTOLOAD)))


if __name__ == "__main__":
    unittest.main()
