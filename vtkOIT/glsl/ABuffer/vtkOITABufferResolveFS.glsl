//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve: load the fragments of a pixel into registers, sort them by depth with an odd-even merge
// network (Batcher, Sorting networks and their applications, AFIPS 1968), which a CPU runs for
// eight pixels at once without a branch, and composite them front to back, C += T alpha c,
// T -= T alpha. The text of the network is generated, for OIT_NETWORK_SIZE fragments.
//
// Each tile is drawn with the network that the last frame lets expect. Pixels that have more
// fragments, or coincident ones, are left alone and their tile is marked for SecondChance.

//VTK::OIT::Node
//VTK::OIT::Read
//VTK::OIT::Output

//VTK::OIT::RegisterMacros

// Notes the pixel's fragments in its tile: `fragments` of them, or more when it is left. Of four
// pixels one does it for all, as atomics are slow on a CPU; on the diagonal each for itself, because
// the tile's two triangles see only their own pixels of the four.
void oitNote(uint fragments, bool isLeft)
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 inside = at - oitCorner;
  bool isInside = all(greaterThanEqual(inside, ivec2(0))) && all(lessThan(inside, oitSize));
  float most = !isInside ? 0.0 : isLeft ? 128.0 : float(fragments); // 128: above all networks
  float sum = isInside ? float(fragments) : 0.0;
  ivec2 odd = at & 1;
  float mostOfPair = max(most, odd.x == 0 ? most + dFdx(most) : most - dFdx(most));
  float mostOfFour = max(
    mostOfPair, odd.y == 0 ? mostOfPair + dFdy(mostOfPair) : mostOfPair - dFdy(mostOfPair));
  float sumOfPair = 2.0 * sum + (odd.x == 0 ? dFdx(sum) : -dFdx(sum));
  float sumOfFour = 2.0 * sumOfPair + (odd.y == 0 ? dFdy(sumOfPair) : -dFdy(sumOfPair));
  ivec2 block = at % OIT_TILE_SIZE / 2;
  bool isOnDiagonal = block.x == block.y;
  most = isOnDiagonal ? most : mostOfFour;
  sum = isOnDiagonal ? sum : sumOfFour;
  // At the lower and left edge of the rectangle, the even neighbour may be outside.
  bvec2 isEdge = equal(inside, ivec2(0));
  if (most > 0.0 && (isOnDiagonal || ((odd.x == 0 || isEdge.x) && (odd.y == 0 || isEdge.y))))
  {
    int tile = oitFindTile();
    atomicMax(oitTiles[tile].Complexity, most < 128.0 ? uint(most) : OIT_TRY_AGAIN);
    atomicAdd(oitTiles[tile].Fragments, uint(sum));
  }
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;
  uint head = imageLoad(oitHeads, pixel).x;
  uint node = head;
  uint count = 0u;
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  bool isTied = false;
  //VTK::OIT::Registers
  bool isLeft = isTied || node != OIT_END;
  oitNote(node == OIT_END ? count : 0u, isLeft);
#ifdef OIT_ENDS_LONG_LISTS
  if (isLeft)
  {
    // SecondChance does not see coincident fragments behind the nearest of a long list.
    imageStore(oitHeads, pixel, uvec4(head | OIT_LEFT));
  }
#endif
  bool isMine = head != OIT_END && !isLeft;
  if (!isMine)
  {
    discard;
  }
#ifdef OIT_ENDS_LONG_LISTS
  if (OIT_IS_AT_END && transmittance > 0.0)
  {
    atomicMax(oitSkipped, floatBitsToUint(transmittance));
  }
#endif
  oitWrite(color, transmittance);
}
