// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The depth test against a copy of the opaque depth, for shaders that must do it themselves.

uniform int oitDepthBits;     // of a fixed-point depth buffer of at most 24 bits, otherwise 0
uniform int oitDepthFunction; // what passes: 1 the nearer, 2 the equal, 4 the farther

bool oitPassesDepthFunction(float depth, float opaqueDepth)
{
  int relation = depth < opaqueDepth ? 1 : depth == opaqueDepth ? 2 : 4;
  return (oitDepthFunction & relation) != 0;
}

bool oitPassesDepthTest(float depth, float opaqueDepth)
{
  if (oitDepthBits == 0)
  {
    return oitPassesDepthFunction(depth, opaqueDepth);
  }
  float scale = float((1 << oitDepthBits) - 1);
  // Products of 2^23 and more are integers already; adding 0.5 would round some of them up.
  vec2 product = vec2(depth, opaqueDepth) * scale;
  vec2 rounded = mix(floor(product + 0.5), product, greaterThanEqual(product, vec2(8388608.0)));
  return oitPassesDepthFunction(rounded.x, rounded.y);
}
