// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Which bucket of its pixel a fragment falls into. Buckets divide eye depth: window depth is crowded
// near the far plane. Fragments of one window depth share a bucket, and the order of buckets is that
// of depths.

uniform sampler2DArray oitState;
uniform vec2 oitClippingRange; // eye depths of the clipping planes
uniform vec2 oitInterval;      // eye depths of the props: the range of pixels without bounds yet
uniform int oitIsParallel;     // projection

float oitGetEyeDepth(float depth)
{
  float near = oitClippingRange.x;
  float far = oitClippingRange.y;
  return oitIsParallel != 0 ? mix(near, far, depth) : near * far / (far - depth * (far - near));
}

// In [0, 1], from the nearest to the farthest fragment left in the pixel.
float oitGetPosition(float depth, vec2 bounds)
{
  vec2 range = vec2(oitGetEyeDepth(bounds.x), oitGetEyeDepth(bounds.y));
  range = bounds.y > 1.0 ? oitInterval : range;
  float position = (oitGetEyeDepth(depth) - range.x) / max(range.y - range.x, 1e-30);
  return range.y > range.x ? clamp(position, 0.0, 1.0) : 0.0;
}

#ifdef OIT_ADAPTIVE
uniform sampler2DArray oitBucketBounds; // the last bin of each bucket, ascending

int oitGetBin(float position)
{
  return min(int(position * float(OIT_BINS)), OIT_BINS - 1);
}
#ifndef OIT_HISTOGRAM
int oitFindBucket(float position)
{
  float bin = float(oitGetBin(position));
  float bucket = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    vec4 last = texelFetch(oitBucketBounds, ivec3(gl_FragCoord.xy, i), 0);
    bucket += dot(vec4(lessThan(last, vec4(bin))), vec4(1.0));
  }
  return min(int(bucket), 31);
}
#endif
#else
int oitFindBucket(float position)
{
  return min(int(position * float(OIT_BUCKETS)), OIT_BUCKETS - 1);
}
#endif
