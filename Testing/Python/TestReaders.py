# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every format that this VTK can write, written and read again; which readers there are."""

import unittest

import Support
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageCast, vtkRTAnalyticSource
from vtkoit import readers
from vtkoit.errors import Error
from vtkoit.progress import Progress
from vtkoit.read import leaves, natural_key, parse_raw, read_all


def sphere():
    return vtkSphereSource()


def volume(kind="Float"):
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(0, 7, 0, 7, 0, 7)
    cast = vtkImageCast()
    cast.SetInputConnection(source.GetOutputPort())
    getattr(cast, "SetOutputScalarTypeTo" + kind)()
    return cast


def grid():
    image = volume()
    image.Update()
    append = vtkAppendFilter()
    append.AddInputData(image.GetOutput())
    return append


# Extension, writer, source.
WRITTEN = [
    ("vtp", "vtkIOXML:vtkXMLPolyDataWriter", sphere),
    ("vtu", "vtkIOXML:vtkXMLUnstructuredGridWriter", grid),
    ("vti", "vtkIOXML:vtkXMLImageDataWriter", volume),
    ("pvtp", "vtkIOParallelXML:vtkXMLPPolyDataWriter", sphere),
    ("vtk", "vtkIOLegacy:vtkPolyDataWriter", sphere),
    ("stl", "vtkIOGeometry:vtkSTLWriter", sphere),
    ("ply", "vtkIOPLY:vtkPLYWriter", sphere),
    ("obj", "vtkIOGeometry:vtkOBJWriter", sphere),
    ("mha", "vtkIOImage:vtkMetaImageWriter", volume),
    ("nii", "vtkIOImage:vtkNIFTIImageWriter", volume),
    ("nii.gz", "vtkIOImage:vtkNIFTIImageWriter", volume),
    ("tif", "vtkIOImage:vtkTIFFWriter", lambda: volume("UnsignedChar")),
    ("ex2", "vtkIOExodus:vtkExodusIIWriter", grid),
]


class TestReaders(Support.FolderTest):
    def write(self, name, writer_name, source):
        import importlib

        module, class_name = writer_name.split(":")
        writer = getattr(importlib.import_module("vtkmodules." + module), class_name)()
        source.Update()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileName(self.path(name))
        writer.Write()

    def test_round_trip(self):
        for extension, writer, source in WRITTEN:
            with self.subTest(extension=extension):
                made = source()
                self.write("a." + extension, writer, made)
                inputs = read_all([self.path("a." + extension)], Progress())
                points = sum(leaf.GetNumberOfPoints() for _, leaf in leaves(inputs[0].data))
                expected = made.GetOutput().GetNumberOfPoints()
                # STL has no shared points, VTK's reader joins them again.
                self.assertEqual(points, expected)

    def test_composite(self):
        from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter

        blocks = vtkMultiBlockDataSet()
        for i in range(3):
            source = vtkSphereSource()
            source.SetCenter(i, 0, 0)
            source.Update()
            blocks.SetBlock(i, source.GetOutput())
            blocks.GetMetaData(i).Set(vtkMultiBlockDataSet.NAME(), "ball %d" % i)
        blocks.SetBlock(3, None)
        writer = vtkXMLMultiBlockDataWriter()
        writer.SetInputData(blocks)
        writer.SetFileName(self.path("a.vtm"))
        writer.Write()
        inputs = read_all([self.path("a.vtm")], Progress())
        self.assertEqual([name for name, _ in leaves(inputs[0].data)],
                         ["ball 0", "ball 1", "ball 2"])
        done = self.vtkoit("render", "a.vtm", "-o", "a.png", "--size", "30x30")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("3 surfaces", done.stdout)

    def test_table(self):
        found = readers.extensions()
        for extension in ("vtp vtu vti vtr vts vtm vtk pvtp stl ply obj mhd nrrd nii ex2 glb tif png "
                          "dem dcm").split():
            self.assertIn(extension, found)
        for extension in found:
            reader = readers.reader_class(extension)()
            self.assertTrue(any(hasattr(reader, name) for name in ("SetFileName", "SetCaseFileName")),
                            extension)

    def test_extension_of(self):
        for name, extension in (("a.VTP", "vtp"), ("d.x/a.nii.gz", "nii.gz"), ("can.ex2.003", "ex2"),
                                ("a.b.stl", "stl"), ("plain", ""), ("quarter.12", "12")):
            self.assertEqual(readers.extension_of(name), extension)

    def test_natural_order(self):
        self.assertEqual(sorted(["a10", "a9", "a1"], key=natural_key), ["a1", "a9", "a10"])

    def test_raw(self):
        raw = parse_raw("3x4x5:float32:big")
        self.assertEqual(tuple(raw), (3, 4, 5, 10, True))
        for text in ("3x4", "3x4:int7", "0x4:uint8", "3x4x5x6:uint8", "3x4:uint8:middle"):
            with self.assertRaises(Error):
                parse_raw(text)


if __name__ == "__main__":
    unittest.main()
