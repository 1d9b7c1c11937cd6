//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// With OIT_DEFERRED in place of SecondChance and Walk: leaves pixels for Sort and Composite, all of a
// tile that no stage has drawn yet, otherwise those that Resolve has marked.

//VTK::OIT::Node

flat in int oitNetworkSize; // of the first try; -1: this is the first

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;
  uint head = imageLoad(oitHeads, pixel).x;
  if (head == OIT_END)
  {
    discard;
  }
  bool wasLeft = (head & OIT_LEFT) != 0u;
  uint count = 0u;
  for (uint node = head & ~OIT_LEFT; node != OIT_END; ++count)
  {
    node = oitLoadNext(OIT_WORD(node));
  }
  atomicMax(oitTiles[oitFindTile()].Marked, count);
  bool wasIncomplete = int(count) > oitNetworkSize;
  if (wasIncomplete)
  {
    atomicMax(oitTiles[oitFindTile()].Complexity, count);
    atomicAdd(oitTiles[oitFindTile()].Fragments, count);
  }
  if (wasIncomplete || wasLeft)
  {
    imageStore(oitHeads, pixel, uvec4(head | OIT_LEFT));
    atomicOr(oitTiles[oitFindTile()].Complexity, OIT_HAS_LISTS);
  }
  discard; // there is no colour
}
