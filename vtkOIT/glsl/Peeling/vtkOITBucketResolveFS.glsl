//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve: blends the four slots of a colour pass, front to back, as far as nothing that was not
// captured lies in front of them; what lies behind is captured again in the next peel.

//VTK::OIT::State
//VTK::OIT::Group

uniform sampler2DArray oitSums;
uniform sampler2DArray oitSlots;
uniform int oitSlotLayer;
uniform int oitIsLastPass;   // of the peel
uniform int oitIsSingleShot; // what was not captured is lost
uniform int oitCountsLost;
uniform int oitRest;

vec4 oitLoadSums(int layer)
{
  return texelFetch(oitSums, ivec3(gl_FragCoord.xy, layer), 0);
}

void oitBlendSlot(int slot, float depth, float nearestOut)
{
#ifdef OIT_LAST_ON_TOP
  vec4 layer = oitLoadSums(slot);
  float count = slot < 3 ? oitLoadSums(5)[slot] : oitLoadSums(OIT_BUCKET_DEPTHS).a;
  OITGroup group = OITGroup(layer.rgb, layer.a, 0.0, count);
#else
  vec3 sums = oitLoadSums(4 + slot).rgb;
  OITGroup group = OITGroup(oitLoadSums(slot).rgb, sums.x, sums.y, sums.z);
#endif
  if (group.Count > 0.0 && depth < nearestOut)
  {
    float opacity = oitGetGroupOpacity(group);
    if (oitRest != 0 && group.Count > 1.5)
    {
      oitNoteError(oitState0.a * opacity);
    }
    oitBlendUnder(oitGetGroupColor(group, opacity), opacity);
    oitState1.x += group.Count;
  }
}

void main()
{
  oitLoadCommonState();
  if (oitCountsLost != 0)
  {
    float lost = oitLoadSums(0).r;
    oitState1.w += lost;
    if (lost > 0.0)
    {
      oitNoteError(1.0);
    }
    oitSetBounds(2.0, -2.0);
    return;
  }
#ifdef OIT_LAST_ON_TOP
  vec2 outside = oitLoadSums(OIT_BUCKET_DEPTHS).xy * vec2(-1.0, 1.0);
#else
  vec2 outside = vec2(-oitLoadSums(0).a, oitLoadSums(1).a);
#endif
  vec4 slots = texelFetch(oitSlots, ivec3(gl_FragCoord.xy, oitSlotLayer), 0);
  bool isAll = oitIsSingleShot != 0 || oitRest != 0;
  float nearestOut = isAll ? 8.0 : outside.x;
  oitBlendSlot(0, slots.x, nearestOut);
  oitBlendSlot(1, slots.y, nearestOut);
  oitBlendSlot(2, slots.z, nearestOut);
  oitBlendSlot(3, slots.w, nearestOut);
  if (oitIsLastPass != 0 && oitIsSingleShot == 0)
  {
    oitSetBounds(outside.x, outside.y);
  }
}
