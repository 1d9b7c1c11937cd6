// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Histogram: a bit for each of 1024 bins of depth that has a fragment, in 8 buffers of 4 x 32 bits
// which the logical operation OR keeps (Liu, Huang, Liu and Wu 2009, adaptive bucket peeling).

layout(location = 0) out uvec4 oitBits0;
layout(location = 1) out uvec4 oitBits1;
layout(location = 2) out uvec4 oitBits2;
layout(location = 3) out uvec4 oitBits3;
layout(location = 4) out uvec4 oitBits4;
layout(location = 5) out uvec4 oitBits5;
layout(location = 6) out uvec4 oitBits6;
layout(location = 7) out uvec4 oitBits7;

#define OIT_WRITE_BITS(i) oitBits##i = word / 4 == i ? bits : uvec4(0u);

void main()
{
  oitShade();
  float depth = oitGetDepth();
  vec2 bounds = texelFetch(oitState, ivec3(gl_FragCoord.xy, OIT_STATE_BOUNDS), 0).xy;
  bool isLeft = oitGetColor().a > 0.0 && depth >= bounds.x && depth <= bounds.y;
  int bin = oitGetBin(oitGetPosition(depth, bounds));
  int word = bin / 32;
  uint bit = isLeft ? 1u << uint(bin - 32 * word) : 0u;
  ivec4 channels = ivec4(0, 1, 2, 3);
  uvec4 bits = uvec4(equal(channels, ivec4(word - 4 * (word / 4)))) * bit;
  OIT_WRITE_BITS(0)
  OIT_WRITE_BITS(1)
  OIT_WRITE_BITS(2)
  OIT_WRITE_BITS(3)
  OIT_WRITE_BITS(4)
  OIT_WRITE_BITS(5)
  OIT_WRITE_BITS(6)
  OIT_WRITE_BITS(7)
}
