//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Slots: the depths that the buckets have captured, without the empty ones: buckets are in order, so
// the slots are sorted.

uniform sampler2DArray oitDepths;

//VTK::OIT::Write

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
  oitWrite(oitSlotDepths);
}
