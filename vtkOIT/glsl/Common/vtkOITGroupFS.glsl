// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Coincident fragments, as sums over a group of equal depth: the order of drawing does not matter. With
// OIT_LAST_ON_TOP they are blended over each other instead, in that order.

struct OITGroup
{
  vec3 Color;         // sum of opacity times colour; the blended colour
  float Weight;       // sum of opacities; the opacity of the group
  float OpticalDepth; // sum of -log(1 - opacity)
  float Count;
};

// 1 - prod(1 - opacity). For a single fragment it is the opacity itself, without rounding.
float oitGetGroupOpacity(OITGroup group)
{
#ifdef OIT_LAST_ON_TOP
  return group.Weight;
#else
  return group.Count < 1.5 ? group.Weight : 1.0 - exp(-group.OpticalDepth);
#endif
}

// The mean of the colours weighted by opacity, or the blended colour, times the opacity of the group.
vec3 oitGetGroupColor(OITGroup group, float opacity)
{
#ifdef OIT_LAST_ON_TOP
  return group.Color;
#else
  return group.Count < 1.5 ? group.Color : group.Color * (opacity / group.Weight);
#endif
}
