# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""vtkoit render: files to pictures."""

import os
import struct
import unittest

import numpy
import Support
import vtkoit
from vtkoit import method_option


class TestRender(Support.FolderTest):
    def render(self, *arguments, size=(80, 60)):
        """The picture, and what was printed."""
        done = self.vtkoit("render", *arguments, "--size", "%dx%d" % size, "-o", "out.png")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("out.png: %dx%d" % size, done.stdout)
        pixels = Support.read_picture(self.path("out.png"))
        self.assertEqual(pixels.shape[:2], size[::-1])
        return pixels, done.stdout

    def test_surface(self):
        Support.write_sphere(self.path("a.vtp"))
        _, text = self.render("a.vtp", "--samples", "0")
        self.assertIn(", ordered blending,", text)
        pixels, text = self.render("a.vtp", "--samples", "0", "--method", "abuffer")
        self.assertEqual(pixels.shape[2], 3)
        numpy.testing.assert_array_equal(pixels[0, 0], [255, 255, 255])
        self.assertLess(pixels[30, 40].min(), 200)
        self.assertIn("1 surface,", text)
        self.assertIn("up to 2 layers by A-buffer", text)

    def test_several_files_colours_and_opacities(self):
        Support.write_sphere(self.path("outer.vtp"), 2.0)
        Support.write_sphere(self.path("inner.vtp"), 1.0)
        pixels, text = self.render("outer.vtp", "inner.vtp", "--color", "blue", "#ff0000",
                                   "--opacity", "0.3", "1", "--background", "black")
        self.assertIn("2 surfaces", text)
        self.assertGreater(int(pixels[30, 40, 0]), 1.5 * int(pixels[30, 40, 2]))
        self.assertGreater(int(pixels[30, 60, 2]), 2 * int(pixels[30, 60, 0]))

    def test_order_of_files_does_not_matter(self):
        Support.write_sphere(self.path("outer.vtp"), 2.0)
        Support.write_sphere(self.path("inner.vtp"), 1.0)
        first, _ = self.render("outer.vtp", "inner.vtp", "--color", "blue", "red",
                               "--opacity", "0.3", "0.6")
        second, _ = self.render("inner.vtp", "outer.vtp", "--color", "red", "blue",
                                "--opacity", "0.6", "0.3")
        numpy.testing.assert_array_equal(first, second)

    def test_transparent_background(self):
        Support.write_sphere(self.path("a.vtp"))
        pixels, _ = self.render("a.vtp", "--background", "transparent", "--opacity", "0.5",
                                "--color", "red", "--samples", "0")
        self.assertEqual(pixels.shape[2], 4)
        numpy.testing.assert_array_equal(pixels[0, 0], [0, 0, 0, 0])
        # Two layers: 1 - 0.5 * 0.5.
        self.assertAlmostEqual(int(pixels[30, 40, 3]), 191, delta=1)
        # Straight alpha: the colour is that of the surface, not darkened by its opacity.
        opaque, _ = self.render("a.vtp", "--background", "transparent", "--opacity", "1",
                                "--color", "red", "--samples", "0")
        self.assertEqual(opaque[30, 40, 3], 255)
        self.assertGreater(int(pixels[30, 40, 0]), 0.6 * int(opaque[30, 40, 0]))

    def test_isosurfaces(self):
        Support.write_volume(self.path("a.vti"))
        pixels, text = self.render("a.vti", "--isosurface", "100", "150", "200")
        self.assertIn("3 surfaces", text)
        self.assertGreater(pixels.std(), 5.0)

    def test_isovalues_are_chosen_and_named(self):
        Support.write_volume(self.path("a.vti"))
        _, text = self.render("a.vti")
        self.assertRegex(text, r"a.vti: isosurfaces at [\d.]+ and [\d.]+, chosen by Otsu's method")
        self.assertIn("2 surfaces", text)

    def test_labels(self):
        Support.write_labels(self.path("a.mha"))
        first, text = self.render("a.mha", "--labels")
        self.assertIn("2 surfaces", text)
        second, text = self.render("a.mha")
        self.assertIn("drawn as the 2 labels", text)
        numpy.testing.assert_array_equal(first, second)
        _, text = self.render("a.mha", "--labels", "7", "--smooth", "0")
        self.assertIn("1 surface,", text)

    def test_scalars(self):
        Support.write_volume(self.path("a.vti"))
        low, _ = self.render("a.vti", "--isosurface", "150", "--scalars", "RTData",
                             "--range", "0,100", "--opacity", "1")
        high, _ = self.render("a.vti", "--isosurface", "150", "--scalars", "RTData",
                              "--range", "150,300", "--opacity", "1")
        # Below the range dark violet, above it yellow.
        self.assertGreater(int(low[30, 40, 0]), int(high[30, 40, 0]) + 50)

    def test_cameras(self):
        Support.write_volume(self.path("a.vti"))
        pictures = []
        for camera in ("x", "-x", "z", "30,20", "1,2,3", "60,0,0,0,0,0,0,0,1", "iso"):
            pixels, _ = self.render("a.vti", "--isosurface", "150", "--camera", camera)
            self.assertGreater(pixels.std(), 3.0, camera)
            pictures.append(pixels.tobytes())
        self.assertEqual(len(set(pictures)), len(pictures))
        for camera in ("1e300,2e300,3e300", "1e-320,2e-320,3e-320"):  # lengths do not matter
            pixels, _ = self.render("a.vti", "--isosurface", "150", "--camera", camera)
            self.assertGreater(pixels.std(), 3.0, camera)
        self.render("a.vti", "--isosurface", "150", "--camera", "-1,0,0", "--up", "-z",
                    "--parallel", "--zoom", "2")

    def test_stack_of_pictures(self):
        from vtkmodules.vtkImagingCore import vtkExtractVOI, vtkImageCast, vtkRTAnalyticSource
        from vtkmodules.vtkIOImage import vtkPNGWriter

        source = vtkRTAnalyticSource()
        source.SetWholeExtent(0, 11, 0, 11, 0, 11)
        cast = vtkImageCast()
        cast.SetInputConnection(source.GetOutputPort())
        cast.SetOutputScalarTypeToUnsignedChar()
        cast.ClampOverflowOn()
        for z in range(12):
            piece = vtkExtractVOI()
            piece.SetInputConnection(cast.GetOutputPort())
            piece.SetVOI(0, 11, 0, 11, z, z)
            writer = vtkPNGWriter()
            writer.SetInputConnection(piece.GetOutputPort())
            writer.SetFileName(self.path("slice%d.png" % z))
            piece.Update()
            writer.Write()
        names = sorted("slice%d.png" % z for z in range(12))
        _, text = self.render(*names, "--isosurface", "160", "--spacing", "1,1,2")
        self.assertIn("1 surface,", text)
        os.remove(self.path("out.png"))

    def test_raw(self):
        for z in range(6):
            with open(self.path("part.%d" % z), "wb") as file:
                file.write(struct.pack(">64H", *[500 * (2 <= z <= 3 and 18 <= i % 64 <= 45)
                                                 for i in range(64)]))
        names = ["part.%d" % z for z in range(6)]
        _, text = self.render(*names, "--raw", "8x8:uint16:big", "--isosurface", "250")
        self.assertIn("1 surface,", text)

    def test_method_and_properties(self):
        Support.write_sphere(self.path("a.vtp"))
        first, second = "FragmentPrecision=float", "maximum_buffer_size=4194304"
        for options in (["abuffer", "--set", first, "--set", second],
                        ["abuffer", "--set", "%s,%s" % (first, second)],
                        ["abuffer:%s" % first, "--set", second],
                        ["abuffer:%s,%s" % (first, second)]):
            given = method_option.parse(method_option.joined(options[0], options[2::2]))
            self.assertEqual(given, ("abuffer", {"FragmentPrecision": "float",
                                                 "maximum_buffer_size": "4194304"}))
        self.render("a.vtp", "--method", *options)

    def test_every_method(self):
        Support.write_sphere(self.path("outer.vtp"), 2.0)
        Support.write_sphere(self.path("inner.vtp"), 1.0)
        names = vtkoit.methods()
        for name in ("auto", "abuffer", "deferred-abuffer", "deferred", "peel", "dual",
                     "multilayer", "bucket", "bucket-pairs", "bucket-adaptive", "weighted-average", "weighted-sum",
                     "weighted-blended"):
            self.assertIn(name, names)
        for name in names:
            algorithm = vtkoit.create(name).GetAlgorithmName()
            _, text = self.render("outer.vtp", "inner.vtp", "--opacity", "0.3", "0.6",
                                  "--method", name)
            if name == "auto":
                algorithm = "A-buffer"
            # Not another one in its place: by default without multisampling, which most cannot.
            self.assertIn("by %s," % algorithm, text)

    def test_other_formats_of_pictures(self):
        Support.write_sphere(self.path("a.vtp"))
        for name, start in (("a.jpg", b"\xff\xd8"), ("a.tif", b"II"), ("a.bmp", b"BM"),
                            ("a.ppm", b"P6")):
            done = self.vtkoit("render", "a.vtp", "--size", "20x20", "-o", name)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(self.path(name), "rb") as file:
                self.assertTrue(file.read(2).startswith(start), name)

    def test_odd_sizes(self):
        Support.write_sphere(self.path("a.vtp"))
        for size in ((1, 1), (3, 7), (257, 129)):
            self.render("a.vtp", size=size)


class TestFallback(Support.FolderTest):
    """A method that cannot run: another one draws, and one line says so."""

    HIDDEN = "GL_ARB_shader_storage_buffer_object"

    def setUp(self):
        super().setUp()
        Support.write_sphere(self.path("outer.vtp"), 2.0)
        Support.write_sphere(self.path("inner.vtp"), 1.0)

    def draw(self, *arguments, hidden=HIDDEN):
        """(what was printed, the warnings as one str)."""
        done = Support.run("render", "outer.vtp", "inner.vtp", "--opacity", "0.3", "0.6", "--size", "40x30",
                           "-o", "a.png", *arguments, cwd=self.folder, VTKOIT_HIDE_EXTENSIONS=hidden)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout, done.stderr

    def test_without_storage_buffers(self):
        out, warning = self.draw("--method", "abuffer")
        self.assertIn("by dual depth peeling,", out)
        self.assertRegex(warning, r"^vtkoit render: warning: the method abuffer does not run here \(.*%s.*\); "
                         r"drawn by dual depth peeling\n$" % self.HIDDEN)
        exact = Support.read_picture(self.path("a.png")).astype(int)
        out, warning = self.draw()
        self.assertNotIn("unsorted", out)
        self.assertEqual(warning, "")  # to choose is what auto is for
        self.draw("--samples", "0", hidden="")
        right = Support.read_picture(self.path("a.png"))
        self.assertLessEqual(abs(exact - right).max(), 2)

    def test_when_nothing_is_exact(self):
        out, warning = self.draw("--samples", "4")
        self.assertIn("unsorted blending,", out)
        self.assertRegex(warning, r"^vtkoit render: warning: the method auto .*; drawn by unsorted "
                         r"blending, which is not exact\n$")

    def test_peeling_with_samples(self):
        for method in ("peel", "dual", "multilayer", "bucket", "weighted-sum"):
            out, warning = self.draw("--method", method, "--samples", "4", hidden="")
            self.assertIn("by A-buffer,", out)
            self.assertRegex(warning, r"^vtkoit render: warning: the method %s does not run here "
                             r"\(.* one sample a pixel .*\); drawn by A-buffer\n$" % method)

    def test_tables(self):
        for command in (["compare", "outer.vtp", "--opacity", "0.3"],
                        ["bench", "--scenes", "layers-4", "--frames", "1", "--no-plots"]):
            done = Support.run(*command, "--methods", "abuffer", "auto", "dual", "--size", "30x20",
                               cwd=self.folder, VTKOIT_HIDE_EXTENSIONS=self.HIDDEN)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("; truth: the picture of peel", done.stdout)
            self.assertRegex(done.stdout, r"(?m)^  abuffer +\d.*  drawn by dual depth peeling: .*%s"
                             % self.HIDDEN)
            self.assertRegex(done.stdout, r"(?m)^  auto +\d.*  drawn by (ordered|dual|blended)\b.*")
            self.assertRegex(done.stdout, r"(?m)^  dual +\d[^a-z]*(yes|no)[^a-z]*$")


class TestMethods(unittest.TestCase):
    """Every method in one scene, in this process."""

    def draw(self, name, **properties):
        renderer = Support.sphere_renderer()
        instance = vtkoit.install(renderer, name, **properties)
        return instance, Support.draw(renderer).astype(int)

    def test_exact_methods_agree_and_weighted_ones_tell(self):
        reference_pass, reference = self.draw("abuffer", FragmentPrecision="float")
        self.assertTrue(reference_pass.GetExact())
        self.assertGreater(reference_pass.GetMaximumDepthComplexity(), 3)
        for name in vtkoit.methods():
            with self.subTest(name):
                self.compare(name, reference_pass, reference)

    def compare(self, name, reference_pass, reference):
        has_threshold = "TransmittanceThreshold" in vtkoit.properties(name)
        instance, pixels = self.draw(name, **{"TransmittanceThreshold": 0} if has_threshold else {})
        if name != "auto":  # which may blend props, and counts nothing then
            self.assertEqual(instance.GetAlgorithmName(), vtkoit.create(name).GetAlgorithmName())
            self.assertEqual(
                instance.GetNumberOfFragments(), reference_pass.GetNumberOfFragments())
        difference = abs(pixels - reference).max()
        if name.startswith("weighted-"):
            self.assertFalse(instance.GetExact())
            self.assertEqual(instance.GetErrorBound(), 1.0)
            self.assertEqual(instance.GetNumberOfGeometryPasses(), 1)
            self.assertGreater(difference, 2)
        else:
            self.assertTrue(instance.GetExact())
            self.assertEqual(instance.GetErrorBound(), 0.0)
            self.assertLessEqual(difference, 2)

    def test_weighted_methods_are_exact_without_overlap(self):
        for name in vtkoit.methods():
            renderer = Support.quad_renderer()
            Support.add_quad(renderer, 0.0, (0.2, 0.5, 0.8), 0.5)
            instance = vtkoit.install(renderer, name)
            pixel = Support.draw(renderer, (20, 20))[10, 10]
            numpy.testing.assert_allclose(pixel, [25.5, 63.75, 102, 255], atol=1.0)
            self.assertTrue(instance.GetExact(), name)


if __name__ == "__main__":
    unittest.main()
