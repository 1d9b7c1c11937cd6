# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of the stress suite that any translucent pass can be asked: those of docs/stress-tests.md without
rules and properties of vtkOIT's own (15, 29, 30, 34, 37, 38) and without what needs framebuffers of floats (16 to
19, 33)."""

import collections

Stress = collections.namedtuple("Stress", "title tests")
Stress.__doc__ = """title (str) and tests (tuple of str): those of vtkOITCxxTests that draw it."""

SCENES = {
    1: Stress(
        "N equal layers, up to 4096 (`peel` and buckets to 65, other peeling methods to 257)",
        ("TestLayerStacks",)),
    2: Stress(
        "N layers of random colours and opacities",
        ("TestLayerStacks",)),
    3: Stress(
        "the same scene in random draw orders",
        ("TestDrawOrder", "TestRandomScenes")),
    4: Stress(
        "the same frame 20 times",
        ("TestDrawOrder",)),
    5: Stress(
        "2 to 33 coincident faces of one colour",
        ("TestCoincidentLayers",)),
    6: Stress(
        "coincident faces of different colours, all orders",
        ("TestCoincidentLayers",)),
    7: Stress(
        "a mesh drawn twice",
        ("TestCoincidentLayers", "TestRandomScenes")),
    8: Stress(
        "layers 1, 2, 4 and 8 steps of float32 depth apart",
        ("TestDepthResolution",)),
    9: Stress(
        "eye depths that differ, window depths that do not",
        ("TestCoincidentLayers",)),
    10: Stress(
        "translucent and opaque faces in one plane; depth buffers of 24, 32 and 32 float bits; layers behind opaque faces",
        ("TestOpaqueOcclusion",)),
    11: Stress(
        "clipping planes at 1e-3 and 1e6",
        ("TestDepthRange",)),
    12: Stress(
        "layers of opacity 0, and empty props",
        ("TestOpacityExtremes", "TestRandomScenes")),
    13: Stress(
        "a layer of opacity 1 anywhere",
        ("TestOpacityExtremes",)),
    14: Stress(
        "opacities of 1/255, 1/510, 1/1024, 1e-6",
        ("TestOpacityExtremes",)),
    20: Stress(
        "a quad of a million triangles",
        ("TestTessellation",)),
    21: Stress(
        "two crossing quads",
        ("TestCrossingQuads",)),
    22: Stress(
        "a sphere: two layers or none",
        ("TestConvexSphere",)),
    23: Stress(
        "torus, knot, shells, tubes and crossing triangles against a ray caster, from both sides",
        ("TestClosedMeshes", "TestRandomScenes")),
    24: Stress(
        "crossing lines, joints of polylines",
        ("TestLines",)),
    25: Stress(
        "shaders that write `gl_FragDepth`, impostors",
        ("TestFragmentDepth", "TestImpostors")),
    26: Stress(
        "sheets cut by the near and far plane, layers at depths 0 and 1",
        ("TestDepthLimits",)),
    27: Stress(
        "viewports of 16384 pixels, tiles, more than 128 MiB of fragments",
        ("TestLargeViewport", "TestRandomScenes")),
    28: Stress(
        "sizes of 1 x 1 to 257 x 129, viewports with an offset, several renderers",
        ("TestViewports", "TestRenderers", "TestRandomScenes")),
    31: Stress(
        "a layer split into two",
        ("TestBlendingLaws", "TestRandomScenes")),
    32: Stress(
        "all layers of the background's colour",
        ("TestBlendingLaws",)),
    35: Stress(
        "nothing translucent, nothing visible, opaque and empty pixels",
        ("TestNothingTranslucent",)),
    36: Stress(
        "opacity from 0 to 1 over 4096 pixels",
        ("TestOpacityGradient",)),
}
