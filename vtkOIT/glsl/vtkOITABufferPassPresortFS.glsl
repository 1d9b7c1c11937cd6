//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// For multisampled framebuffers: sorts each pixel's list once, so that Resolve, which runs once a
// sample, only walks it. Writes no colour.

//VTK::OIT::Node
//VTK::OIT::Sort

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;
  uint head = imageLoad(oitHeads, pixel).x;
  if (head == OIT_END || oitOverflow != 0u)
  {
    discard;
  }
  head = oitSortList(head);
  imageStore(oitHeads, pixel, uvec4(head));
  uint count = 0u;
  for (uint node = head; node != OIT_END; ++count)
  {
    node = oitLoad(OIT_WORD(node)).w;
  }
  if (count > oitMaximumDepthComplexity)
  {
    atomicMax(oitMaximumDepthComplexity, count);
  }
}
