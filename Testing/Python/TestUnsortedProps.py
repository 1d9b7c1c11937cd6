# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Props of VTK that are made of parts, between two planes: the one in front tints them, and the one
behind is seen through them. An annotated cube lists its parts, which are sorted. Representations of
widgets are blended as a whole, in their place."""

import unittest

import numpy
import Support
import vtkoit
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkRegularPolygonSource
from vtkmodules.vtkInteractionWidgets import vtkBoxRepresentation, vtkSphereRepresentation
from vtkmodules.vtkRenderingAnnotation import vtkAnnotatedCubeActor
from vtkmodules.vtkRenderingCore import vtkActor2D, vtkPolyDataMapper2D
from vtkoit.errors import capture
from vtkoit.picture import grab
from vtkoit.windows import make_window

SIZE = 48
BACKGROUND = (0.2, 0.4, 0.6)
RED = (1.0, 0.0, 0.0)
PLANES = ((0.75, (0.0, 1.0, 0.0)), (-0.75, (0.0, 0.0, 1.0)))  # z, colour; opacity .5
# Where a window blends, source, factor and result of each layer are rounded to a step of 255; each later
# layer of opacity .5 halves what there was.
STEPS = 3.0


def dress(look):
    look.SetColor(*RED)
    look.SetOpacity(0.5)
    look.LightingOff()
    look.SetRepresentationToSurface()


def cube(_renderer):
    prop = vtkAnnotatedCubeActor()
    dress(prop.GetCubeProperty())
    prop.SetTextEdgesVisibility(0)
    prop.SetFaceTextVisibility(0)
    return prop


def box(renderer):
    """One of its faces, at z = .2: it says that it has nothing translucent."""
    prop = vtkBoxRepresentation()
    prop.SetRenderer(renderer)
    prop.SetPlaceFactor(1.0)
    prop.PlaceWidget((-0.5, 0.5, -0.5, 0.5, -0.2, 0.2))
    prop.HandlesOff()
    dress(prop.GetFaceProperty())
    dress(prop.GetSelectedFaceProperty())
    prop.VisibilityOn()
    prop.SetInteractionState(vtkBoxRepresentation.MoveF5)
    return prop


def sphere(renderer):
    """Both of its sides: it does not hand on its keys."""
    prop = vtkSphereRepresentation()
    prop.SetRenderer(renderer)
    prop.PlaceWidget((-0.5, 0.5, -0.5, 0.5, -0.5, 0.5))
    prop.SetRepresentationToSurface()
    dress(prop.GetSphereProperty())
    return prop


# Layers of the prop, whether they are sorted with each VTK.
PROPS = ((cube, 2, True), (box, 1, False), (sphere, 2, False))
METHODS = ("auto", "abuffer", "peel", "dual", "multilayer", "bucket")


def make_scene(make_prop, from_behind):
    renderer = Support.quad_renderer(BACKGROUND)
    if from_behind:
        renderer.GetActiveCamera().SetPosition(0.0, 0.0, -5.0)
    for z, color in PLANES:
        plane = vtkPlaneSource()
        plane.SetOrigin(-2.0, -2.0, z)
        plane.SetPoint1(2.0, -2.0, z)
        plane.SetPoint2(-2.0, 2.0, z)
        Support.add_actor(renderer, plane, color, 0.5, lighting=False)
    prop = make_prop(renderer)
    if hasattr(prop, "BuildRepresentation"):
        prop.BuildRepresentation()
    renderer.AddViewProp(prop)
    return renderer


def blend(layers, from_behind):
    """The colour of a pixel, in steps of 255."""
    colors = [PLANES[0][1], *[RED] * layers, PLANES[1][1]]
    color = numpy.array(BACKGROUND)
    for over in colors if from_behind else reversed(colors):
        color = 0.5 * (color + numpy.array(over))
    return 255.0 * color


class TestUnsortedProps(unittest.TestCase):
    def test_between_two_planes(self):
        for make_prop, layers, is_sorted in PROPS:
            for method in METHODS:
                for from_behind in (False, True):
                    with self.subTest(prop=make_prop.__name__, method=method, from_behind=from_behind):
                        self.draw(make_prop, layers, is_sorted, method, from_behind)

    def test_what_lies_over_the_picture_is_no_layer(self):
        """A vtkActor2D draws with the overlays, and says otherwise."""
        for method in METHODS:
            with self.subTest(method=method):
                renderer = make_scene(cube, False)
                window = make_window(renderer, (SIZE, SIZE), 0)
                chosen = vtkoit.install(renderer, method)
                window.Render()
                without = grab(window)
                frame = vtkRegularPolygonSource()
                frame.SetCenter(8.0, 8.0, 0.0)
                frame.SetRadius(4.0)
                mapper = vtkPolyDataMapper2D()
                mapper.SetInputConnection(frame.GetOutputPort())
                over = vtkActor2D()
                over.SetMapper(mapper)
                renderer.AddViewProp(over)
                with capture() as captured:
                    for _ in range(2):
                        window.Render()
                        self.assertTrue(chosen.GetExact())
                self.assertEqual(captured.lines(), [])
                picture = grab(window)
                self.assertEqual(picture[-9, 8].tolist()[:3], [255, 255, 255])
                self.assertEqual(picture[:-16, 16:].tolist(), without[:-16, 16:].tolist())
                window.Finalize()

    def draw(self, make_prop, layers, is_sorted, method, from_behind):
        renderer = make_scene(make_prop, from_behind)
        window = make_window(renderer, (SIZE, SIZE), 0)
        chosen = vtkoit.install(renderer, method)
        lines = []
        for _ in range(3):
            with capture() as captured:
                window.Render()
                picture = grab(window).astype(float)
            lines += captured.lines()
            # Beside what is opaque of them, and beside them.
            for at, count in ((SIZE // 2 + 4, layers), (2, 0)):
                difference = picture[at, at, :3] - blend(count, from_behind)
                self.assertLess(numpy.abs(difference).max(), STEPS, (at, picture[at, at]))
            self.assertEqual(bool(chosen.GetExact()), not lines, lines)
        self.assertLessEqual(len(lines), 0 if is_sorted else 1, lines)
        window.Finalize()


if __name__ == "__main__":
    unittest.main()
