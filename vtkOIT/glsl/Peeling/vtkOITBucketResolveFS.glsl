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
  vec3 sums = oitLoadSums(4 + slot).rgb;
  OITGroup group = OITGroup(oitLoadSums(slot).rgb, sums.x, sums.y, sums.z);
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
  vec2 outside = vec2(-oitLoadSums(0).a, oitLoadSums(1).a);
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
