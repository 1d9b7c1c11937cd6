# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""A volume with translucent surfaces in it: each is seen through what lies in front of it, and no more.

    build/bin/vtkoit-python Examples/Python/surface_in_volume.py FILE.png
"""

import sys

import vtkoit
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401, makes vtkGPUVolumeRayCastMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

if len(sys.argv) != 2:
    sys.exit("usage: surface_in_volume.py FILE.png")

renderer = vtkRenderer()
renderer.SetBackground(1, 1, 1)
field = vtkRTAnalyticSource()
field.SetWholeExtent(-25, 25, -25, 25, -25, 25)
field.SetXFreq(30)
field.SetYFreq(15)
field.SetZFreq(20)

opacity = vtkPiecewiseFunction()
color = vtkColorTransferFunction()
for value, a, rgb in ((90, 0.0, (0.2, 0.4, 0.9)), (180, 0.02, (0.5, 0.7, 0.9)), (270, 0.2, (0.9, 0.2, 0.1))):
    opacity.AddPoint(value, a)
    color.AddRGBPoint(value, *rgb)
volume_mapper = vtkGPUVolumeRayCastMapper()
volume_mapper.SetInputConnection(field.GetOutputPort())
volume_mapper.SetAutoAdjustSampleDistances(False)  # a picture, not an animation
volume_mapper.SetSampleDistance(0.5)
volume = vtkVolume()
volume.SetMapper(volume_mapper)
volume.GetProperty().SetScalarOpacity(opacity)
volume.GetProperty().SetColor(color)
volume.GetProperty().SetInterpolationTypeToLinear()
renderer.AddVolume(volume)

for value, rgb in ((150, (0.9, 0.7, 0.2)), (210, (0.1, 0.6, 0.4))):
    contour = vtkFlyingEdges3D()
    contour.SetInputConnection(field.GetOutputPort())
    contour.SetValue(0, value)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(contour.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(rgb)
    actor.GetProperty().SetOpacity(0.4)
    renderer.AddActor(actor)
renderer.GetActiveCamera().SetPosition(2, 1.5, 3)
renderer.ResetCamera()

# The only line that an existing script needs.
vtkoit.install(renderer)

window = vtkRenderWindow()
window.SetSize(400, 400)
window.SetMultiSamples(0)
window.AddRenderer(renderer)
window.Render()

image = vtkWindowToImageFilter()
image.SetInput(window)
image.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(image.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
