// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The depth test against a copy of the opaque depth, for shaders that must do it themselves.

uniform int oitDepthBits; // of a fixed-point depth buffer of at most 24 bits, otherwise 0

bool oitPassesDepthTest(float depth, float opaqueDepth)
{
  if (oitDepthBits == 0)
  {
    return depth <= opaqueDepth;
  }
  float scale = float((1 << oitDepthBits) - 1);
  // Products of 2^23 and more are integers already; adding 0.5 would round some of them up.
  vec2 product = vec2(depth, opaqueDepth) * scale;
  vec2 rounded = mix(floor(product + 0.5), product, greaterThanEqual(product, vec2(8388608.0)));
  return rounded.x <= rounded.y;
}
