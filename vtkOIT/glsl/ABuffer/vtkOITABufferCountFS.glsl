//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth complexity: walks each list once and notes the tile's longest. For frames that have no
// frame before them to tell it, and for multisampling, where Sort must know the longest list.

//VTK::OIT::Node

void main()
{
  uint node = imageLoad(oitHeads, ivec2(gl_FragCoord.xy) - oitOrigin).x;
  uint count = 0u;
  // After an overflow links lead to nodes that were never written.
  if (!oitHasOverflown())
  {
    for (; node != OIT_END; ++count)
    {
      node = oitLoadNext(OIT_WORD(node));
    }
  }
  if (count > 0u)
  {
    atomicMax(oitTiles[oitFindTile()].Complexity, count);
#ifdef OIT_COUNTS_FRAGMENTS
    atomicAdd(oitTiles[oitFindTile()].Fragments, count); // Resolve does not, then
#endif
  }
}
