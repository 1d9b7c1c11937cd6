# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""install() for windows, plotters and views, and install_everywhere()."""

import unittest

import numpy
import Support
import vtkoit
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLRenderer


class OwnRenderer(vtkOpenGLRenderer):
    """As an application derives it: not made by VTK's factories."""


class Plotter:
    """What is asked of a plotter of PyVista."""

    def __init__(self, window):
        self.render_window = window


class View:
    """What is asked of a view's proxy in ParaView."""

    def __init__(self, renderer):
        self._renderer = renderer

    def GetClientSideObject(self):  # pylint: disable=invalid-name
        return self

    def GetRenderer(self):  # pylint: disable=invalid-name
        return self._renderer


def stock_and_right():
    """The pictures of Support.sphere_renderer() by VTK, and by vtkOIT."""
    stock = Support.draw(Support.sphere_renderer())
    renderer = Support.sphere_renderer()
    vtkoit.install(renderer)
    return stock, Support.draw(renderer)


class TestWindow(unittest.TestCase):
    def check(self, where, window):
        """where: what install() is called for, which has the window."""
        stock, right = stock_and_right()
        self.assertGreater(abs(stock.astype(int) - right).max(), 10)
        first, later = vtkRenderer(), OwnRenderer()
        window.AddRenderer(first)
        passes = vtkoit.install(where, "abuffer", MaximumBufferSize=2 ** 24)
        self.assertEqual([each.GetClassName() for each in passes], ["vtkOITABufferPass"])
        self.assertIs(vtkoit.installed(first), passes[0])
        self.assertEqual(vtkoit.installed(where), passes)
        window.RemoveRenderer(first)
        for actor in Support.sphere_renderer().GetActors():
            later.AddActor(actor)
        later.SetBackground(1, 1, 1)
        later.ResetCamera()
        numpy.testing.assert_array_equal(self.draw(window, later), right)
        self.assertTrue(vtkoit.installed(later).GetExact())
        self.assertEqual(vtkoit.installed(later).GetMaximumBufferSize(), 2 ** 24)
        self.assertEqual(vtkoit.install(where)[0].GetClassName(), "vtkOITAutoPass")
        numpy.testing.assert_array_equal(self.draw(window, later), right)
        self.assertTrue(vtkoit.uninstall(where))
        self.assertFalse(vtkoit.uninstall(where))
        self.assertEqual(vtkoit.installed(where), [])
        numpy.testing.assert_array_equal(self.draw(window, later), stock)

    @staticmethod
    def draw(window, renderer):
        from vtkoit import picture

        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetAlphaBitPlanes(True)
        window.SetSize(120, 100)
        window.AddRenderer(renderer)
        window.Render()
        return picture.grab(window)

    def test_window(self):
        window = vtkRenderWindow()
        self.check(window, window)

    def test_plotter(self):
        window = vtkRenderWindow()
        self.check(Plotter(window), window)

    def test_view(self):
        renderer = vtkRenderer()
        installed = vtkoit.install(View(renderer), "peel")
        self.assertIs(vtkoit.installed(renderer), installed)
        self.assertTrue(vtkoit.uninstall(View(renderer)))
        self.assertIsNone(vtkoit.installed(renderer))

    def test_refusal_installs_nothing(self):
        window = vtkRenderWindow()
        renderer = vtkRenderer()
        window.AddRenderer(renderer)
        for wrong in ({"method": "zbuffer"}, {"OcclusionRatio": 2}):
            with self.assertRaises(ValueError):
                vtkoit.install(window, **wrong)
        self.assertEqual(vtkoit.installed(window), [])
        with self.assertRaisesRegex(TypeError, "^a vtkRenderer, a vtkRenderWindow, a plotter or a render view"):
            vtkoit.install(Plotter(None))


class TestEverywhere(unittest.TestCase):
    def setUp(self):
        self.addCleanup(vtkoit.uninstall_everywhere)

    def test_all_renderers_from_now_on(self):
        stock, right = stock_and_right()
        before = vtkRenderer()
        vtkoit.install_everywhere("abuffer")
        renderer = Support.sphere_renderer()
        self.assertEqual(vtkoit.installed(renderer).GetClassName(), "vtkOITABufferPass")
        self.assertIsNone(vtkoit.installed(before))
        numpy.testing.assert_array_equal(Support.draw(renderer), right)
        own = OwnRenderer()
        for actor in Support.sphere_renderer().GetActors():
            own.AddActor(actor)
        own.SetBackground(1, 1, 1)
        own.ResetCamera()
        numpy.testing.assert_array_equal(Support.draw(own), right)
        self.assertFalse(own.GetUseDepthPeeling())
        self.assertTrue(vtkoit.uninstall_everywhere())
        self.assertFalse(vtkoit.uninstall_everywhere())
        numpy.testing.assert_array_equal(Support.draw(renderer), stock)
        self.assertIsNone(vtkoit.installed(renderer))

    def test_what_the_application_does_with_peeling(self):
        _, right = stock_and_right()
        vtkoit.install_everywhere()
        renderer = Support.sphere_renderer()
        for switch in (renderer.UseDepthPeelingOn, renderer.UseDepthPeelingOff):
            switch()
            numpy.testing.assert_array_equal(Support.draw(renderer), right)
            self.assertEqual(renderer.GetUseDepthPeeling(), switch == renderer.UseDepthPeelingOn)

    def test_respected(self):
        stock, right = stock_and_right()
        vtkoit.install_everywhere(respect_depth_peeling=True)
        renderer = Support.sphere_renderer()
        numpy.testing.assert_array_equal(Support.draw(renderer), stock)
        renderer.UseDepthPeelingOn()
        numpy.testing.assert_array_equal(Support.draw(renderer), right)

    def test_unknown_method(self):
        with self.assertRaisesRegex(ValueError, "^unknown method 'zbuffer'"):
            vtkoit.install_everywhere("zbuffer")
        self.assertIsNone(vtkoit.installed(vtkRenderer()))


if __name__ == "__main__":
    unittest.main()
