# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""A frame with volumes in which nothing has changed is composited again, and one in which anything has is drawn anew: after
each change the window that is kept shows what a new window shows."""

import unittest

import numpy
import vtkoit
from TestVolumeFeatures import (
    PERSPECTIVE,
    PLANE,
    SIZE,
    binary_mask,
    clipped,
    cropped_to_a_part,
    label_mask,
    make_volume,
    plain,
    shaded,
    smart_mapper,
    transfer_function_2d,
)
from VolumeMarcher import Square
from VolumeScene import actor_of, place
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer
from vtkoit import picture
from vtkoit.windows import make_window

REUSED = "whole frame reused"


class Scene:
    """A window with a volume, a translucent plane in it, and an opaque one."""

    def __init__(self, edit):
        self.volume = make_volume()
        edit(self.volume)
        self.actor = actor_of(PLANE)
        self.opaque = actor_of(Square((0.3, 0, -0.4), (0, 0, 1), 0.3, (1, 1, 1), 1.0), opaque=True)
        self.renderer = vtkRenderer()
        self.instance = vtkoit.install(self.renderer)
        for prop in (self.volume, self.actor, self.opaque):
            self.renderer.AddViewProp(prop)
        place(self.renderer, PERSPECTIVE)
        self.window = make_window(self.renderer, SIZE)

    def draw(self):
        """(picture, whether it was composited again)."""
        self.window.Render()
        return picture.grab(self.window).astype(int), REUSED in self.instance.GetSkipSummary()


def _move_data(scene):
    array = scene.volume.GetMapper().GetInput().GetPointData().GetScalars()
    vtk_to_numpy(array)[:] = vtk_to_numpy(array)[::-1].copy()
    array.Modified()
    scene.volume.GetMapper().GetInput().Modified()


def _move_mask(scene):
    array = scene.volume.GetMapper().GetMaskInput().GetPointData().GetScalars()
    vtk_to_numpy(array)[:] = vtk_to_numpy(array)[::-1].copy()
    array.Modified()
    scene.volume.GetMapper().GetMaskInput().Modified()


def _edit_table(scene):
    image = scene.volume.GetProperty().GetTransferFunction2D()
    vtk_to_numpy(image.GetPointData().GetScalars())[:, 0] *= 0.3
    image.GetPointData().GetScalars().Modified()
    image.Modified()


def _color_a_label(scene):
    """Another function: VTK's mapper does not see changes of the one that it has."""
    blue = vtkColorTransferFunction()
    blue.AddRGBPoint(0, 0, 0, 1)
    scene.volume.GetProperty().SetLabelColor(2, blue)


# Name: (how the volume is made, what changes).
CHANGES = {
    "opacity function": (plain, lambda s: s.volume.GetProperty().GetScalarOpacity().AddPoint(120, 0.7)),
    "colour function": (plain, lambda s: s.volume.GetProperty().GetRGBTransferFunction().AddRGBPoint(120, 0, 1, 0)),
    "unit distance": (plain, lambda s: s.volume.GetProperty().SetScalarOpacityUnitDistance(0.3)),
    "interpolation": (plain, lambda s: s.volume.GetProperty().SetInterpolationTypeToNearest()),
    "shading": (plain, lambda s: s.volume.GetProperty().ShadeOn()),
    "light of shading": (shaded, lambda s: s.volume.GetProperty().SetDiffuse(0.1)),
    "values": (plain, _move_data),
    "values of a smart mapper": (smart_mapper, _move_data),
    "samples": (plain, lambda s: s.volume.GetMapper().SetSampleDistance(0.4)),
    "blend mode of a smart mapper": (smart_mapper, lambda s: s.volume.GetMapper().SetBlendModeToMaximumIntensity()),
    "blend mode": (plain, lambda s: s.volume.GetMapper().SetBlendModeToMaximumIntensity()),
    "cropping": (cropped_to_a_part, lambda s: s.volume.GetMapper().SetCroppingRegionFlagsToCross()),
    "clipping plane": (clipped, lambda s: s.volume.GetMapper().GetClippingPlanes().GetItem(0).SetOrigin(-0.4, 0, 0)),
    "mask": (binary_mask, _move_mask),
    "label": (label_mask, _color_a_label),
    "2-D function": (transfer_function_2d, _edit_table),
    "place": (plain, lambda s: s.volume.SetPosition(0.2, 0.1, 0)),
    "visibility": (plain, lambda s: s.volume.VisibilityOff()),
    "plane": (plain, lambda s: s.actor.GetProperty().SetOpacity(0.9)),
    "camera": (plain, lambda s: s.renderer.GetActiveCamera().Azimuth(3)),
    "opaque depth": (plain, lambda s: s.opaque.SetPosition(-0.4, 0, 0.2)),
    "window": (plain, lambda s: s.window.SetSize(SIZE[0] + 3, SIZE[1])),
}


class TestVolumeReuse(unittest.TestCase):
    def make(self, edit):
        scene = Scene(edit)
        self.addCleanup(scene.window.Finalize)
        return scene

    def test_changes(self):
        for name, (edit, change) in CHANGES.items():
            with self.subTest(name):
                kept = self.make(edit)
                frames = [kept.draw() for _ in range(4)]
                self.assertTrue(frames[-1][1])
                self.assertEqual(kept.instance.GetNumberOfGeometryPasses(), 0)
                self.assertLessEqual(numpy.abs(frames[-1][0] - frames[0][0]).max(), 1)
                change(kept)
                changed, isReused = kept.draw()
                self.assertFalse(isReused)
                new = self.make(edit)
                change(new)
                fresh = new.draw()[0]
                self.assertLessEqual(numpy.abs(changed - fresh).max(), 1)  # drawn as a layer, or at once
                if fresh.shape == frames[0][0].shape:  # and the change is one that is seen
                    self.assertGreater(numpy.abs(fresh - frames[0][0]).max(), 5)
                last = [kept.draw() for _ in range(3)][-1]
                self.assertTrue(last[1])
                self.assertLessEqual(numpy.abs(last[0] - fresh).max(), 1)

    def test_never_where_changes_may_go_unseen(self):
        def replace(scene):
            scene.volume.GetShaderProperty().AddFragmentShaderReplacement(
                "//VTK::Base::Dec", True, "//VTK::Base::Dec\n#define UNUSED 1\n", False)

        def adjust(scene):
            scene.volume.GetMapper().SetAutoAdjustSampleDistances(True)
            scene.window.SetDesiredUpdateRate(10.0)

        for edit in (replace, adjust):
            scene = self.make(plain)
            edit(scene)
            self.assertFalse(any(scene.draw()[1] for _ in range(4)), edit.__name__)

    def test_nothing_is_made(self):
        """Asked for its gradient opacity, a vtkVolumeProperty makes one, with which frames take three times as long."""
        scene = self.make(plain)
        for _ in range(3):
            scene.draw()
        self.assertFalse(scene.volume.GetProperty().HasGradientOpacity())

    def test_switch(self):
        scene = self.make(plain)
        scene.instance.ReuseFramesOff()
        self.assertFalse(any(scene.draw()[1] for _ in range(4)))


if __name__ == "__main__":
    unittest.main()
