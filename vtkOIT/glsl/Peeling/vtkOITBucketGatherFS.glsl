// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, in two stages. Depths: each bucket keeps the nearest depth, of a pair of channels also the
// farthest, by MAX blending. Colours: fragments at the depths of four slots are summed up, each slot
// as a group of coincident fragments; the nearest fragment is found that no slot of this
// peel has captured, and the farthest of all. Colours are added, alpha is kept as the maximum.
//
// With OIT_LAST_ON_TOP groups are blended in the order of drawing: GL_ONE, GL_ONE_MINUS_SRC_ALPHA, but in
// buffer OIT_BUCKET_DEPTHS, which keeps the maximum of depths and sums up alpha.

uniform sampler2DArray oitDepths; // of the buckets
uniform sampler2DArray oitSlots;  // the depths of the buckets, sorted
uniform int oitIsColorStage;
uniform int oitSlotLayer;     // of oitSlots, the four of this pass
uniform int oitLastSlotLayer; // of this peel
uniform int oitRest;          // not 0: all that is left counts as one group
uniform int oitCountsLost;    // not 0: instead of colours, the fragments that were not captured

layout(location = 0) out vec4 oitOut0;
layout(location = 1) out vec4 oitOut1;
layout(location = 2) out vec4 oitOut2;
layout(location = 3) out vec4 oitOut3;
layout(location = 4) out vec4 oitOut4;
layout(location = 5) out vec4 oitOut5;
layout(location = 6) out vec4 oitOut6;
layout(location = 7) out vec4 oitOut7;

const float OIT_NO_DEPTH = -2.0;

// What buffer i gets in the stage Depths: a channel for each bucket, or two.
vec4 oitGetDepths(int i, int bucket, float depth)
{
#ifdef OIT_PAIRS
  bvec2 isMine = equal(ivec2(2 * i, 2 * i + 1), ivec2(bucket));
  return mix(vec4(OIT_NO_DEPTH), vec4(-depth, depth, -depth, depth), bvec4(isMine.xx, isMine.yy));
#else
  bvec4 isMine = equal(ivec4(4 * i) + ivec4(0, 1, 2, 3), ivec4(bucket));
  return mix(vec4(OIT_NO_DEPTH), vec4(-depth), isMine);
#endif
}

bool oitIsCaptured(int bucket, float depth)
{
#ifdef OIT_PAIRS
  vec4 depths = texelFetch(oitDepths, ivec3(gl_FragCoord.xy, bucket / 2), 0);
  vec2 pair = bucket - 2 * (bucket / 2) == 0 ? depths.xy : depths.zw;
  return depth == -pair.x || depth == pair.y;
#else
  vec4 depths = texelFetch(oitDepths, ivec3(gl_FragCoord.xy, bucket / 4), 0);
  return any(equal(vec4(depth), -depths));
#endif
}

void main()
{
  oitShade();
  float depth = oitGetDepth();
  vec4 color = oitGetColor();
  vec2 bounds = texelFetch(oitState, ivec3(gl_FragCoord.xy, OIT_STATE_BOUNDS), 0).xy;
  bool isLeft = color.a > 0.0 && depth >= bounds.x && depth <= bounds.y;
  int bucket = isLeft ? oitFindBucket(oitGetPosition(depth, bounds)) : -1;

  bool countsLost = oitCountsLost != 0;
  vec4 slots = texelFetch(oitSlots, ivec3(gl_FragCoord.xy, oitSlotLayer), 0);
  float last = texelFetch(oitSlots, ivec3(gl_FragCoord.xy, oitLastSlotLayer), 0).w;
  bool isRest = oitRest != 0;
  vec4 match = isLeft && !isRest ? vec4(equal(slots, vec4(depth))) : vec4(0.0);
  match.x = isLeft && isRest ? 1.0 : match.x;
  bool isOut = isLeft && !isRest && (depth > last || !oitIsCaptured(max(bucket, 0), depth));
  vec3 weighted = countsLost ? vec3(float(isOut), 0.0, 0.0) : color.a * color.rgb;
  match = countsLost ? vec4(1.0, 0.0, 0.0, 0.0) : match;
  vec3 sums = vec3(color.a, oitGetOpticalDepth(color.a), 1.0);

  bool isColor = oitIsColorStage != 0;
#ifdef OIT_LAST_ON_TOP
  vec4 layer = vec4(weighted, countsLost ? 0.0 : color.a);
  oitOut0 = isColor ? match.x * layer : oitGetDepths(0, bucket, depth);
  oitOut1 = isColor ? match.y * layer : oitGetDepths(1, bucket, depth);
  oitOut2 = isColor ? match.z * layer : oitGetDepths(2, bucket, depth);
  oitOut3 = isColor ? match.w * layer : oitGetDepths(3, bucket, depth);
  vec2 depths = vec2(isOut ? -depth : OIT_NO_DEPTH, isLeft ? depth : OIT_NO_DEPTH);
  oitOut4 = isColor ? vec4(depths, 0.0, match.w) : oitGetDepths(4, bucket, depth);
  oitOut5 = isColor ? vec4(match.xyz, 0.0) : oitGetDepths(5, bucket, depth);
  oitOut6 = isColor ? vec4(0.0) : oitGetDepths(6, bucket, depth);
  oitOut7 = isColor ? vec4(0.0) : oitGetDepths(7, bucket, depth);
#else
  oitOut0 = isColor ? vec4(match.x * weighted, isOut ? -depth : OIT_NO_DEPTH)
                    : oitGetDepths(0, bucket, depth);
  oitOut1 = isColor ? vec4(match.y * weighted, isLeft ? depth : OIT_NO_DEPTH)
                    : oitGetDepths(1, bucket, depth);
  oitOut2 = isColor ? vec4(match.z * weighted, 0.0) : oitGetDepths(2, bucket, depth);
  oitOut3 = isColor ? vec4(match.w * weighted, 0.0) : oitGetDepths(3, bucket, depth);
  oitOut4 = isColor ? vec4(match.x * sums, 0.0) : oitGetDepths(4, bucket, depth);
  oitOut5 = isColor ? vec4(match.y * sums, 0.0) : oitGetDepths(5, bucket, depth);
  oitOut6 = isColor ? vec4(match.z * sums, 0.0) : oitGetDepths(6, bucket, depth);
  oitOut7 = isColor ? vec4(match.w * sums, 0.0) : oitGetDepths(7, bucket, depth);
#endif
}
