//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve: the layers of a peel, front to back. Layers of one depth form a group of coincident
// fragments; a group that the next peel may go on with stays open.

//VTK::OIT::State

// With OIT_LAST_ON_TOP the group is blended instead, in the order of drawing.
OIT_STATE_LAYER(3) // open group: sums of opacity times colour and of opacity
OIT_STATE_LAYER(4) // opacity of the open group, its depth, count

//VTK::OIT::Slots

uniform int oitRest;

// Before oitCloseGroup(): a compiler that goes by the order of the text calls it uninitialized.
void oitLoadOpenGroup()
{
  OIT_LOAD_STATE(3)
  OIT_LOAD_STATE(4)
}

void oitCloseGroup()
{
  vec4 sums = oitState3;
  float opacity = oitState4.x;
  if (sums.a > 0.0)
  {
#ifdef OIT_LAST_ON_TOP
    oitBlendUnder(sums.rgb, opacity);
#else
    // For a single fragment the factor is 1.
    oitBlendUnder(sums.rgb * (opacity / sums.a), opacity);
#endif
  }
  oitState3 = vec4(0.0) * opacity;
  oitState4.xz = vec2(0.0);
}

void oitAddLayer(uint key, vec4 color)
{
  if (key >= OIT_EMPTY)
  {
    return;
  }
  float depth = uintBitsToFloat(key);
  if (depth != oitState4.y)
  {
    oitCloseGroup();
  }
#ifdef OIT_PAIRS
  // Half a step of 8 bits of each colour, and of each opacity times the colours behind.
  oitState1.z += oitState0.a * (1.0 + color.a) * (0.5 / 255.0);
#endif
#ifdef OIT_LAST_ON_TOP
  oitState3 *= 1.0 - color.a;
#endif
  oitState3 += vec4(color.a * color.rgb, color.a);
  oitState4.x += (1.0 - oitState4.x) * color.a;
  oitState4.y = depth;
  oitState1.x += 1.0;
}

void main()
{
  oitLoadCommonState();
  oitLoadOpenGroup();
  uvec4 slots[OIT_SLOTS];
  //VTK::OIT::LoadSlots
  if (oitRest != 0)
  {
    oitCloseGroup();
    vec4 sums = uintBitsToFloat(slots[0]);
    vec4 group = uintBitsToFloat(slots[1]);
    if (group.y > 1.5)
    {
      oitNoteError(oitState0.a * group.x);
    }
    oitState1.x += group.y;
    oitState3 = sums;
    oitState4.x = group.x;
    oitCloseGroup();
    oitSetBounds(2.0, -2.0);
    return;
  }
#ifdef OIT_PAIRS
  uint flags = slots[OIT_SLOTS - 1].z & ~OIT_DEPTH_MASK;
  slots[OIT_SLOTS - 1].z &= OIT_DEPTH_MASK;
  uint last = slots[OIT_SLOTS - 1].z;
  for (int i = 0; i < OIT_SLOTS; ++i)
  {
    oitAddLayer(slots[i].x, oitUnpack8(slots[i].y));
    oitAddLayer(slots[i].z, oitUnpack8(slots[i].w));
  }
  oitState1.w += (flags & OIT_TIED) != 0u ? 1.0 : 0.0;
  uint id = 0u;
#else
  uint flags = slots[OIT_SLOTS - 1].x & ~OIT_DEPTH_MASK;
  slots[OIT_SLOTS - 1].x &= OIT_DEPTH_MASK;
  uint last = slots[OIT_SLOTS - 1].x;
  for (int i = 0; i < OIT_SLOTS; ++i)
  {
    oitAddLayer(slots[i].x, oitUnpack(slots[i].zw));
  }
#ifdef OIT_LAST_ON_TOP
  // How many of the last depth were taken, in all peels.
  uint id = uintBitsToFloat(last) == oitState2.x ? uint(oitState2.z) * 65536u + uint(oitState2.w) : 0u;
  for (int i = 0; i < OIT_SLOTS; ++i)
  {
    id += uint(slots[i].x == last);
  }
#else
  uint id = slots[OIT_SLOTS - 1].y;
#endif
#endif
#ifdef OIT_BARRIER
  bool isMore = last < OIT_EMPTY; // what was behind has left no trace
#else
  bool isMore = (flags & OIT_MORE) != 0u;
#endif
  oitOrder = vec2(float(id >> 16u), float(id & 0xffffu));
  oitSetBounds(isMore ? uintBitsToFloat(last) : 2.0, isMore ? 1.0 : -2.0);
  if (oitState2.x > oitState2.y)
  {
    oitCloseGroup(); // also where the transmittance ended the peeling
  }
  oitState2.zw = oitOrder;
}
