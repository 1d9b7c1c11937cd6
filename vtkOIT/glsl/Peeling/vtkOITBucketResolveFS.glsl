//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, of peels to the end: blends the slots from the front as far as no other fragment lies before
// them, and from the back as far as none lies behind; chooses the slots and the buckets of the next peel.

//VTK::OIT::State
OIT_STATE_LAYER(3) // colour and transmittance of the layers peeled from the back
OIT_STATE_LAYER(4) // slots: depths, ascending, of the nearest three fragments known and of the farthest
OIT_STATE_LAYER(5) // division: depths at which the second to the fourth bucket begin; fragments left
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
  OIT_LOAD_STATE(5)
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
  oitState5.w -= group.Count;
}

float oitGetNearest(vec4 depths, float behind)
{
  vec4 those = mix(vec4(OIT_NO_SLOT), depths, greaterThan(depths, vec4(behind)));
  return min(min(those.x, those.y), min(those.z, those.w));
}

// Of all depths that are known.
float oitGetNext(float behind, vec4 bucketNear, vec4 bucketFar, vec4 slots)
{
  return min(oitGetNearest(bucketNear, behind),
    min(oitGetNearest(bucketFar, behind), oitGetNearest(slots, behind)));
}

// Where three buckets begin. Of those in front of the last one each gets a depth of the share that one of
// the fragments has which have no slot: so that there is one in it, rather than several.
vec3 oitDivide(float first, float farthest, float fragments)
{
  float start = oitGetEyeDepth(first);
  float share = (oitGetEyeDepth(farthest) - start) / max(fragments, 1.0);
  return vec3(oitGetWindowDepth(start + share), oitGetWindowDepth(start + 2.0 * share),
    oitGetWindowDepth(start + 3.0 * share));
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
  float farthest = max(max(bucketFar.x, bucketFar.y), max(bucketFar.z, bucketFar.w));

#ifdef OIT_LAST_ON_TOP
  float fragments = oitLoadSums(OIT_BUCKET_DEPTHS).a;
#else
  float fragments = oitLoadSums(1).b;
#endif
  oitState5.w = oitIsFirst != 0 ? fragments : oitState5.w;

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

  float second = oitGetNext(nearest, bucketNear, bucketFar, slots);
  second = second < farthest ? second : OIT_NO_SLOT;
  float third = oitGetNext(second, bucketNear, bucketFar, slots);
  third = third < farthest ? third : OIT_NO_SLOT;
  oitState4 = vec4(nearest, second, third, farthest);

  float last = third < OIT_NO_SLOT ? third : second < OIT_NO_SLOT ? second : nearest;
  float slotted = 1.0 + float(second < OIT_NO_SLOT) + float(third < OIT_NO_SLOT) + float(nearest < farthest);
#ifdef OIT_ADAPTIVE
  // What lies before the next one that is known is a gap.
  float next = oitGetNext(last, bucketNear, bucketFar, slots);
  last = next < farthest ? next : last;
#endif
  oitState5.xyz = oitDivide(last, farthest, oitState5.w - slotted);
  if (nearest > farthest && oitRest == 0)
  {
    // Counted by the first peel, and not found again: a fragment has another depth in each draw.
    float missing = max(oitState5.w, 0.0);
    oitState1.w += missing;
    oitNoteError(min(missing, 1.0));
  }
  oitSetBounds(nearest, farthest);
  bool isAlive = oitState2.x <= oitState2.y;
  oitState4 = isAlive ? oitState4 : OIT_NO_BOUNDS.xxxy;
  oitState5.w = isAlive ? oitState5.w : 0.0; // not in place, finished pixels come here again
}
