# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""DrawPictures.py FOLDER: the pictures of docs/paraview.md but that of the settings page. Run by pvpython with the
plugin, as by paraview-vtkoit."""

import os
import sys

from paraview import simple

SIZE = [520, 420]

view = simple.CreateView("RenderView")
view.ViewSize = SIZE
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
wavelet = simple.Wavelet(WholeExtent=[-24, 24, -24, 24, -24, 24], XFreq=20, YFreq=20, ZFreq=12, Maximum=255)
contours = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"],
                          Isosurfaces=[70 + 13 * i for i in range(16)])
shown = simple.Show(contours, view)
simple.ColorBy(shown, ("POINTS", "RTData"))
shown.RescaleTransferFunctionToDataRange()
simple.GetColorTransferFunction("RTData").ApplyPreset("Rainbow Uniform", True)
simple.GetScalarBar(simple.GetColorTransferFunction("RTData"), view).Visibility = 0
shown.Opacity = 0.3
view.CameraPosition = [70, 62, 95]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
view.CameraViewAngle = 26
page = simple.GetSettingsProxy("Translucency")
for method, name in (("Off", "paraview-stock"), ("Automatic", "paraview")):
    page.Method = method
    simple.SaveScreenshot(os.path.join(sys.argv[1], name + ".png"), view, ImageResolution=SIZE)
