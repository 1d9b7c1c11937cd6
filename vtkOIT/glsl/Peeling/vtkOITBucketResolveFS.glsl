//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, of peels to the end: blends the slots from the front as far as no other fragment lies before
// them, and from the back as far as none lies behind; chooses the slots and the buckets of the next peel.

//VTK::OIT::State
OIT_STATE_LAYER(3) // colour and transmittance of the layers peeled from the back
OIT_STATE_LAYER(4) // slots: depths, ascending, of the nearest two and of the farthest two fragments known
OIT_STATE_LAYER(5) // division: depths at which the second to the fourth bucket begin
//VTK::OIT::Group
//VTK::OIT::Depth

uniform sampler2DArray oitSums;
uniform int oitIsFirst;
uniform int oitRest;

// Before oitBlendSlot(): a compiler that goes by the order of the text calls the layer uninitialized.
void oitLoadState()
{
  oitLoadCommonState();
  OIT_LOAD_STATE(3)
  OIT_LOAD_STATE(4)
}

vec4 oitLoadSums(int layer)
{
  return texelFetch(oitSums, ivec3(gl_FragCoord.xy, layer), 0);
}

void oitBlendSlot(int slot, bool isFront)
{
#ifdef OIT_LAST_ON_TOP
  vec4 layer = oitLoadSums(slot);
  float count = slot < 3 ? oitLoadSums(5)[slot] : oitLoadSums(OIT_BUCKET_DEPTHS).a;
  OITGroup group = OITGroup(layer.rgb, layer.a, 0.0, count);
#else
  vec3 sums = oitLoadSums(2 * slot + 1).rgb;
  OITGroup group = OITGroup(oitLoadSums(2 * slot).rgb, sums.x, sums.y, sums.z);
#endif
  if (group.Count == 0.0)
  {
    return;
  }
  float opacity = oitGetGroupOpacity(group);
  vec3 color = oitGetGroupColor(group, opacity);
  if (oitRest != 0 && group.Count > 1.5)
  {
    oitNoteError(oitState0.a * opacity);
  }
  if (isFront)
  {
    oitBlendUnder(color, opacity);
  }
  else
  {
    oitState3.rgb += color - opacity * oitState3.rgb;
    oitState3.a -= opacity * oitState3.a;
  }
  oitState1.x += group.Count;
}

float oitGetNearest(vec4 depths, float behind)
{
  vec4 those = mix(vec4(OIT_NO_SLOT), depths, greaterThan(depths, vec4(behind)));
  return min(min(those.x, those.y), min(those.z, those.w));
}

float oitGetFarthest(vec4 depths, float before)
{
  vec4 those = mix(vec4(-OIT_NO_SLOT), depths, lessThan(depths, vec4(before)));
  return max(max(those.x, those.y), max(those.z, those.w));
}

// Where three buckets begin, of the four that divide what is left.
vec3 oitDivide(float nearest, float farthest, vec4 bucketNear, vec4 bucketFar)
{
  vec3 shares = vec3(0.25, 0.5, 0.75);
  vec3 eye = mix(vec3(oitGetEyeDepth(nearest)), vec3(oitGetEyeDepth(farthest)), shares);
#ifdef OIT_ADAPTIVE
  // Only depths from the nearest to the farthest fragment of a bucket: gaps between them are left out.
  float starts[4];
  float lengths[4];
  float all = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    starts[i] = oitGetEyeDepth(clamp(bucketNear[i], 0.0, 1.0));
    lengths[i] = bucketFar[i] > bucketNear[i] ? oitGetEyeDepth(bucketFar[i]) - starts[i] : 0.0;
    all += lengths[i];
  }
  vec3 wanted = shares * all;
  float before = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    bvec3 isHere = bvec3(uvec3(greaterThanEqual(wanted, vec3(before))) *
      uvec3(lessThan(wanted, vec3(before + lengths[i]))));
    eye = mix(eye, starts[i] + wanted - before, isHere);
    before += lengths[i];
  }
#endif
  return vec3(oitGetWindowDepth(eye.x), oitGetWindowDepth(eye.y), oitGetWindowDepth(eye.z));
}

void main()
{
  oitLoadState();
#ifdef OIT_LAST_ON_TOP
  vec2 all = oitLoadSums(OIT_BUCKET_DEPTHS).xy;
  vec4 bucketNear = vec4(-all.x, 2.0, 2.0, 2.0);
  vec4 bucketFar = vec4(all.y, -2.0, -2.0, -2.0);
#else
  vec4 bucketNear =
    -vec4(oitLoadSums(0).a, oitLoadSums(2).a, oitLoadSums(4).a, oitLoadSums(6).a);
  vec4 bucketFar = vec4(oitLoadSums(1).a, oitLoadSums(3).a, oitLoadSums(5).a, oitLoadSums(7).a);
#endif
  float nearest = oitGetNearest(bucketNear, -1.0);
  float farthest = oitGetFarthest(bucketFar, OIT_NO_SLOT);

  vec4 slots = oitIsFirst != 0 ? vec4(OIT_NO_SLOT) : oitState4;
  slots.w = slots.w == slots.x ? OIT_NO_SLOT : slots.w;
  slots = oitRest != 0 ? vec4(0.0, OIT_NO_SLOT, OIT_NO_SLOT, OIT_NO_SLOT) : slots;
  for (int i = 0; i < 4; ++i)
  {
    if (slots[i] < nearest)
    {
      oitBlendSlot(i, true);
      slots[i] = OIT_NO_SLOT;
    }
  }
  for (int i = 3; i >= 0; --i)
  {
    if (slots[i] < OIT_NO_SLOT && slots[i] > farthest)
    {
      oitBlendSlot(i, false);
      slots[i] = OIT_NO_SLOT;
    }
  }

  float second = min(oitGetNearest(bucketNear, nearest),
    min(oitGetNearest(bucketFar, nearest), oitGetNearest(slots, nearest)));
  float secondLast = max(oitGetFarthest(bucketNear, farthest),
    max(oitGetFarthest(bucketFar, farthest), oitGetFarthest(slots, farthest)));
  second = second < farthest ? second : OIT_NO_SLOT;
  secondLast = second < secondLast ? secondLast : OIT_NO_SLOT;
  oitState4 = vec4(nearest, second, secondLast, farthest);
  oitState5 = vec4(oitDivide(nearest, farthest, bucketNear, bucketFar), 0.0);
  oitSetBounds(nearest, farthest);
  oitState4 = oitState2.x <= oitState2.y ? oitState4 : OIT_NO_BOUNDS.xxxy;
}
