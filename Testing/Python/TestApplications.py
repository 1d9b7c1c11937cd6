# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkoit run with programs of the distribution, unchanged: Utilities/packages.sh applications has them.

One class a program. What needs a screen gets one of Xvfb.
"""

import importlib.util
import os
import shutil
import subprocess
import sys

import numpy
import Support

# Scripts as a user writes them: the picture, the opacity in percent, and whether to install a pass.
PLAIN = """
import sys
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)
import vtkmodules.vtkRenderingOpenGL2
renderer = vtkRenderer()
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(200, 200)
window.AddRenderer(renderer)
for i, color in enumerate([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0)]):
    source = vtkSphereSource() if i < 3 else vtkCubeSource()
    source.SetCenter(0.35 * i, 0.2 * i, 0.3 * i)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(int(sys.argv[2]) / 100)
    renderer.AddActor(actor)
if sys.argv[3:]:
    import vtkoit
    vtkoit.install(window)
window.Render()
shot = vtkWindowToImageFilter()
shot.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(shot.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
"""

MAYAVI = """
import sys
import numpy as np
from mayavi import mlab
mlab.options.offscreen = True
opacity = int(sys.argv[2]) / 100
figure = mlab.figure(size=(200, 200), bgcolor=(1, 1, 1))
x, y, z = np.mgrid[-5:5:30j, -5:5:30j, -5:5:30j]
values = np.sin(x * y * z / 10) / (x * y * z / 10 + 1e-6) + 0.2 * np.cos(x) + 0.1 * y / 5
mlab.contour3d(x, y, z, values, contours=[0.1, 0.3, 0.6, 0.9], opacity=opacity)
u, v = np.linspace(0, 2 * np.pi, 40), np.linspace(0, np.pi, 20)
mlab.mesh(4 * np.outer(np.cos(u), np.sin(v)), 4 * np.outer(np.sin(u), np.sin(v)),
          4 * np.outer(np.ones(40), np.cos(v)), color=(1, 0.5, 0), opacity=opacity)
mlab.view(40, 60)
if sys.argv[3:]:
    import vtkoit
    from tvtk.api import tvtk
    vtkoit.install(tvtk.to_vtk(figure.scene.render_window))
mlab.savefig(sys.argv[1], size=(200, 200))
"""

VEDO = """
import sys
from vedo import Cone, Cube, Plotter, Sphere, settings
settings.default_backend = "vtk"
alpha = int(sys.argv[2]) / 100
plotter = Plotter(offscreen=True, size=(200, 200))
objects = [Sphere(pos=(0.35 * i, 0.2 * i, 0.3 * i), r=0.5, c=color, alpha=alpha)
           for i, color in enumerate(["red", "green", "blue"])]
objects.append(Cube(pos=(0.35, 0.2, 0.3), c="yellow", alpha=alpha))
objects.append(Cone(pos=(0.35, 0.2, 0.3), r=0.15, height=0.4, c="k"))
plotter.show(*objects, azimuth=30, elevation=20)
if sys.argv[3:]:
    import vtkoit
    vtkoit.install(plotter)
    plotter.render()
plotter.screenshot(sys.argv[1])
"""

screen = None  # the process of Xvfb, and the number of its display
display = ""


def setUpModule():
    global screen, display  # pylint: disable=global-statement
    if shutil.which("Xvfb"):
        ours, theirs = os.pipe()
        screen = subprocess.Popen(["Xvfb", "-displayfd", str(theirs), "-screen", "0", "640x480x24"],
                                  pass_fds=[theirs], stderr=subprocess.DEVNULL)
        os.close(theirs)
        with open(ours, encoding="ascii") as pipe:
            display = ":" + pipe.readline().strip()


def tearDownModule():
    if screen:
        screen.terminate()
        screen.wait()


class ApplicationTest(Support.FolderTest):
    def setUp(self):
        super().setUp()
        if not screen:
            self.skipTest("needs Xvfb (Debian: xvfb)")

    def picture(self, command, run=(), **variables):
        """What a program draws into picture.png, height x width x 3, int.

        command: list of str. run: the arguments of vtkoit run, or None to run it alone.
        """
        if os.path.exists(self.path("picture.png")):
            os.remove(self.path("picture.png"))
        command = command if run is None else [Support.program(), "run", *run, *command]
        environment = {**Support.bare_environment(), "DISPLAY": display, "HOME": self.folder,
                       "PYTHONPATH": os.path.dirname(Support.PACKAGE), **variables}
        done = subprocess.run(command, cwd=self.folder, env=environment, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotRegex(done.stdout + done.stderr, "ERROR|translucency is left to VTK")
        self.said = done.stderr
        return Support.read_picture(self.path("picture.png"))[:, :, :3].astype(int)

    def check_script(self, text, module):
        """With vtkoit run a script draws what it draws with install(), which stock does not; and what
        stock draws where nothing is translucent."""
        if not importlib.util.find_spec(module):
            self.skipTest("needs the Python module %s (Debian: Utilities/packages.sh applications)" % module)
        with open(self.path("script.py"), "w", encoding="utf-8") as file:
            file.write(text)
        command = [sys.executable, "script.py", "picture.png"]
        stock = self.picture([*command, "40"], run=None)
        right = self.picture([*command, "40", "install"], run=None)
        self.assertGreater(abs(stock - right).max(), 10)
        numpy.testing.assert_array_equal(self.picture([*command, "40"], run=["--log"]), right)
        self.assertRegex(self.said, r"(?m)^vtkoit: vtk\w*OpenGLRenderer: \d+ frames, \d+ exact; the last one by")
        opaque = self.picture([*command, "100"], run=None)
        numpy.testing.assert_array_equal(self.picture([*command, "100"]), opaque)


class Plain(ApplicationTest):
    def test_script(self):
        self.check_script(PLAIN, "vtkmodules")


class Mayavi(ApplicationTest):
    def test_script(self):
        self.check_script(MAYAVI, "mayavi")


class Vedo(ApplicationTest):
    def test_script(self):
        self.check_script(VEDO, "vedo")


class F3D(ApplicationTest):
    """Its chain of passes is private. Its own depth peeling is VTK's, which is close to right for as few layers
    as here, and not exact."""

    def setUp(self):
        super().setUp()
        if not shutil.which("f3d"):
            self.skipTest("needs f3d (Debian: f3d)")
        Support.write_spheres(self.path("spheres.vtp"))

    def draw(self, *options, run=()):
        return self.picture(["f3d", "spheres.vtp", "--output=picture.png", "--resolution=200,200",
                             *self.no_configuration(), *options], run=run)

    @staticmethod
    def no_configuration():
        text = subprocess.run(["f3d", "--help"], capture_output=True, text=True, check=False).stdout
        return ["--no-config"] if "--no-config" in text else ["--dry-run"]

    def test_picture(self):
        stock = self.draw("--opacity=0.4", run=None)
        right = self.draw("--opacity=0.4", "-p", run=None)
        self.assertGreater(abs(stock - right).max(), 10)
        reached = []
        for method in ("auto", "peel"):
            reached.append(self.draw("--opacity=0.4", run=["--method", method, "--log"]))
            self.assertRegex(self.said, "reached in place of its vtk[A-Za-z]+Pass, method %s" % method)
            self.assertRegex(self.said, r"[1-9]\d* frames, [1-9]\d* exact")
            self.assertGreater(abs(reached[-1] - stock).max(), 10)
            self.assertLess(abs(reached[-1] - right).mean(), 0.1 * abs(stock - right).mean())
        self.assertLessEqual(abs(reached[0] - reached[1]).max(), 2)
        numpy.testing.assert_array_equal(self.draw(), self.draw(run=None))

    def test_without_preload(self):
        numpy.testing.assert_array_equal(
            self.draw("--opacity=0.4", run=["--no-preload"]), self.draw("--opacity=0.4", run=None))


if __name__ == "__main__":
    Support.main()
