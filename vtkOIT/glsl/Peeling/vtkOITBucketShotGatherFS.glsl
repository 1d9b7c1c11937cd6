// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, of a single shot, in the stages of oitStage. Red, green and blue of eight buffers are 24
// channels that keep the maximum, alpha is eight sums.
//
// OIT_SHOT_RANGE   channels 0 and 1: -depth of the nearest fragment, depth of the farthest
// OIT_SHOT_BUCKETS a channel for each of 24 buckets, or two for each of 12. Uniform and pairs: words of a
//                  key, the place in the bucket, above opacity and colour; so what a channel keeps is of
//                  one fragment, the nearest or the farthest. Sums for what shares a bucket: fragments,
//                  optical depth, opacity times colour, bucket, its square and its cube. Adaptive:
//                  the depths themselves; sums: fragments of two buckets each, of all, optical depth
// OIT_SHOT_COLORS  adaptive only: colours at known depths, see vtkOITBucketDivideFS.glsl. Alpha keeps the
//                  maximum, too

uniform sampler2DArray oitState;
uniform int oitStage;

const float OIT_NOTHING = -2.0;

layout(location = 0) out vec4 oitOut0;
layout(location = 1) out vec4 oitOut1;
layout(location = 2) out vec4 oitOut2;
layout(location = 3) out vec4 oitOut3;
layout(location = 4) out vec4 oitOut4;
layout(location = 5) out vec4 oitOut5;
layout(location = 6) out vec4 oitOut6;
layout(location = 7) out vec4 oitOut7;

// From the nearest to the farthest fragment of the pixel, in buckets.
float oitGetPosition(float depth, vec2 bounds)
{
  vec2 range = vec2(oitGetEyeDepth(bounds.x), oitGetEyeDepth(bounds.y));
  range = bounds.y > 1.0 ? oitInterval : range;
  float position = (oitGetEyeDepth(depth) - range.x) / max(range.y - range.x, 1e-30);
  return range.y > range.x ? clamp(position, 0.0, 1.0) * float(OIT_BUCKETS) : 0.0;
}

//VTK::OIT::Colors

// The channels first and first + 1, of those of buffer i.
vec3 oitGetChannels(int i, int first, vec2 values)
{
  ivec3 channels = ivec3(3 * i) + ivec3(0, 1, 2);
  vec3 result = mix(vec3(OIT_NOTHING), values.xxx, equal(channels, ivec3(first)));
  return mix(result, values.yyy, equal(channels, ivec3(first + 1)));
}

void main()
{
  oitShade();
  float depth = oitGetDepth();
  vec4 color = oitGetColor();
  vec2 bounds = texelFetch(oitState, ivec3(gl_FragCoord.xy, OIT_STATE_BOUNDS), 0).xy;
  bool isLeft = color.a > 0.0 && depth >= bounds.x && depth <= bounds.y;
  float position = oitGetPosition(depth, bounds);
  int bucket = min(int(position), OIT_BUCKETS - 1);
  bool isRange = oitStage == OIT_SHOT_RANGE;
  float opticalDepth = oitGetOpticalDepth(color.a);

#ifdef OIT_ADAPTIVE
  vec2 values = vec2(-depth, depth);
  int first = isRange ? 0 : 2 * bucket;
  float count = (bucket & 1) != 0 ? float(OIT_COUNT_BASE) : 1.0;
  vec4 sums = mix(vec4(0.0), vec4(count), equal(ivec4(0, 1, 2, 3), ivec4(bucket / 2)));
  vec4 moreSums = vec4(bucket / 2 == 4 ? count : 0.0, bucket / 2 == 5 ? count : 0.0, 1.0, opticalDepth);
#else
  int keys = oitGetNumberOfKeys();
  int key = min(int((position - float(bucket)) * float(keys)), keys - 1);
  uint shift = oitGetKeyShift();
  uint nearKey = uint(keys - 1 - key) << shift;
  uint bits = oitPackBucket(color);
#ifdef OIT_PAIRS
  // Of two fragments with one key each channel takes another one.
  vec2 words = vec2(oitToWord(nearKey | (bits ^ oitGetColorMask())),
    oitToWord((uint(key) << shift) | bits));
  int first = isRange ? 0 : 2 * bucket;
#else
  vec2 words = vec2(oitToWord(nearKey | bits), OIT_NOTHING);
  int first = isRange ? 0 : bucket;
#endif
  vec2 values = isRange ? vec2(-depth, depth) : words;
  float index = float(bucket);
  vec4 sums = vec4(1.0, opticalDepth, color.a * color.rg);
  vec4 moreSums = vec4(color.a * color.b, index, index * index, index * index * index);
#endif
  first = isLeft ? first : -2;
  sums = isLeft ? sums : vec4(0.0);
  moreSums = isLeft ? moreSums : vec4(0.0);
#ifdef OIT_ADAPTIVE
  if (oitStage == OIT_SHOT_COLORS)
  {
    oitWriteColor(isLeft ? bucket : -1, depth, color);
    return;
  }
#endif
  oitOut0 = vec4(oitGetChannels(0, first, values), sums.x);
  oitOut1 = vec4(oitGetChannels(1, first, values), sums.y);
  oitOut2 = vec4(oitGetChannels(2, first, values), sums.z);
  oitOut3 = vec4(oitGetChannels(3, first, values), sums.w);
  oitOut4 = vec4(oitGetChannels(4, first, values), moreSums.x);
  oitOut5 = vec4(oitGetChannels(5, first, values), moreSums.y);
  oitOut6 = vec4(oitGetChannels(6, first, values), moreSums.z);
  oitOut7 = vec4(oitGetChannels(7, first, values), moreSums.w);
}
