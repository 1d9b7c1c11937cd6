// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, of peels to the end: fragments at the depths of four slots are summed up, each slot as a group
// of coincident fragments. Of the fragments between them, each of four buckets keeps the nearest and
// the farthest depth: the slots of the next peel are among these. Colours are added, alpha is kept as
// the maximum, one way of blending for all buffers:
//
//   2 i      sum of opacity times colour of slot i;                -depth of the nearest in bucket i
//   2 i + 1  sums of opacity, optical depth and count of slot i;   depth of the farthest in bucket i
//
// With OIT_LAST_ON_TOP groups are blended in the order of drawing: GL_ONE, GL_ONE_MINUS_SRC_ALPHA, but in
// buffer OIT_BUCKET_DEPTHS, which keeps the maximum of depths and sums up alpha. All is one bucket.

uniform sampler2DArray oitState;
uniform int oitIsFirst; // not 0: there are no slots yet, all is one bucket, and counted
uniform int oitRest;    // not 0: all that is left counts as one group

const float OIT_NO_DEPTH = -2.0;

layout(location = 0) out vec4 oitOut0;
layout(location = 1) out vec4 oitOut1;
layout(location = 2) out vec4 oitOut2;
layout(location = 3) out vec4 oitOut3;
layout(location = 4) out vec4 oitOut4;
layout(location = 5) out vec4 oitOut5;
#ifndef OIT_LAST_ON_TOP
layout(location = 6) out vec4 oitOut6;
layout(location = 7) out vec4 oitOut7;
#endif

void main()
{
  oitShade();
  float depth = oitGetDepth();
  vec4 color = oitGetColor();
  bool isFirst = oitIsFirst != 0;
  bool isRest = oitRest != 0;
  vec4 slots = texelFetch(oitState, ivec3(gl_FragCoord.xy, OIT_STATE_SLOTS), 0);
  vec3 division = texelFetch(oitState, ivec3(gl_FragCoord.xy, OIT_STATE_DIVISION), 0).xyz;
  slots = isFirst ? vec4(-1.0, OIT_NO_SLOT, OIT_NO_SLOT, 2.0) : slots;
  division = isFirst ? vec3(OIT_NO_SLOT) : division;

  bool isLeft = color.a > 0.0 && depth >= slots.x && depth <= slots.w;
  bvec4 isSlot = equal(slots, vec4(depth));
  isSlot.w = isSlot.w && !isSlot.x; // one layer is left
  vec4 match = isLeft && !isRest ? vec4(isSlot) : vec4(isLeft ? 1.0 : 0.0, 0.0, 0.0, 0.0);
  bool isOut = isLeft && !isRest && !any(isSlot);
  vec2 depths = isOut ? vec2(-depth, depth) : vec2(OIT_NO_DEPTH);
  vec3 weighted = color.a * color.rgb;
#ifdef OIT_LAST_ON_TOP
  vec4 layer = vec4(weighted, color.a);
  oitOut0 = match.x * layer;
  oitOut1 = match.y * layer;
  oitOut2 = match.z * layer;
  oitOut3 = match.w * layer;
  oitOut4 = vec4(depths, 0.0, isFirst ? float(isLeft) : match.w);
  oitOut5 = vec4(match.xyz, 0.0);
#else
  vec3 sums = vec3(color.a, oitGetOpticalDepth(color.a), 1.0);
  int bucket = int(dot(vec3(lessThanEqual(division, vec3(depth))), vec3(1.0)));
  bvec4 isMine = equal(ivec4(0, 1, 2, 3), ivec4(bucket));
  vec4 nearest = mix(vec4(OIT_NO_DEPTH), depths.xxxx, isMine);
  vec4 farthest = mix(vec4(OIT_NO_DEPTH), depths.yyyy, isMine);
  oitOut0 = vec4(match.x * weighted, nearest.x);
  oitOut1 = vec4(isFirst ? vec3(0.0, 0.0, float(isLeft)) : match.x * sums, farthest.x);
  oitOut2 = vec4(match.y * weighted, nearest.y);
  oitOut3 = vec4(match.y * sums, farthest.y);
  oitOut4 = vec4(match.z * weighted, nearest.z);
  oitOut5 = vec4(match.z * sums, farthest.z);
  oitOut6 = vec4(match.w * weighted, nearest.w);
  oitOut7 = vec4(match.w * sums, farthest.w);
#endif
}
