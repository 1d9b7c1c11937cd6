# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""A script of a user, who has installed the package: two squares, whose mixture is known. Run by pvpython."""

import os
import sys
import tempfile

from paraview import simple
from vtkmodules.vtkIOImage import vtkPNGReader

page = simple.GetSettingsProxy("Translucency")
if page is None:
    sys.exit("the plugin is not loaded")
view = simple.CreateView("RenderView")
view.ViewSize = [64, 64]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0, 0, 0]
for z, color in ((0.5, [1, 0, 0]), (0, [0, 1, 0])):
    shown = simple.Show(simple.Plane(Origin=[-9, -9, z], Point1=[9, -9, z], Point2=[-9, 9, z]), view)
    shown.ColorArrayName = [None, ""]
    shown.AmbientColor = shown.DiffuseColor = color
    shown.Ambient = 1
    shown.Diffuse = 0
    shown.Opacity = 0.5
view.CameraPosition = [0, 0, 5]
view.CameraFocalPoint = [0, 0, 0]
view.CameraParallelProjection = 1
view.CameraParallelScale = 1
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "picture.png")
    page.Method = "A-buffer"
    simple.SaveScreenshot(path, view, ImageResolution=[64, 64])
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
color = [reader.GetOutput().GetScalarComponentAsDouble(32, 32, 0, channel) for channel in range(3)]
print("colour in the middle:", color)
# Only what is wrong: ParaView 5.11 alone crashes when a script calls sys.exit() with a view alive.
if any(abs(is_ - should) > 1 for is_, should in zip(color, (127.5, 63.75, 0))):
    sys.exit("that is not the right colour")
