# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Render views of ParaView with the plugin: reached, switched, given back, and what they draw. Run by pvpython."""

import numpy
import Views
from Views import simple

METHODS = {"Automatic": "vtkOITAutoPass", "A-buffer": "vtkOITABufferPass", "Depth peeling": "vtkOITDepthPeelingPass",
           "Dual depth peeling": "vtkOITDualDepthPeelingPass", "Multi-layer peeling": "vtkOITMultiLayerPeelingPass",
           "Bucket peeling": "vtkOITBucketPeelingPass", "Bucket peeling, pairs": "vtkOITBucketPeelingPass",
           "Bucket peeling, adaptive": "vtkOITBucketPeelingPass"}


class TestViews(Views.ViewTest):
    """In this order: the plugin is loaded once in a process."""

    def setUp(self):
        super().setUp()
        if Views.page():
            Views.page().Method = "Automatic"

    def check_right(self, view, what="", tolerance=1.0):
        picture = self.picture(view)
        middle = picture[Views.SIZE[1] // 2, Views.SIZE[0] // 2]
        numpy.testing.assert_allclose(middle, Views.expected([0, 0, 0, 255])[:3], atol=tolerance, err_msg=what)

    def directly(self, view, method="auto"):
        """The picture that a pass draws that was put into the view's renderer by hand."""
        import vtkoit

        Views.page().Method = "Off"
        done = vtkoit.install(view, method)
        try:
            picture = self.picture(view)
            self.assertGreater(done.GetNumberOfGeometryPasses(), 0)
            self.assertTrue(done.GetExact() or done.GetErrorBound() < 0.002)
        finally:
            vtkoit.uninstall(view)
            Views.page().Method = "Automatic"
        return picture

    def test_00_view_from_before(self):
        view = self.make_view()
        self.show_stack(view)
        stock = self.picture(view)
        middle = stock[Views.SIZE[1] // 2, Views.SIZE[0] // 2]
        self.assertGreater(abs(middle - Views.expected([0, 0, 0, 255])[:3]).max(), 10, "stock is right: a weak test")
        self.assertIsNone(Views.page())

        Views.load_plugin()
        self.assertIsNotNone(Views.page())
        self.check_right(view)

        Views.page().Method = "Off"
        numpy.testing.assert_array_equal(self.picture(view), stock)
        Views.page().Method = "Automatic"
        self.check_right(view, "on again")
        view.GetClientSideObject().GetRenderer().UseDepthPeelingOff()
        self.assertGreater(abs(self.picture(view) - stock).max(), 10, "drawn, though peeling is off")

    def test_methods(self):
        import vtkoit

        view = self.make_view()
        self.show_stack(view)
        for method, name in METHODS.items():
            with self.subTest(method):
                Views.page().Method = method
                self.check_right(view, method, 2.0)
                done = vtkoit.installed(view)
                self.assertEqual(done.GetClassName(), name)
                self.assertGreater(done.GetNumberOfGeometryPasses(), 0)

    def test_advanced(self):
        import vtkoit

        view = self.make_view()
        self.show_stack(view)
        self.assertEqual(Views.page().BufferLimit, 0)
        self.assertEqual(Views.page().TransmittanceThreshold, 1 / 512)
        Views.page().BufferLimit = 64
        Views.page().TransmittanceThreshold = 0.125
        self.assertEqual(vtkoit.installed(view).GetMaximumBufferSize(), 64 * 2 ** 20)
        self.assertEqual(vtkoit.installed(view).GetTransmittanceThreshold(), 0.125)
        Views.page().BufferLimit = 0
        Views.page().TransmittanceThreshold = 1 / 512
        self.check_right(view)

    def test_depth_peeling_is_the_switch(self):
        view = self.make_view()
        self.show_stack(view)
        right = self.picture(view)
        self.check_right(view)
        settings = simple.GetSettingsProxy("RenderViewSettings")
        self.addCleanup(setattr, settings, "DepthPeeling", 1)
        settings.DepthPeeling = 0
        self.assertEqual(view.GetClientSideObject().GetRenderer().GetUseDepthPeeling(), 0)
        unsorted = self.picture(view)
        self.assertGreater(abs(unsorted - right).max(), 10)
        Views.page().Method = "Off"
        numpy.testing.assert_array_equal(self.picture(view), unsorted)
        Views.page().Method = "Automatic"
        settings.DepthPeeling = 1
        numpy.testing.assert_array_equal(self.picture(view), right)

    def test_scene_as_drawn_directly(self):
        view = self.make_view()
        self.show_scene(view)
        picture = self.picture(view)
        numpy.testing.assert_array_equal(self.directly(view), picture)
        Views.page().Method = "Off"
        self.assertGreater(abs(self.picture(view) - picture).max(), 10)

    def test_volume_as_drawn_directly(self):
        view = self.make_view()
        source = self.show_scene(view)
        shown = simple.Show(source.Input, view, "UniformGridRepresentation")
        shown.SetRepresentationType("Volume")
        simple.ColorBy(shown, ("POINTS", "RTData"))
        picture = self.picture(view)
        numpy.testing.assert_array_equal(self.directly(view), picture)

    def test_passes_around(self):
        """With FXAA ParaView puts another pass around; the middle of a square stays as it is."""
        view = self.make_view()
        self.show_stack(view)
        view.UseFXAA = 1
        self.check_right(view)

    def test_transparent_background(self):
        view = self.make_view(Background=[1, 1, 1])
        self.show_stack(view)
        picture = self.picture(view, TransparentBackground=1)
        self.assertEqual(picture.shape[2], 4)
        middle = picture[Views.SIZE[1] // 2, Views.SIZE[0] // 2]
        right = Views.expected([0, 0, 0, 0])
        # PNG wants colours that are not multiplied by the opacity.
        numpy.testing.assert_allclose(middle, [*(right[:3] * 255 / right[3]), right[3]], atol=1.5)

    def test_selection(self):
        view = self.make_view()
        source = self.show_scene(view)
        counts = []
        for method in ("Automatic", "Off"):
            Views.page().Method = method
            simple.Render(view)
            simple.SelectSurfaceCells(Rectangle=[40, 30, 80, 60], View=view)
            extracted = simple.ExtractSelection(Input=source)
            extracted.UpdatePipeline()
            counts.append(extracted.GetDataInformation().GetNumberOfCells())
            simple.Delete(extracted)
        self.assertGreater(counts[0], 10)
        self.assertEqual(counts[0], counts[1])
        Views.page().Method = "Automatic"
        selected = self.picture(view)
        numpy.testing.assert_array_equal(self.directly(view), selected)
        simple.ClearSelection(source)
        unselected = self.picture(view)
        self.assertGreater(abs(selected - unselected).max(), 10)
        numpy.testing.assert_array_equal(self.directly(view), unselected)

    def test_animation(self):
        view = self.make_view()
        contours = self.show_scene(view)
        scene = simple.GetAnimationScene()
        scene.PlayMode = "Sequence"
        scene.NumberOfFrames = 3
        track = simple.GetAnimationTrack("ContourValues", 0, contours)
        self.addCleanup(simple.Delete, track)
        track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=0, KeyValues=[90]),
                           simple.CompositeKeyFrame(KeyTime=1, KeyValues=[160])]
        self.addCleanup(scene.GoToFirst)
        simple.SaveAnimation(self.path("frame.png"), view, ImageResolution=Views.SIZE, FrameWindow=[0, 2])
        frames = [Views.read_picture(self.path("frame.%04d.png" % i)) for i in range(3)]
        self.assertGreater(abs(frames[2] - frames[0]).max(), 10)
        scene.GoToFirst()
        for i, frame in enumerate(frames):
            numpy.testing.assert_array_equal(self.directly(view), frame, "frame %d" % i)
            scene.GoToNext()

    def test_two_views(self):
        views = [self.make_view(), self.make_view()]
        for view in views:
            self.show_stack(view)
        for view in views:
            self.check_right(view)


if __name__ == "__main__":
    Views.main()
