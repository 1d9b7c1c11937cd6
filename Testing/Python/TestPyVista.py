# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista: plotter.oit, install(plotter), and every mode that builds a chain of passes."""

import importlib.metadata
import importlib.util
import json
import os
import subprocess
import sys
import unittest

import numpy
import Support
import vtkoit
from vtkoit.render_passes import TranslucentStage

HAS_PYVISTA = importlib.util.find_spec("pyvista") is not None
ROOT = os.path.dirname(os.path.dirname(sys.path[0]))
EXAMPLES = os.path.join(ROOT, "Examples", "PyVista")
PICTURES = os.path.join(ROOT, "docs", "pictures")
UPDATE = "--update" in sys.argv

# What is switched on, and how far a flat colour may be off by it: the occlusion that EDL and SSAO see at a
# flat square is small, and not none.
MODES = {
    "plain": (lambda plotter: None, 1),
    "no anti-aliasing": (lambda plotter: plotter.disable_anti_aliasing(), 1),
    "msaa": (lambda plotter: plotter.enable_anti_aliasing("msaa"), 1),
    "ssaa": (lambda plotter: plotter.enable_anti_aliasing("ssaa"), 1),
    "fxaa": (lambda plotter: plotter.enable_anti_aliasing("fxaa"), 1),
    "peeling": (lambda plotter: plotter.enable_depth_peeling(), 1),
    "ssao": (lambda plotter: plotter.enable_ssao(kernel_size=32), 2),
    "edl": (lambda plotter: plotter.enable_eye_dome_lighting(), 2),
    "depth of field": (lambda plotter: plotter.enable_depth_of_field(), 1),
    "blur": (lambda plotter: plotter.add_blurring(), 1),
    "ssao and ssaa": (lambda plotter: (plotter.enable_ssao(kernel_size=32), plotter.enable_anti_aliasing("ssaa")), 2),
}


@unittest.skipUnless(HAS_PYVISTA, "needs PyVista (Debian testing: python3-pyvista)")
class PyVistaTest(Support.FolderTest):
    def plotter(self, **options):
        import pyvista

        plotter = pyvista.Plotter(off_screen=True, window_size=[100, 100], **options)
        self.addCleanup(plotter.close)
        return plotter

    @staticmethod
    def add_squares(plotter):
        """In the wrong order: unsorted, and averaged, they have other colours."""
        import pyvista

        for height, color in ((0.5, "red"), (0.0, "lime")):
            plotter.add_mesh(pyvista.Plane(center=(0, 0, height), i_size=9, j_size=9), color=color, opacity=0.5,
                             lighting=False)
        plotter.background_color = "black"
        plotter.view_xy()
        plotter.enable_parallel_projection()
        plotter.camera.parallel_scale = 2

    @staticmethod
    def picture(plotter, **options):
        plotter.show(auto_close=False)
        return plotter.screenshot(None, return_img=True, **options).astype(int)


RIGHT = [127.5, 63.75, 0]


class TestModes(PyVistaTest):
    def check(self, enable):
        """enable: what switches vtkOIT on for a plotter."""
        for name, (switch, tolerance) in MODES.items():
            for is_first in (True, False):
                with self.subTest(name, enabled="first" if is_first else "last"):
                    plotter = self.plotter()
                    if is_first:
                        enable(plotter)
                    self.add_squares(plotter)
                    switch(plotter)
                    if not is_first:
                        enable(plotter)
                    numpy.testing.assert_allclose(self.picture(plotter)[50, 50], RIGHT, atol=tolerance)
                    for each in map(vtkoit.installed, plotter.renderers):
                        self.assertTrue(each.GetExact(), each.GetAlgorithmName())
                    plotter.close()

    def test_component(self):
        self.check(lambda plotter: plotter.oit.enable())

    def test_install(self):
        self.check(vtkoit.install)

    def test_changed_while_it_is_shown(self):
        plotter = self.plotter()
        self.add_squares(plotter)
        plotter.oit.enable()
        for name, (switch, tolerance) in MODES.items():
            if name != "depth of field":  # PyVista refuses it together with SSAO
                switch(plotter)
                numpy.testing.assert_allclose(self.picture(plotter)[50, 50], RIGHT, atol=tolerance, err_msg=name)

    def test_shadows(self):
        # PyVista draws what is opaque once more over the translucent meshes, without vtkOIT, too.
        plotter = self.plotter()
        self.add_squares(plotter)
        plotter.enable_shadows()
        plotter.oit.enable()
        numpy.testing.assert_allclose(self.picture(plotter)[50, 50], RIGHT, atol=1)

    def test_transparent_screenshot(self):
        for samples in (0, 8):
            plotter = self.plotter()
            plotter.render_window.SetMultiSamples(samples)
            self.add_squares(plotter)
            plotter.oit.enable()
            pixel = self.picture(plotter, transparent_background=True)[50, 50]
            numpy.testing.assert_allclose(pixel[3], 191.25, atol=1)
            plotter.close()


class TestComponent(PyVistaTest):
    def test_found_without_an_import(self):
        code = ("import sys, pyvista\nassert 'vtkoit' not in sys.modules\n"
                "plotter = pyvista.Plotter(off_screen=True)\nprint(type(plotter.oit).__module__)")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False,
                              env={**Support.bare_environment(), "PYTHONPATH": os.path.dirname(Support.PACKAGE)})
        self.assertEqual((done.returncode, done.stdout), (0, "vtkoit.pyvista\n"), done.stderr)

    def test_subplots_and_report(self):
        plotter = self.plotter(shape=(2, 2))
        for i in range(4):
            plotter.subplot(i // 2, i % 2)
            self.add_squares(plotter)
            if i == 1:
                plotter.enable_eye_dome_lighting()
        self.assertFalse(plotter.oit.enabled)
        self.assertEqual(plotter.oit.report(), [])
        plotter.oit.enable("abuffer")
        picture = self.picture(plotter)
        # PyVista 0.48 shows the first of these subplots white, without vtkOIT, too.
        for y, x in ((25, 75), (75, 25), (75, 75)):
            numpy.testing.assert_allclose(picture[y, x], RIGHT, atol=2)
        report = plotter.oit.report()
        self.assertEqual([frame.subplot for frame in report], [0, 1, 2, 3])
        for frame in report:
            self.assertTrue(frame.exact)
            self.assertEqual(frame.algorithm, "A-buffer")
            self.assertGreaterEqual(frame.depth_complexity, 2)  # more where samples are kept apart
        self.assertEqual(len(str(report).splitlines()), 5)

    def test_report_of_a_bound(self):
        """Behind three layers of opacity 0.9 comes 0.001 of the light, less than the default threshold."""
        import pyvista

        for threshold, word in ((1 / 512, "0.0010"), (0, "yes")):
            plotter = self.plotter()
            for i in range(6):
                plotter.add_mesh(pyvista.Plane(center=(0, 0, i), i_size=9, j_size=9), opacity=0.9, lighting=False)
            plotter.oit.enable("abuffer", TransmittanceThreshold=threshold)
            self.picture(plotter)
            self.assertEqual(str(plotter.oit.report()).splitlines()[1].split()[1], word)
            plotter.close()

    def test_disable_gives_back(self):
        plotter = self.plotter()
        self.add_squares(plotter)
        before = self.picture(plotter)
        plotter.oit.enable()
        self.assertTrue(plotter.oit.enabled)
        self.assertGreater(abs(self.picture(plotter) - before).max(), 10)
        self.assertTrue(plotter.oit.disable())
        self.assertFalse(plotter.oit.disable())
        numpy.testing.assert_array_equal(self.picture(plotter), before)

    def test_errors(self):
        plotter = self.plotter()
        with self.assertRaisesRegex(ValueError, "^unknown method 'zbuffer'"):
            plotter.oit.enable("zbuffer")
        plotter.close()
        with self.assertRaisesRegex(RuntimeError, "^the plotter is closed"):
            plotter.oit.enable()
        self.assertFalse(plotter.oit.disable())

    def test_nothing_translucent(self):
        import pyvista

        def draw(enable):
            plotter = self.plotter()
            plotter.add_mesh(pyvista.Sphere(), color="tomato")
            if enable:
                plotter.oit.enable()
            return self.picture(plotter)

        numpy.testing.assert_array_equal(draw(True), draw(False))


class TestEverything(PyVistaTest):
    def test_run_without_a_change(self):
        """vtkoit run reaches PyVista's own renderers, in the chains of its modes, too."""
        script = ("import sys; sys.path.insert(0, %r); import TestPyVista\n"
                  "test = TestPyVista.TestModes()\n"
                  "for name, (switch, tolerance) in TestPyVista.MODES.items():\n"
                  "    plotter = test.plotter()\n    test.add_squares(plotter)\n    switch(plotter)\n"
                  "    print(name, *test.picture(plotter)[50, 50], sep=',')\n    plotter.close()\n" % sys.path[0])
        with open(self.path("script.py"), "w", encoding="utf-8") as file:
            file.write(script)
        done = Support.run("run", Support.program("vtkoit-python"), self.path("script.py"))
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.split(",") for line in done.stdout.splitlines()]
        self.assertEqual([row[0] for row in rows], list(MODES))
        for name, *pixel in rows:
            numpy.testing.assert_allclose([int(each) for each in pixel], RIGHT, atol=MODES[name][1], err_msg=name)


class TestExamples(PyVistaTest):
    def test_examples(self):
        for name in sorted(os.listdir(EXAMPLES)):
            with self.subTest(name):
                done = Support.run(os.path.join(EXAMPLES, name), self.path("picture.png"), name="vtkoit-python")
                # VTK 9.6 itself warns of draw buffers in SSAO.
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotRegex(done.stderr, "ERR|vtkOIT")
                self.assertGreater(Support.read_picture(self.path("picture.png")).std(), 10)


class TestPictures(PyVistaTest):
    """Those of docs/pyvista.md. TestPyVista.py --update draws them anew."""

    @staticmethod
    def isosurfaces(plotter):
        import pyvista

        grid = pyvista.ImageData(dimensions=(40, 40, 40), spacing=(0.1, 0.1, 0.1), origin=(-2, -2, -2))
        grid["density"] = sum(numpy.exp(-2 * ((grid.points - center) ** 2).sum(axis=1))
                              for center in ((-0.6, 0, 0), (0.6, 0.3, 0.2), (0, -0.4, 0.7)))
        plotter.add_mesh(grid.contour([0.15, 0.4, 0.65, 0.9, 1.15]), cmap="viridis", opacity=0.4, show_scalar_bar=False)

    @staticmethod
    def spheres(plotter):
        import pyvista

        for i, color in enumerate(["tomato", "mediumseagreen", "royalblue", "gold"]):
            plotter.add_mesh(pyvista.Sphere(radius=1.0 - 0.2 * i, theta_resolution=60, phi_resolution=60), color=color,
                             opacity=0.4)
        plotter.add_mesh(pyvista.Cube(x_length=2.6, y_length=0.5, z_length=0.5), color="gray", opacity=0.6)

    def test_pictures(self):
        from PIL import Image

        for name in ("isosurfaces", "spheres"):
            drawn = []
            for suffix in ("-stock", ""):
                plotter = self.plotter()
                plotter.window_size = [300, 300]
                plotter.background_color = "white"
                getattr(self, name)(plotter)
                if not suffix:
                    plotter.oit.enable()
                drawn.append(self.picture(plotter))
                plotter.close()
                path = os.path.join(PICTURES, "pyvista-%s%s.png" % (name, suffix))
                if UPDATE:
                    Image.fromarray(drawn[-1].astype("uint8")).save(path, optimize=True)
                # Edges may differ by a sample where another Mesa draws them.
                differs = abs(Support.read_picture(path)[:, :, :3].astype(int) - drawn[-1]).max(axis=2) > 3
                self.assertLess(differs.mean(), 0.005, path)
            self.assertGreater(abs(drawn[0] - drawn[1]).max(), 10)


class TestTranslucentStage(unittest.TestCase):
    """The provider for pyvista-render-passes, by its protocol: that package is in no distribution."""

    def test_a_new_pass_each_time(self):
        stage = TranslucentStage()
        self.assertEqual((stage.name, stage.stages), ("vtkoit", ("translucent",)))
        first, second = (stage.build_pass("translucent", None, None, None) for _ in range(2))
        self.assertEqual(first.GetClassName(), "vtkOITAutoPass")
        self.assertIsNot(first, second)
        self.assertIsNone(stage.build_pass("post", None, None, None))
        self.assertIsNone(stage.veto({"msaa": True}))

    def test_state(self):
        stage, asked = TranslucentStage(), []
        stage.bind(lambda: asked.append(1))
        stage.set_state({"method": "abuffer", "properties": {"TransmittanceThreshold": 0.0}})
        self.assertEqual(len(asked), 1)
        built = stage.build_pass("translucent", None, None, None)
        self.assertEqual((built.GetClassName(), built.GetTransmittanceThreshold()), ("vtkOITABufferPass", 0.0))
        other = TranslucentStage()
        other.set_state(json.loads(json.dumps(stage.get_state())))
        self.assertEqual(other.get_state(), stage.get_state())
        other.set_state({"enabled": False})
        self.assertIsNone(other.build_pass("translucent", None, None, None))
        before = stage.get_state()
        for wrong in ({"method": "zbuffer"}, {"properties": {"OcclusionRatio": 2}}, {"peels": 3}):
            with self.assertRaises(ValueError):
                stage.set_state(wrong)
        self.assertEqual(stage.get_state(), before)
        stage.get_state()["properties"]["x"] = 1
        self.assertEqual(stage.get_state(), before)

    def test_entry_points(self):
        points = {(each.group, each.name): each.value for each in importlib.metadata.distribution("vtkoit").entry_points}
        self.assertEqual(points, {
            ("pyvista.plotter_components", "oit"): "vtkoit.pyvista",
            ("pyvista_render_passes.providers", "vtkoit"): "vtkoit.render_passes:TranslucentStage"})


if __name__ == "__main__":
    if UPDATE:
        sys.argv[1:] = ["TestPictures"]
    Support.main()
