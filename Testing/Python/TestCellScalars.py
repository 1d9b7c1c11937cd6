# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Colours of cells, and cells that a selector finds: shaders read both by gl_PrimitiveID, which
drivers have got wrong in fragment shaders that write more than a colour."""

import unittest

import numpy
import Support
import vtkoit
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkHardwareSelector, vtkPolyDataMapper
from vtkoit.picture import grab
from vtkoit.windows import make_window

CELLS = 6  # a side
PIXELS = 5  # of a cell
BACKGROUND = (0.2, 0.4, 0.6)
OPACITIES = ((0.5, 100), (0.0, 150), (-0.5, 200))  # z, of 255
# Where a window blends, source, factor and result are each rounded by up to half a step; then the
# picture is.
STEPS = 2.0


def add_cells(renderer, z, opacity, random):
    """A square of cells, each of another colour; the colours, rows from below."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-1, -1, z)
    plane.SetPoint1(1, -1, z)
    plane.SetPoint2(-1, 1, z)
    plane.SetResolution(CELLS, CELLS)
    plane.Update()
    colors = random.integers(0, 256, (CELLS, CELLS, 3))
    scalars = vtkUnsignedCharArray()
    scalars.SetNumberOfComponents(4)
    for color in colors.reshape(-1, 3):
        scalars.InsertNextTuple4(*(int(value) for value in color), opacity)
    plane.GetOutput().GetCellData().SetScalars(scalars)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(plane.GetOutput())
    mapper.SetScalarModeToUseCellData()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.ForceTranslucentOn()
    renderer.AddActor(actor)
    return colors / 255.0


def selected_cells(renderer, side):
    selector = vtkHardwareSelector()
    selector.SetRenderer(renderer)
    selector.SetArea(0, 0, side - 1, side - 1)
    selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_CELLS)
    selection = selector.Select()
    found = set()
    for i in range(selection.GetNumberOfNodes()):
        names = selection.GetNode(i).GetSelectionList()
        found |= {int(names.GetTuple1(k)) for k in range(names.GetNumberOfTuples())}
    return found


class TestCellScalars(unittest.TestCase):
    def test_every_exact_method(self):
        side = CELLS * PIXELS
        for method in vtkoit.methods():
            if method.startswith("weighted"):
                continue
            with self.subTest(method):
                random = numpy.random.default_rng(3)
                renderer = Support.quad_renderer(BACKGROUND)
                renderer.GetActiveCamera().SetParallelScale(1.0)
                colors = [add_cells(renderer, z, opacity, random) for z, opacity in OPACITIES]
                instance = vtkoit.install(renderer, method, TransmittanceThreshold=0.0)
                window = make_window(renderer, (side, side))
                window.Render()
                window.Render()
                pixels = grab(window)[::-1]
                truth = numpy.array([
                    [Support.compose([layer[y, x] for layer in colors],
                                     [opacity / 255 for _, opacity in OPACITIES], (*BACKGROUND, 1))
                     for x in range(CELLS)] for y in range(CELLS)])
                truth = truth.repeat(PIXELS, 0).repeat(PIXELS, 1)
                self.assertLessEqual(abs(pixels - 255 * truth).max(), STEPS)
                self.assertTrue(instance.GetExact())
                self.assertEqual(selected_cells(renderer, side), set(range(CELLS * CELLS)))
                window.Finalize()


if __name__ == "__main__":
    unittest.main()
