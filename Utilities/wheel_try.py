# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws two crossing squares by the package that is installed, and checks the pixels on both sides of where they cross."""

import sys

import numpy
import vtkoit
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
from vtkoit import picture
from vtkoit.windows import make_window


def main(path):
    renderer = vtkRenderer()
    square = vtkPlaneSource()
    for color, turn in (((1, 0, 0), 40), ((0, 0, 1), -40)):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(square.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.RotateY(turn)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().SetOpacity(0.5)
        actor.GetProperty().SetLighting(False)
        renderer.AddActor(actor)
    instance = vtkoit.install(renderer)
    window = make_window(renderer, (80, 80))
    renderer.ResetCamera()
    window.Render()
    pixels = picture.grab(window)
    picture.save(pixels, path)
    # The red one is nearer on the left. On each side the nearer one has half of the light, the other one a quarter.
    for place, expected in ((pixels[40, 30], (128, 0, 64)), (pixels[40, 50], (64, 0, 128))):
        if numpy.abs(place[:3].astype(int) - expected).max() > 1 or not instance.GetExact():
            sys.exit("%s: wrong colours: %s, expected %s" % (path, place[:3], expected))
    print("%s: right, by %s" % (path, instance.GetAlgorithmName()))


if __name__ == "__main__":
    main(sys.argv[1])
