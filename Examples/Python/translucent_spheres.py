# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The smallest script: three translucent spheres inside each other, drawn without a display.

    build/bin/vtkoit-python Examples/Python/translucent_spheres.py FILE.png
"""

import sys

import vtkoit
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

if len(sys.argv) != 2:
    sys.exit("usage: translucent_spheres.py FILE.png")

renderer = vtkRenderer()
renderer.SetBackground(1, 1, 1)
for i, color in enumerate([(0.8, 0.2, 0.2), (0.2, 0.7, 0.3), (0.2, 0.3, 0.9)]):
    sphere = vtkSphereSource()
    sphere.SetRadius(1 + 0.5 * i)
    sphere.SetCenter(0.4 * i, 0, 0)
    sphere.SetThetaResolution(64)
    sphere.SetPhiResolution(64)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetOpacity(0.4)
    renderer.AddActor(actor)

# The only line that an existing script needs.
vtkoit.install(renderer)

window = vtkRenderWindow()
window.SetSize(400, 400)
window.AddRenderer(renderer)
window.Render()

image = vtkWindowToImageFilter()
image.SetInput(window)
image.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(image.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
