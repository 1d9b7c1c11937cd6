# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Contexts that lack an extension, or are of an older version: every method draws rightly, or says
in one line why not and is not exact.

    TestMissingExtensions.py Some     what has gone wrong before
    TestMissingExtensions.py Every    each extension that vtkOIT can use, each version; minutes

Mesa hides extensions and versions for this (MESA_EXTENSION_OVERRIDE, MESA_GL_VERSION_OVERRIDE).
"""

import json
import sys
import unittest

import Support

SCENES = sys.path[0] + "/KnownScenes.py"
FETCH = "GL_EXT_shader_framebuffer_fetch"

# A method of each engine.
METHODS = ("auto", "abuffer", "peel", "dual", "multilayer", "bucket", "weighted-average")

# What is asked for by name (vtkOITCapabilities, vtkOITShaderText::Require), what is used where it
# is there, and what has a way of its own in VTK.
EXTENSIONS = (
    "GL_ARB_clear_texture", "GL_ARB_copy_image", "GL_ARB_draw_buffers_blend",
    "GL_ARB_explicit_attrib_location", "GL_ARB_fragment_shader_interlock", "GL_ARB_gpu_shader5",
    "GL_ARB_occlusion_query2", "GL_ARB_post_depth_coverage", "GL_ARB_sample_shading",
    "GL_ARB_shader_bit_encoding", "GL_ARB_shader_image_load_store",
    "GL_ARB_shader_storage_buffer_object", "GL_ARB_shading_language_420pack",
    "GL_ARB_texture_barrier", "GL_ARB_texture_buffer_object_rgb32",
    "GL_ARB_texture_multisample", FETCH)

# Mesa cannot hide this one, says so, and hides all those instead that it always has:
# GL_ARB_texture_storage, GL_ARB_sampler_objects, GL_ARB_debug_output and 35 others.
ALWAYS = "GL_ARB_debug_output"

VERSIONS = {"3.2": "150", "3.3": "330", "4.0": "400", "4.1": "410", "4.2": "420", "4.3": "430",
            "4.5": "450"}


def find_faults(hidden=(), version=None, methods=METHODS):
    """(what is wrong, list of str; the context as KnownScenes.py prints it, None without one)."""
    variables = {"MESA_EXTENSION_OVERRIDE": " ".join("-" + name for name in hidden)}
    if version:
        variables.update(MESA_GL_VERSION_OVERRIDE=version, MESA_GLSL_VERSION_OVERRIDE=VERSIONS[version])
    done = Support.run(SCENES, *methods, name="vtkoit-python", timeout=300, **variables)
    lines = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    faults = ["%(method)s, %(scene)s, by %(by)s: %(fault)s" % line for line in lines[1:] if line["fault"]]
    if not lines:
        return faults, None  # VTK does not start in such a context
    if done.returncode != 0 or len(lines) != 1 + 3 * len(methods):
        faults.append("status %d after %d scenes: %s" % (done.returncode, len(lines) - 1, done.stderr[-300:]))
    return faults, lines[0]


class MissingTest(unittest.TestCase):
    def check(self, hidden=(), version=None, must_start=True):
        with self.subTest(hidden=hidden, version=version):
            faults, context = find_faults(hidden, version)
            self.assertEqual(faults, [])
            if must_start:
                self.assertIsNotNone(context)
            if context and version:
                self.assertEqual(context["version"].split()[0], version)
            if context:
                shown = [name for name in hidden if name in context["extensions"]]
                self.assertEqual(shown, [], "still there")


class Some(MissingTest):
    def setUp(self):
        _, context = find_faults(hidden=[FETCH], methods=["abuffer"])
        if context is None or FETCH in context["extensions"]:
            self.skipTest("the OpenGL driver is not Mesa's, and hides no extension")

    def test_locations_of_outputs(self):
        self.check(["GL_ARB_explicit_attrib_location"])

    def test_counted_samples(self):
        self.check(["GL_ARB_occlusion_query2"])
        self.check(["GL_ARB_occlusion_query2", "GL_ARB_clear_texture", FETCH])

    def test_immutable_textures(self):
        self.check([ALWAYS, FETCH])

    def test_oldest_version(self):
        self.check(version="3.2")


class Every(Some):
    def test_each_extension(self):
        for name in EXTENSIONS:
            self.check([name], must_start=False)

    def test_each_extension_without_fetch(self):
        for name in EXTENSIONS:
            if name != FETCH:
                self.check([name, FETCH], must_start=False)

    def test_each_version(self):
        for version in VERSIONS:
            self.check(version=version)

    def test_each_version_with_its_extensions_only(self):
        # Storage came with 4.3, with 4.2 a part of it, the locations with 3.3.
        newer = ["GL_ARB_clear_texture", "GL_ARB_texture_barrier", "GL_ARB_post_depth_coverage",
                 "GL_ARB_fragment_shader_interlock", FETCH]
        self.check(newer)
        newer += ["GL_ARB_shader_storage_buffer_object"]
        self.check(newer)
        newer += ["GL_ARB_shader_image_load_store", "GL_ARB_shading_language_420pack"]
        self.check(newer)
        newer += ["GL_ARB_gpu_shader5", "GL_ARB_sample_shading", "GL_ARB_draw_buffers_blend"]
        self.check(newer)
        newer += ["GL_ARB_explicit_attrib_location", "GL_ARB_shader_bit_encoding",
                  "GL_ARB_occlusion_query2"]
        self.check(newer)


if __name__ == "__main__":
    unittest.main()
