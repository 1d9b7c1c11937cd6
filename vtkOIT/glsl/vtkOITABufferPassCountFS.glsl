//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth complexity: walks each list once and notes the tile's longest, so that Resolve can give
// every tile the smallest sorting network that will do.

//VTK::OIT::Node

void main()
{
  uint node = imageLoad(oitHeads, ivec2(gl_FragCoord.xy) - oitOrigin).x;
  uint count = 0u;
  // After an overflow links lead to nodes that were never written.
  if (oitOverflow == 0u)
  {
    for (; node != OIT_END; ++count)
    {
      node = oitLoad(OIT_WORD(node)).w;
    }
  }
  if (count > 0u)
  {
    atomicMax(oitTiles[oitFindTile()], count);
  }
}
