// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Buckets divide eye depth: window depth is crowded near the far plane. The order of eye depths is that
// of window depths, so what shares a window depth shares a bucket.

uniform vec2 oitClippingRange; // eye depths of the clipping planes
uniform vec2 oitInterval;      // eye depths of the props: the range of pixels without bounds yet
uniform int oitIsParallel;     // projection

float oitGetEyeDepth(float depth)
{
  float near = oitClippingRange.x;
  float far = oitClippingRange.y;
  return oitIsParallel != 0 ? mix(near, far, depth) : near * far / (far - depth * (far - near));
}

float oitGetWindowDepth(float eye)
{
  float near = oitClippingRange.x;
  float far = oitClippingRange.y;
  float depth = (eye - near) / (far - near);
  return oitIsParallel != 0 ? depth : depth * far / eye;
}
