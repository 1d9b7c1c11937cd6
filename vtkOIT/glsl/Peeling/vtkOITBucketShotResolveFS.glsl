//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, of a uniform or pairwise single shot: the buckets in order, front to back. What shared a
// bucket and was not kept lies behind the nearest fragment of its bucket; its colour and opacity are what
// the kept ones leave of the sums.

//VTK::OIT::State
//VTK::OIT::Words
//VTK::OIT::Lost

uniform sampler2DArray oitShot;
uniform int oitStage;

vec4 oitNear[OIT_BUCKETS]; // colour and opacity, 0: empty
vec4 oitFar[OIT_BUCKETS];
float oitSums[8];

void oitLoadBuckets()
{
  float channels[24];
  for (int i = 0; i < 8; ++i)
  {
    vec4 buffer = texelFetch(oitShot, ivec3(gl_FragCoord.xy, i), 0);
    channels[3 * i] = buffer.r;
    channels[3 * i + 1] = buffer.g;
    channels[3 * i + 2] = buffer.b;
    oitSums[i] = buffer.a;
  }
  for (int i = 0; i < OIT_BUCKETS; ++i)
  {
#ifdef OIT_PAIRS
    bool isEmpty = channels[2 * i] <= 0.0;
    uint near = oitFromWord(channels[2 * i]) ^ oitGetColorMask();
    uint far = oitFromWord(channels[2 * i + 1]);
    // One fragment has the same colour in both, and the key of one is that of the other from the end.
    uint shift = oitGetKeyShift();
    bool isOne = ((near ^ far) & oitGetColorMask()) == 0u &&
      (near >> shift) + (far >> shift) == uint(oitGetNumberOfKeys() - 1);
    oitFar[i] = isEmpty || isOne ? vec4(0.0) : oitUnpackBucket(far);
#else
    bool isEmpty = channels[i] <= 0.0;
    uint near = oitFromWord(channels[i]);
    oitFar[i] = vec4(0.0);
#endif
    oitNear[i] = isEmpty ? vec4(0.0) : oitUnpackBucket(near);
  }
}

void oitBlend(vec3 color, float opticalDepth)
{
  float opacity = 1.0 - exp(-opticalDepth);
  oitBlendUnder(opacity * color, opacity);
}

void main()
{
  oitLoadCommonState();
  if (oitStage == OIT_SHOT_RANGE)
  {
    vec4 depths = texelFetch(oitShot, ivec3(gl_FragCoord.xy, 0), 0);
    oitSetBounds(-depths.x, depths.y);
    return;
  }
#ifdef OIT_IN_PLACE
  if (texelFetch(oitShot, ivec3(gl_FragCoord.xy, 0), 0).a == 0.0)
  {
    discard; // no fragments: the state stays as it is
  }
#endif
  oitLoadBuckets();
  float fragments = oitSums[0];
  float kept = 0.0;
  float keptDepth = 0.0; // optical
  vec3 powers = vec3(oitSums[5], oitSums[6], oitSums[7]);
  vec2 range = vec2(2.0, 0.0); // of opacities
  for (int i = 0; i < OIT_BUCKETS; ++i)
  {
    vec2 opacities = vec2(oitNear[i].a, oitFar[i].a);
    vec2 isKept = vec2(greaterThan(opacities, vec2(0.0)));
    float here = isKept.x + isKept.y;
    float index = float(i);
    kept += here;
    keptDepth += oitToOpticalDepth(opacities.x) + oitToOpticalDepth(opacities.y);
    powers -= here * vec3(index, index * index, index * index * index);
    range.x = min(range.x, min(here > 0.0 ? opacities.x : 2.0, here > 1.0 ? opacities.y : 2.0));
    range.y = max(range.y, max(opacities.x, opacities.y));
  }
  float lost = max(fragments - kept, 0.0);
  // Optical depth: all fragments the same, or as their opacities say, so that the sum is what it was.
  bool isUniform = range.x == range.y;
  float each = oitSums[1] / max(fragments, 1.0);
  float scale = lost > 0.0 ? 1.0 : oitSums[1] / max(keptDepth, 1e-30);
  float eachLost = isUniform ? each : max(oitSums[1] - keptDepth, 0.0) / max(lost, 1.0);
  float lostOpacity = 1.0 - exp(-eachLost);
  oitFindLost(lost, powers);

  vec3 rest = vec3(oitSums[2], oitSums[3], oitSums[4]);
  for (int i = 0; i < OIT_BUCKETS; ++i)
  {
    // Instead of opacities, optical depths.
    oitNear[i].a = oitNear[i].a > 0.0 ? (isUniform ? each : scale * oitToOpticalDepth(oitNear[i].a)) : 0.0;
    oitFar[i].a = oitFar[i].a > 0.0 ? (isUniform ? each : scale * oitToOpticalDepth(oitFar[i].a)) : 0.0;
    rest -= (1.0 - exp(-oitNear[i].a)) * oitNear[i].rgb + (1.0 - exp(-oitFar[i].a)) * oitFar[i].rgb;
#ifndef OIT_PAIRS
    rest -= oitLost[i] * lostOpacity * oitNear[i].rgb; // like what it shares the bucket with, at first
#endif
  }
  rest /= max(lost * lostOpacity, 1e-30);
  for (int i = 0; i < OIT_BUCKETS; ++i)
  {
    oitBlend(oitNear[i].rgb, oitNear[i].a);
    if (oitLost[i] > 0.0)
    {
#ifdef OIT_PAIRS
      vec3 color = rest;
#else
      vec3 color = oitNear[i].rgb + rest;
#endif
#ifdef OIT_CLAMP_COLOR
      color = min(color, vec3(1.0));
#endif
      oitBlend(max(color, vec3(0.0)), oitLost[i] * eachLost);
    }
    oitBlend(oitFar[i].rgb, oitFar[i].a);
  }
  oitState1.x += fragments;
  oitState1.w += lost;
  if (fragments > 0.0)
  {
    oitNoteError(1.0);
  }
  oitSetBounds(2.0, -2.0);
}
