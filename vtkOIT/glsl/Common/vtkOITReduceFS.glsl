//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Reduce: the statistics of a block of pixels as one texel: fragments, most fragments of a pixel,
// largest error bound, lost fragments.

uniform sampler2DArray oitState;
uniform ivec2 oitFirstPixel; // of the region
uniform ivec2 oitLastPixel;
out vec4 oitSums;

void main()
{
  ivec2 from = oitFirstPixel + ivec2(gl_FragCoord.xy) * OIT_BLOCK_SIZE;
  ivec2 to = min(from + OIT_BLOCK_SIZE - 1, oitLastPixel);
  vec4 sums = vec4(0.0);
  for (int y = from.y; y <= to.y; ++y)
  {
    for (int x = from.x; x <= to.x; ++x)
    {
      vec4 pixel = texelFetch(oitState, ivec3(x, y, OIT_STATE_STATISTICS), 0);
      sums.xw += pixel.xw;
      sums.yz = max(sums.yz, pixel.xz);
    }
  }
  oitSums = sums;
}
