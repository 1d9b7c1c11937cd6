//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Slots: the depths that the buckets have captured, without the empty ones: buckets are in order, so
// the slots are sorted.

uniform sampler2DArray oitDepths;

layout(location = 0) out vec4 oitSlots0;
layout(location = 1) out vec4 oitSlots1;
layout(location = 2) out vec4 oitSlots2;
layout(location = 3) out vec4 oitSlots3;
layout(location = 4) out vec4 oitSlots4;
layout(location = 5) out vec4 oitSlots5;
layout(location = 6) out vec4 oitSlots6;
layout(location = 7) out vec4 oitSlots7;

const float OIT_NO_SLOT = 4.0;

float oitSlotDepths[32];
int oitCount = 0;

void oitAppend(float depth)
{
  oitSlotDepths[oitCount] = depth;
  ++oitCount;
}

void main()
{
  for (int i = 0; i < 32; ++i)
  {
    oitSlotDepths[i] = OIT_NO_SLOT;
  }
  for (int layer = 0; layer < 8; ++layer)
  {
    vec4 depths = texelFetch(oitDepths, ivec3(gl_FragCoord.xy, layer), 0);
#ifdef OIT_PAIRS
    vec2 nearest = -depths.xz;
    vec2 farthest = depths.yw;
    if (farthest.x >= 0.0) oitAppend(nearest.x);
    if (farthest.x > nearest.x) oitAppend(farthest.x);
    if (farthest.y >= 0.0) oitAppend(nearest.y);
    if (farthest.y > nearest.y) oitAppend(farthest.y);
#else
    vec4 nearest = -depths;
    if (nearest.x <= 1.0) oitAppend(nearest.x);
    if (nearest.y <= 1.0) oitAppend(nearest.y);
    if (nearest.z <= 1.0) oitAppend(nearest.z);
    if (nearest.w <= 1.0) oitAppend(nearest.w);
#endif
  }
  float s[32] = oitSlotDepths;
  oitSlots0 = vec4(s[0], s[1], s[2], s[3]);
  oitSlots1 = vec4(s[4], s[5], s[6], s[7]);
  oitSlots2 = vec4(s[8], s[9], s[10], s[11]);
  oitSlots3 = vec4(s[12], s[13], s[14], s[15]);
  oitSlots4 = vec4(s[16], s[17], s[18], s[19]);
  oitSlots5 = vec4(s[20], s[21], s[22], s[23]);
  oitSlots6 = vec4(s[24], s[25], s[26], s[27]);
  oitSlots7 = vec4(s[28], s[29], s[30], s[31]);
}
