//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve: load the fragments of a pixel into registers, sort them by depth with an odd-even merge
// network (Batcher, Sorting networks and their applications, AFIPS 1968), which a CPU runs for
// eight pixels at once without a branch, and composite them front to back, C += T alpha c,
// T -= T alpha; with OIT_DEFERRED they are lit then, as far as the threshold lets them be seen. The text of the network is generated, for OIT_NETWORK_SIZE fragments.
//
// Each tile is drawn with the network that the last frame lets expect. Pixels that have more
// fragments, or coincident ones, are left alone and their tile is marked for SecondChance.

//VTK::OIT::Node
//VTK::OIT::Read
//VTK::OIT::Output

//VTK::OIT::RegisterMacros
#ifdef OIT_DEFERRED
//VTK::OIT::Light
#endif

// Notes the pixel's fragments in its tile: `fragments` of them, or more when it is left.
void oitNote(uint fragments, bool isLeft)
{
  float most = isLeft ? 128.0 : float(fragments); // 128: above all networks
  float sum = float(fragments);
  bool isMine = true;
#ifdef OIT_FINE_DERIVATIVES
  // Of two pixels side by side one does it for both, as atomics are slow on a CPU; on the diagonal
  // each for itself, because the tile's two triangles see only their own pixels.
  ivec2 at = ivec2(gl_FragCoord.xy);
  int inside = at.x - oitCorner.x;
  bool isInside = 0 <= inside && inside < oitSize.x;
  most = isInside ? most : 0.0;
  sum = isInside ? sum : 0.0;
  float towardsOther = (at.x & 1) == 0 ? 1.0 : -1.0;
  float mostOfOther = most + towardsOther * dFdxFine(most);
  float sumOfOther = sum + towardsOther * dFdxFine(sum);
  ivec2 block = at % OIT_TILE_SIZE / 2;
  if (block.x != block.y)
  {
    most = max(most, mostOfOther);
    sum += sumOfOther;
    isMine = (at.x & 1) == 0 || inside == 0; // the even one may be outside
  }
#endif
  if (isMine && most > 0.0)
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
#ifdef OIT_DEFERRED
  uint sorted[OIT_NETWORK_SIZE];
#endif
  //VTK::OIT::Registers
  bool isLeft = isTied || node != OIT_END;
  oitNote(node == OIT_END ? count : 0u, isLeft);
#ifdef OIT_DEFERRED
  uint toLight = isLeft ? 0u : count;
  oitBeginLight();
  for (uint i = 0u; i < toLight && transmittance > oitThreshold; ++i)
  {
    vec4 c = oitLightNode(oitLoad(sorted[i]), oitLoad(sorted[i] + 1u));
    float w = transmittance * c.a;
    color += w * c.rgb;
    transmittance -= w;
  }
  bool isAtEnd = transmittance <= oitThreshold;
#else
  bool isAtEnd = OIT_IS_AT_END;
#endif
#if defined(OIT_ENDS_LONG_LISTS) || defined(OIT_DEFERRED)
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
#if defined(OIT_ENDS_LONG_LISTS) || defined(OIT_DEFERRED)
  if (isAtEnd && transmittance > 0.0)
  {
    atomicMax(oitSkipped, floatBitsToUint(transmittance));
  }
#endif
  oitWrite(color, transmittance);
}
