// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather: sums over all fragments of a pixel, in the order of drawing.

layout(location = 0) out vec4 oitColors; // sums of weight times colour and of weight
layout(location = 1) out vec4 oitCounts; // count, optical depth, 0, sum of opacities

#ifdef OIT_BLENDED
uniform vec2 oitClippingRange; // eye depths of the clipping planes
uniform vec2 oitInterval;      // eye depths of the props, nearest and farthest
uniform int oitIsParallel;     // projection

float oitGetEyeDepth(float depth)
{
  float near = oitClippingRange.x;
  float far = oitClippingRange.y;
  return oitIsParallel != 0 ? mix(near, far, depth) : near * far / (far - depth * (far - near));
}

// Equation (10) of McGuire and Bavoil 2013, with the eye depth in the interval of the scene for
// the depth: a surface in front outweighs those behind it, whatever the clipping planes are.
float oitGetWeight(float depth)
{
  float t = (oitGetEyeDepth(depth) - oitInterval.x) / (oitInterval.y - oitInterval.x);
  float near = 1.0 - clamp(t, 0.0, 1.0);
  return max(1e-2, 3e3 * near * near * near);
}
#else
float oitGetWeight(float depth) { return 1.0; }
#endif

void main()
{
  oitShade();
  vec4 color = oitGetColor();
  bool isThere = color.a > 0.0;
  float weight = color.a * oitGetWeight(oitGetDepth());
  oitColors = vec4(weight * color.rgb, weight);
  oitCounts = vec4(isThere ? 1.0 : 0.0, oitGetOpticalDepth(color.a), 0.0, color.a);
}
