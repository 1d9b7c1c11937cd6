// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Coincident fragments, as sums over a group of equal depth: the order of drawing does not matter.

struct OITGroup
{
  vec3 Color;         // sum of opacity times colour
  float Weight;       // sum of opacities
  float OpticalDepth; // sum of -log(1 - opacity)
  float Count;
};

// 1 - prod(1 - opacity). For a single fragment it is the opacity itself, without rounding.
float oitGetGroupOpacity(OITGroup group)
{
  return group.Count < 1.5 ? group.Weight : 1.0 - exp(-group.OpticalDepth);
}

// The mean of the colours weighted by opacity, times the opacity of the group.
vec3 oitGetGroupColor(OITGroup group, float opacity)
{
  return group.Count < 1.5 ? group.Color : group.Color * (opacity / group.Weight);
}
