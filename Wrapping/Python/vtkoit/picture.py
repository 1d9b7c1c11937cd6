# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a render window: as an array, and as a file."""

import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

from .errors import Error, capture, error_code_text

# Extension: (class of vtkIOImage, whether the format keeps opacity)
_WRITERS = {
    "png": ("vtkPNGWriter", True),
    "tif": ("vtkTIFFWriter", True),
    "tiff": ("vtkTIFFWriter", True),
    "jpg": ("vtkJPEGWriter", False),
    "jpeg": ("vtkJPEGWriter", False),
    "bmp": ("vtkBMPWriter", False),
    "ppm": ("vtkPNMWriter", False),
}


def grab(window):
    """What a rendered vtkRenderWindow shows: array of uint8, (height, width, 4), top row first.

    Red, green, blue and alpha as in the framebuffer: colours multiplied by alpha (premultiplied).
    """
    to_image = vtkWindowToImageFilter()
    to_image.SetInput(window)
    to_image.SetInputBufferTypeToRGBA()
    to_image.ReadFrontBufferOff()
    to_image.ShouldRerenderOff()
    to_image.Update()
    image = to_image.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, 4)[::-1].copy()


def straight_alpha(pixels):
    """Colours divided by alpha, as image files have them: array of uint8 like pixels."""
    alpha = pixels[..., 3:].astype(float)
    color = numpy.divide(pixels[..., :3] * 255.0, alpha, out=numpy.zeros(pixels[..., :3].shape),
                         where=alpha > 0)
    return numpy.dstack([numpy.clip(numpy.rint(color), 0, 255).astype(numpy.uint8), pixels[..., 3]])


def check_output(path, transparent):
    """Raises Error when no picture can be written to path (str), before the work is done."""
    extension = os.path.splitext(path)[1].lower().lstrip(".")
    if extension not in _WRITERS:
        raise Error("%s: the name of a picture ends in one of: %s"
                    % (path, " ".join("." + name for name in _WRITERS)))
    if transparent and not _WRITERS[extension][1]:
        raise Error("%s: .%s files have no transparency; write .png or .tif" % (path, extension))
    folder = os.path.dirname(os.path.abspath(path))
    if os.path.isdir(path):
        raise Error("%s: cannot be written: it is a folder" % path)
    if not os.path.isdir(folder):
        raise Error("%s: cannot be written: there is no folder %s" % (path, folder))
    if not os.access(path if os.path.exists(path) else folder, os.W_OK):
        raise Error("%s: cannot be written: permission denied" % path)


def _image_of(values):
    """A vtkImageData of an array of uint8, top row first."""
    height, width, components = values.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    flat = numpy.ascontiguousarray(values[::-1]).reshape(-1, components)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def png_of(pixels):
    """The bytes of a PNG file of colours, array of uint8, height x width x 3 or more."""
    from vtkmodules.vtkIOImage import vtkPNGWriter

    writer = vtkPNGWriter()
    writer.SetInputData(_image_of(pixels[..., :3]))
    writer.WriteToMemoryOn()
    writer.Write()
    return vtk_to_numpy(writer.GetResult()).tobytes()


def save(pixels, path, transparent=False):
    """Writes pixels (as from grab()) to a file; transparent: bool, with alpha. Raises Error."""
    check_output(path, transparent)
    name, _ = _WRITERS[os.path.splitext(path)[1].lower().lstrip(".")]
    values = straight_alpha(pixels) if transparent else pixels[..., :3]

    from vtkmodules import vtkIOImage

    writer = getattr(vtkIOImage, name)()
    writer.SetInputData(_image_of(values))
    writer.SetFileName(os.fsencode(path))
    if name == "vtkTIFFWriter":
        writer.SetCompressionToDeflate()
    with capture() as captured:
        writer.Write()
    if writer.GetErrorCode() or captured.errors(1) or not os.path.exists(path):
        reason = captured.errors(1) or error_code_text(writer.GetErrorCode())
        raise Error("%s: cannot be written: %s" % (path, reason))
