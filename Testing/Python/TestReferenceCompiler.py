# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every program is accepted by Khronos's reference compiler, which is stricter than Mesa's: a driver may be, too.

Mesa writes the texts of the programs that it compiles. Drawn is without reading the framebuffer, an extension
that the reference compiler does not know for this kind of GLSL.
"""

import os
import shutil
import subprocess
import sys
import unittest

import Support

# A mesh, and points that are drawn by a geometry shader.
DRAW = """
import sys
sys.path.insert(0, %r)
import Support, vtkoit
from vtkmodules.vtkRenderingCore import vtkActor, vtkPointGaussianMapper
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkoit.windows import make_window
VARIANTS = [(method, 0, {}) for method in vtkoit.methods()] + [
    ("abuffer", 4, {}), ("abuffer", 0, {"FragmentPrecision": "float"}), ("dual", 0, {"FragmentPrecision": "float"})]
for method, samples, properties in VARIANTS:
    renderer = Support.sphere_renderer()
    points = vtkSphereSource()
    mapper = vtkPointGaussianMapper()
    mapper.SetInputConnection(points.GetOutputPort())
    mapper.EmissiveOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(0.5)
    renderer.AddActor(actor)
    vtkoit.install(renderer, method, **properties)
    window = make_window(renderer, (24, 24))
    window.SetMultiSamples(samples)
    for frame in range(3):
        window.Render()
    window.Finalize()
"""
STAGES = {"VS": "vert", "GS": "geom", "FS": "frag"}


def refused(path):
    """What the reference compiler says against a file, str; empty when it takes it."""
    done = subprocess.run(["glslangValidator", "-S", STAGES[os.path.basename(path)[:2]], path], check=False,
                          capture_output=True, text=True, timeout=60)
    return "" if done.returncode == 0 else "%s: %s" % (path, done.stdout)


class TestReferenceCompiler(Support.FolderTest):
    def programs(self):
        """The texts of the programs that are drawn with, dict of path to str."""
        folder = self.path("programs")
        os.mkdir(folder)
        with open(self.path("script.py"), "w", encoding="ascii") as file:
            file.write(DRAW % sys.path[0])
        done = Support.run(self.path("script.py"), name="vtkoit-python", MESA_SHADER_DUMP_PATH=folder,
                           MESA_SHADER_CACHE_DISABLE="true", VTKOIT_HIDE_EXTENSIONS="GL_EXT_shader_framebuffer_fetch")
        self.assertEqual(done.returncode, 0, done.stderr)
        texts = {}
        for name in os.listdir(folder):
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                texts[os.path.join(folder, name)] = file.read()
        return texts

    def test_programs(self):
        if not shutil.which("glslangValidator"):
            self.skipTest("no glslangValidator (Debian: glslang-tools)")
        texts = self.programs()
        if not texts:
            self.skipTest("this OpenGL does not write its programs (MESA_SHADER_DUMP_PATH): no Mesa")
        ours = [path for path, text in texts.items() if "oit" in text]
        for path in ours:
            self.assertEqual(refused(path), "")
        self.assertGreater(len(ours), 30)


if __name__ == "__main__":
    unittest.main()
