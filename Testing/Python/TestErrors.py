# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Everything that can go wrong on the command line: one clear line, a status that is not 0."""

import contextlib
import io
import os
import stat
import subprocess
import unittest

import Support
from vtkoit.cli import main


def run_here(arguments, folder):
    """Runs the command line in this process, which is much quicker than a new one."""
    out, err = io.StringIO(), io.StringIO()
    before = os.getcwd()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = main("vtkoit", list(arguments))
    finally:
        os.chdir(before)
    return subprocess.CompletedProcess(arguments, status, out.getvalue(), err.getvalue())


class TestErrors(Support.FolderTest):
    def setUp(self):
        super().setUp()
        Support.write_sphere(self.path("a.vtp"))

    def fails(self, *arguments, text, status=1, here=True):
        """Runs vtkoit, here or in a new process; it must end with the status and one line that has
        the text (a regular expression)."""
        done = run_here(arguments, self.folder) if here else self.vtkoit(*arguments)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertNotIn("internal error", done.stderr)
        self.assertRegex(done.stderr, "^vtkoit")
        self.assertRegex(done.stderr, text)

    def render_fails(self, *arguments, text, status=1, here=True):
        arguments = list(arguments)
        if "-o" not in arguments:
            arguments += ["-o", "out.png"]
        self.fails("render", *arguments, text=text, status=status, here=here)
        self.assertFalse(os.path.exists(self.path("out.png")))

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)

    def test_usage(self):
        self.fails(text="COMMAND", status=2)
        self.fails("paint", text="paint", status=2)
        self.fails("render", "a.vtp", text="-o/--output", status=2)
        self.fails("render", "-o", "out.png", text="INPUT", status=2)
        self.fails("info", "--much", text="--much", status=2)
        self.fails("render", "a.vtp", "-o", "out.png", "--smooth", "x", text="--smooth", status=2)

    def test_missing_file(self):
        self.render_fails("none.vtp", text="none.vtp: no such file")
        self.render_fails("none.vtp", text="none.vtp: no such file", here=False)
        self.fails("paint", text="paint", status=2, here=False)
        self.render_fails("a.vtp", "none.vti", text="none.vti: no such file")

    def test_unknown_extension(self):
        self.write("a.xyzzy", b"data")
        self.render_fails("a.xyzzy", text="no VTK reader for .xyzzy files; known: .*vtp")
        self.write("plain", b"data")
        self.render_fails("plain", text="no extension")

    def test_folder(self):
        os.mkdir(self.path("folder"))
        self.render_fails("folder", text="folder: a folder")

    def test_empty_and_corrupt_files(self):
        garbage = bytes((i * 37 + 11) % 251 for i in range(3000))
        for extension in ("vtp", "vtu", "vti", "vtk", "vtm", "pvtp", "stl", "ply", "obj", "mhd", "mha",
                          "nrrd", "nii", "ex2", "png", "tif", "jpg", "bmp", "glb", "vtkhdf", "dem",
                          "cgns", "case", "mrc", "tri"):
            with self.subTest(extension=extension):
                name = "bad." + extension
                self.write(name, b"")
                self.render_fails(name, text="bad.%s: the file is empty" % extension)
                self.write(name, garbage)
                self.render_fails(name, text="(bad.%s: (cannot be read|holds no points)|VTK crashed .*: bad.%s)"
                                  % (extension, extension), here=False)

    def test_truncated(self):
        Support.write_volume(self.path("a.vti"))
        with open(self.path("a.vti"), "rb") as file:
            content = file.read()
        self.write("cut.vti", content[:len(content) // 2])
        self.render_fails("cut.vti", text="cut.vti: cannot be read: .*")
        from vtkmodules.vtkIOLegacy import vtkDataSetWriter
        from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

        # VTK's reader only warns, and goes on with what was in memory.
        writer = vtkDataSetWriter()
        source = vtkRTAnalyticSource()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetFileTypeToBinary()
        writer.SetFileName(self.path("a.vtk"))
        writer.Write()
        with open(self.path("a.vtk"), "rb") as file:
            content = file.read()
        self.write("cut.vtk", content[:len(content) // 2])
        self.render_fails("cut.vtk", text="cut.vtk: cannot be read: Error reading")

    def test_method(self):
        self.render_fails("a.vtp", "--method", "magic", text="magic.*the methods are: auto abuffer")
        self.render_fails("a.vtp", "--set", "Magic=3", text="no property 'Magic'; it has: .*FragmentPrecision")
        self.render_fails("a.vtp", "--set", "Magic", text="NAME=VALUE")
        self.render_fails("a.vtp", "--set", "FragmentPrecision=low", text="one of float, half")

    def test_one_error_for_each_form(self):
        """The same words, whichever command and option says it."""
        for method, settings, text in (
                ("magic", [], "method magic: unknown; the methods are: .*auto abuffer"),
                ("dual", ["Depth"], "method dual:Depth: give METHOD:NAME=VALUE,NAME=VALUE"),
                ("dual", ["=1"], "method dual:=1: give METHOD:NAME=VALUE,NAME=VALUE"),
                ("dual", ["Magic=1"], "method dual:Magic=1: vtkOITDual.* has no property 'Magic'"),
                ("dual", ["OcclusionRatio=0.1", "Magic=1"], "method dual:OcclusionRatio=0.1,Magic=1: ")):
            whole = ":".join([method, ",".join(settings)]) if settings else method
            one_by_one = [word for setting in settings for word in ("--set", setting)]
            self.render_fails("a.vtp", "--method", whole, text=text)
            self.render_fails("a.vtp", "--method", method, *one_by_one, text=text)
            if settings:
                self.render_fails("a.vtp", "--method", method, "--set", ",".join(settings), text=text)
            self.fails("compare", "a.vtp", "--methods", whole, text=text)
            self.fails("bench", "--methods", whole, text=text)

    def test_properties_out_of_range(self):
        for value in ("nan", "inf", "-inf", "1e400", "-1", "2", "1e30", "9" * 30, "x", "0x1", "\xbd"):
            for name in ("TransmittanceThreshold", "OcclusionRatio"):
                self.render_fails("a.vtp", "--method", "dual", "--set", "%s=%s" % (name, value),
                                  text="%s.* is refused; " % name)
        for name in ("FragmentPrecision", "MaximumBufferSize", "MaximumNumberOfPeels", "ReuseFrames"):
            for value in ("nan", "-3", "0.5", "1e30", "9" * 30):
                self.render_fails("a.vtp", "--set", "%s=%s" % (name, value), text=name)

    def test_values(self):
        for option, value, text in (
                ("--size", "20", "WIDTHxHEIGHT"), ("--size", "0x20", "from 1 to"),
                ("--size", "99999x20", "from 1 to 16384"), ("--size", "-3x4", "WIDTHxHEIGHT"),
                ("--opacity", "1.5", "range from 0 to 1"), ("--opacity", "-0.5", "range from 0 to 1"),
                ("--opacity", "half", "not a number"), ("--opacity", "nan", "finite"),
                ("--color", "blurple", "blurple: unknown"), ("--color", "#12", "unknown"),
                ("--color", "1,2,3", "from 0 to 1"), ("--background", "nowhere", "unknown"),
                ("--colormap", "mud", "there are: viridis"), ("--camera", "up", "--camera up"),
                ("--camera", "0,0,0", "--camera"), ("--camera", "1,1,1,1,1,1,0,0,1", "the same"),
                ("--up", "w", "--up w"), ("--zoom", "0", "range"), ("--range", "3,1", "LOW,HIGH"),
                ("--samples", "99", "0 .none. to 16"), ("--spacing", "1,2", "X,Y,Z"),
                ("--raw", "8x8", "TYPE"), ("--smooth", "-1", "--smooth"),
                ("--size", "5\xb2x50", "WIDTHxHEIGHT"), ("--size", "9" * 5000 + "x9", "WIDTHxHEIGHT"),
                ("--raw", "9" * 30 + "x3:uint8", "TYPE"), ("--zoom", "\xb2", "not a number"),
                ("--labels", "100.7", "100.7 is not a whole number"), ("--labels", "1e10", "range"),
                ("--labels", "1,2.5", "2.5 is not a whole number")):
            with self.subTest(option=option, value=value):
                self.render_fails("a.vtp", option, value, text=text)

    def test_no_value(self):
        for option in ("--size", "--camera", "--zoom", "--method", "--set", "--samples", "--opacity",
                       "--read-timeout"):
            self.render_fails("a.vtp", option + "=--", text="%s: a value is missing" % option)
        self.render_fails("a.vtp", "--read-timeout=--", text="a value is missing", here=False)

    def test_isosurface(self):
        Support.write_volume(self.path("a.vti"))
        self.render_fails("a.vti", "--isosurface", "5000", text="RTData ranges from .* to ")
        self.render_fails("a.vti", "--isosurface", "1", "--contour", "No", text="it has: RTData")
        self.render_fails("a.vti", "--isosurface", "1", "--labels", text="exclude each other")
        self.render_fails("--isosurface", "100", "a.vti", "-o", "out.png",
                          text="INPUT", status=2)
        self.render_fails("a.vti", "--isosurface", "100", "a.vtp", text="files go before")

    def test_labels(self):
        Support.write_volume(self.path("a.vti"))
        self.render_fails("a.vti", "--labels", text="holds fractions")
        Support.write_labels(self.path("a.mha"))
        self.render_fails("a.mha", "--labels", "4", text="no sample has the label 4; there are: 3 7")

    def test_scalars(self):
        self.render_fails("a.vtp", "--scalars", "Heat", text="no surface has the scalars Heat; "
                          "there are: Normals")

    def test_raw_sizes(self):
        self.write("a.raw", b"12345678")
        self.render_fails("a.raw", "--raw", "8x8x8:uint8", text="has 8 bytes where --raw asks for 512")

    def test_output(self):
        self.render_fails("a.vtp", "-o", "none/out.png", text="there is no folder")
        self.render_fails("a.vtp", "-o", "out.xyz", text="ends in one of: .png")
        self.render_fails("a.vtp", "-o", ".", text="ends in one of")
        self.render_fails("a.vtp", "--background", "transparent", "-o", "out.jpg",
                          text="no transparency")
        os.mkdir(self.path("folder.png"))
        self.render_fails("a.vtp", "-o", "folder.png", text="it is a folder")

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_output_without_permission(self):
        os.mkdir(self.path("locked"), stat.S_IRUSR | stat.S_IXUSR)
        self.render_fails("a.vtp", "-o", "locked/out.png", text="permission denied")

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_full_disk(self):
        os.symlink("/dev/full", self.path("full.png"))
        self.render_fails("a.vtp", "-o", "full.png", text="full.png: cannot be written")

    def test_showcase(self):
        self.fails("showcase", "-o", "a.vtp", text="a.vtp: cannot be made")
        self.fails("showcase", "--size", "x", text="--size x")


if __name__ == "__main__":
    unittest.main()
