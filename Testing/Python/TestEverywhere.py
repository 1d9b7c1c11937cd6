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

    def test_refusals_install_nothing(self):
        for arguments, properties, message in (
                (["zbuffer"], {}, "^unknown method 'zbuffer'"),
                ([], {"TransmittanceThreshold": 2}, "TransmittanceThreshold"),
                ([], {"TransmittanceThreshold": float("nan")}, "^TransmittanceThreshold=nan is refused; give a finite"),
                (["abuffer"], {"MaximumBufferSize": "much"}, "^MaximumBufferSize='much' is refused; give a number"),
                (["abuffer"], {"FragmentPrecision": "float"},
                 r"^install_everywhere\(\) cannot set 'FragmentPrecision'; it sets: MaximumBufferSize, Transm")):
            with self.assertRaisesRegex(ValueError, message):
                vtkoit.install_everywhere(*arguments, **properties)
            self.assertIsNone(vtkoit.installed(vtkRenderer()))

    def test_properties(self):
        defaults = vtkoit.create("abuffer")
        vtkoit.install_everywhere("abuffer", transmittance_threshold=0.25, MaximumBufferSize=2 ** 24)
        renderer = Support.sphere_renderer()
        self.check_properties(renderer, 0.25, 2 ** 24)
        before = vtkoit.installed(renderer)
        vtkoit.install_everywhere("abuffer", TransmittanceThreshold=0)
        self.assertIs(vtkoit.installed(renderer), before)
        self.check_properties(renderer, 0, defaults.GetMaximumBufferSize())
        vtkoit.install_everywhere("peel", TransmittanceThreshold=0.5)
        self.assertEqual(vtkoit.installed(renderer).GetClassName(), "vtkOITDepthPeelingPass")
        self.check_properties(renderer, 0.5, defaults.GetMaximumBufferSize())
        # A refusal leaves what there was.
        with self.assertRaises(ValueError):
            vtkoit.install_everywhere("abuffer", TransmittanceThreshold=-1)
        self.check_properties(renderer, 0.5, defaults.GetMaximumBufferSize())
        vtkoit.install_everywhere("peel")
        self.check_properties(renderer, defaults.GetTransmittanceThreshold(), defaults.GetMaximumBufferSize())

    def test_properties_keep_those_of_install(self):
        renderer = vtkRenderer()
        vtkoit.install(renderer, "abuffer", TransmittanceThreshold=0.125)
        vtkoit.install_everywhere(TransmittanceThreshold=0)
        self.assertEqual(vtkoit.installed(renderer).GetTransmittanceThreshold(), 0.125)

    def test_properties_are_drawn_by(self):
        """The layers have opacity 0.4: behind the first one there is less than 0.9, so no other one need be peeled."""
        passes = {}
        for value in (0, 0.9):
            vtkoit.install_everywhere("peel", TransmittanceThreshold=value)
            renderer = Support.sphere_renderer()
            Support.draw(renderer)
            passes[value] = vtkoit.installed(renderer).GetNumberOfGeometryPasses()
        self.assertLess(passes[0.9], passes[0])

    def check_properties(self, renderer, threshold, size):
        for each in (renderer, vtkRenderer()):
            done = vtkoit.installed(each)
            self.assertEqual((done.GetTransmittanceThreshold(), done.GetMaximumBufferSize()), (threshold, size))


if __name__ == "__main__":
    unittest.main()
