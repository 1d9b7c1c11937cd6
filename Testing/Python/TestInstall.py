# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""install(), uninstall(), methods, properties, and the three ways to switch a pass on."""

import unittest
import unittest.mock

import numpy
import Support
import vtkoit
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkRenderingCore import vtkRenderer
from vtkoit.lookup import render_pass

# Found in whichever module this VTK has them.
vtkCameraPass, vtkLightsPass, vtkOpaquePass, vtkRenderPassCollection, vtkRenderStepsPass, vtkSequencePass = map(
    render_pass, ("vtkCameraPass", "vtkLightsPass", "vtkOpaquePass", "vtkRenderPassCollection", "vtkRenderStepsPass",
                  "vtkSequencePass"))


class TestInstall(unittest.TestCase):
    def test_returns_the_pass_and_draws_exactly(self):
        renderer = Support.quad_renderer()
        # Drawn in the wrong order: unsorted blending would give another colour.
        Support.add_quad(renderer, 0.5, (1, 0, 0), 0.5)
        Support.add_quad(renderer, 0.0, (0, 1, 0), 0.5)
        instance = vtkoit.install(renderer)
        self.assertIs(vtkoit.installed(renderer), instance)
        self.assertEqual(instance.GetClassName(), "vtkOITAutoPass")
        pixel = Support.draw(renderer, (100, 100))[50, 50]
        numpy.testing.assert_allclose(pixel, [127.5, 63.75, 0, 255], atol=1.0)
        self.assertTrue(instance.GetExact())
        self.assertEqual(instance.GetSkipSummary(), "2 of 2 props blended: their order is known")

        instance = vtkoit.install(renderer, "abuffer")
        self.assertEqual(instance.GetClassName(), "vtkOITABufferPass")
        pixel = Support.draw(renderer, (100, 100))[50, 50]
        numpy.testing.assert_allclose(pixel, [127.5, 63.75, 0, 255], atol=1.0)
        self.assertTrue(instance.GetExact())
        self.assertEqual(instance.GetMaximumDepthComplexity(), 2)
        self.assertEqual(instance.GetNumberOfFragments(), 2 * 100 * 100)

    def test_uninstall_gives_back_what_was_there(self):
        for peeling in (False, True):
            renderer = Support.sphere_renderer()
            renderer.SetUseDepthPeeling(peeling)
            renderer.SetMaximumNumberOfPeels(100)
            before = Support.draw(renderer)
            vtkoit.install(renderer)
            Support.draw(renderer)
            self.assertTrue(vtkoit.uninstall(renderer))
            self.assertEqual(bool(renderer.GetUseDepthPeeling()), peeling)
            self.assertIsNone(vtkoit.installed(renderer))
            numpy.testing.assert_array_equal(Support.draw(renderer), before)

    def test_uninstall_of_nothing_is_false(self):
        self.assertFalse(vtkoit.uninstall(vtkRenderer()))

    def test_install_twice_replaces(self):
        renderer = vtkRenderer()
        vtkoit.install(renderer)
        second = vtkoit.install(renderer)
        self.assertIs(vtkoit.installed(renderer), second)
        self.assertTrue(vtkoit.uninstall(renderer))
        self.assertFalse(vtkoit.uninstall(renderer))

    def test_something_else_than_a_renderer(self):
        for wrong in (None, 3, "renderer", vtkObject()):
            with self.assertRaisesRegex(TypeError, "^a vtkRenderer, a vtkRenderWindow, a plotter or a render view is needed"):
                vtkoit.install(wrong)
            with self.assertRaises(TypeError):
                vtkoit.uninstall(wrong)

    def test_three_ways_give_the_same_picture(self):
        renderer = Support.sphere_renderer()
        vtkoit.install(renderer)
        installed = Support.draw(renderer)
        vtkoit.uninstall(renderer)
        self.assertGreater(installed.std(), 10.0)

        steps = vtkRenderStepsPass()
        steps.SetTranslucentPass(vtkoit.create("abuffer"))
        renderer.SetPass(steps)
        numpy.testing.assert_array_equal(Support.draw(renderer), installed)

        passes = vtkRenderPassCollection()
        for item in (vtkLightsPass(), vtkOpaquePass(), vtkoit.create("abuffer")):
            passes.AddItem(item)
        sequence = vtkSequencePass()
        sequence.SetPasses(passes)
        camera = vtkCameraPass()
        camera.SetDelegatePass(sequence)
        renderer.SetPass(camera)
        numpy.testing.assert_array_equal(Support.draw(renderer), installed)


class TestMethods(unittest.TestCase):
    def test_names(self):
        self.assertIn("abuffer", vtkoit.methods())
        self.assertEqual(len(set(vtkoit.methods())), len(vtkoit.methods()))

    def test_each_can_be_created_and_tells_its_name(self):
        for name in vtkoit.methods():
            self.assertTrue(vtkoit.create(name).GetAlgorithmName())

    def test_info(self):
        infos = vtkoit.method_info()
        self.assertEqual([info.name for info in infos], vtkoit.methods())
        for info in infos:
            self.assertNotIn("\n", info.missing)
        self.assertEqual(infos[0].class_name, "vtkOITAutoPass")
        self.assertEqual(infos[0].missing, "")

    def test_unknown(self):
        with self.assertRaises(ValueError) as caught:
            vtkoit.install(vtkRenderer(), method="zbuffer")
        self.assertEqual(str(caught.exception), "unknown method 'zbuffer'; the methods are: %s"
                         % ", ".join(vtkoit.methods()))


class TestProperties(unittest.TestCase):
    def test_defaults(self):
        found = vtkoit.properties("abuffer")
        self.assertNotIn("VolumetricPass", found)  # not a number, nor a name
        self.assertEqual(found["FragmentPrecision"], "half")
        self.assertEqual(found["MaximumBufferSize"], 0)
        self.assertEqual(found["OcclusionRatio"], 0.0)
        self.assertNotIn("ActiveDrawBuffers", found)

    def test_values(self):
        instance = vtkoit.create(FragmentPrecision="float", MaximumBufferSize=2 ** 32)
        self.assertEqual(instance.GetFragmentPrecision(), instance.FLOAT)
        self.assertEqual(instance.GetMaximumBufferSize(), 2 ** 32)
        instance = vtkoit.create(fragment_precision="Float", maximumbuffersize="1048576")
        self.assertEqual(instance.GetFragmentPrecision(), instance.FLOAT)
        self.assertEqual(instance.GetMaximumBufferSize(), 2 ** 20)
        self.assertEqual(vtkoit.create(OcclusionRatio=0.25).GetOcclusionRatio(), 0.25)

    def test_named_values_of_other_methods(self):
        instance = vtkoit.create("multilayer", Synchronization="texture_barrier",
                                 NumberOfLayersPerPass="4", UseOcclusionQuery="0")
        self.assertEqual(instance.GetSynchronization(), instance.TEXTURE_BARRIER)
        self.assertEqual(instance.GetNumberOfLayersPerPass(), 4)
        self.assertFalse(instance.GetUseOcclusionQuery())
        for mode in ("average", "sum", "blended"):
            self.assertEqual(vtkoit.properties("weighted-" + mode)["Mode"], mode)
        with self.assertRaisesRegex(ValueError, "^NumberOfLayersPerPass 5 is refused; give 4, 8"):
            vtkoit.create("multilayer", NumberOfLayersPerPass=5)

    def refused(self, text, **values):
        with self.assertRaises(ValueError) as caught:
            vtkoit.create("abuffer", **values)
        self.assertNotIn("\n", str(caught.exception))
        self.assertIn(text, str(caught.exception))

    def test_refusals(self):
        self.refused("no property 'Fragments'; it has: CoincidentLayers, FragmentPrecision, MaximumBufferSize",
                     Fragments=3)
        self.refused("give one of float, half", FragmentPrecision="double")
        self.refused("give HALF or FLOAT", FragmentPrecision=7)
        self.refused("at least 1048576 bytes", MaximumBufferSize=1000)
        self.refused("refused", MaximumBufferSize=None)
        self.refused("give a number from 0 to 0.5", OcclusionRatio=0.75)
        self.refused("refused", OcclusionRatio="much")
        self.refused("refused", TranslucentPass=3)

    def test_refusal_installs_nothing(self):
        renderer = vtkRenderer()
        with self.assertRaises(ValueError):
            vtkoit.install(renderer, OcclusionRatio=2)
        self.assertIsNone(vtkoit.installed(renderer))

    def test_limit_is_kept_and_exact(self):
        renderer = Support.sphere_renderer()
        vtkoit.install(renderer)
        free = Support.draw(renderer, (400, 300))
        limited = vtkoit.install(renderer, MaximumBufferSize=2 ** 20)
        numpy.testing.assert_array_equal(Support.draw(renderer, (400, 300)), free)
        self.assertTrue(limited.GetExact())
        self.assertGreater(limited.GetNumberOfGeometryPasses(), 1)


class TestNames(unittest.TestCase):
    def test_a_class_is_found_in_either_module(self):
        from vtkmodules import vtkRenderingCore, vtkRenderingOpenGL2

        self.assertIs(render_pass("vtkDualDepthPeelingPass"), vtkRenderingOpenGL2.vtkDualDepthPeelingPass)
        self.assertIs(render_pass("vtkRenderPass"), vtkRenderingCore.vtkRenderPass)
        # As in VTK's master.
        with unittest.mock.patch.object(vtkRenderingCore, "vtkTranslucentPass", vtkRenderer, create=True):
            self.assertIs(render_pass("vtkTranslucentPass"), vtkRenderer)
        with self.assertRaisesRegex(ImportError, "VTK has no vtkNonePass in vtkRenderingCore or vtkRenderingOpenGL2"):
            render_pass("vtkNonePass")


if __name__ == "__main__":
    unittest.main()
