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
// fragments, or coincident ones, are left alone and their tile is marked. The largest network then
// tries again (OIT_SECOND_CHANCE), and marks what is left for Sort and Composite.

//VTK::OIT::Node
//VTK::OIT::Read
//VTK::OIT::Output

#define OIT_LOAD(i)                                                                                \
  uint key##i = OIT_NO_KEY;                                                                        \
  OITColor color##i = OITColor(0u);                                                                \
  if (node != OIT_END)                                                                             \
  {                                                                                                \
    OITFragment f = oitRead(node);                                                                 \
    key##i = f.Key;                                                                                \
    color##i = f.Color;                                                                            \
    node = f.Next;                                                                                 \
    ++count;                                                                                       \
  }

#define OIT_COMPARE_EXCHANGE(i, j)                                                                 \
  {                                                                                                \
    bool swap = key##j < key##i;                                                                   \
    uint nearKey = min(key##i, key##j);                                                            \
    key##j = max(key##i, key##j);                                                                  \
    key##i = nearKey;                                                                              \
    OITColor nearColor = swap ? color##j : color##i;                                               \
    color##j = swap ? color##i : color##j;                                                         \
    color##i = nearColor;                                                                          \
  }

#define OIT_NOTE_TIE(i, j) isTied = isTied || (key##i == key##j && key##i != OIT_NO_KEY);

#define OIT_BLEND(i)                                                                               \
  {                                                                                                \
    vec4 c = oitUnpack(color##i);                                                                  \
    float w = transmittance * c.a;                                                                 \
    color += w * c.rgb;                                                                            \
    transmittance -= w;                                                                            \
  }

#ifdef OIT_SECOND_CHANCE
flat in int oitNetworkSize; // of the first try
#else
// One pixel of four notes the largest number of fragments: atomics are slow on a CPU.
void oitNote(uint count, bool isLeft)
{
  float value = isLeft ? 64.0 : float(count); // above all networks
  ivec2 odd = ivec2(gl_FragCoord.xy) & 1;
  float dx = dFdx(value);
  value = max(value, odd.x == 0 ? value + dx : value - dx);
  float dy = dFdy(value);
  value = max(value, odd.y == 0 ? value + dy : value - dy);
  // At the lower and left edge of the rectangle, the even neighbour may be outside.
  bvec2 isEdge = equal(ivec2(gl_FragCoord.xy), oitCorner);
  // On the diagonal, the tile's two triangles see only their own pixels of the four.
  ivec2 place = ivec2(gl_FragCoord.xy) % OIT_TILE_SIZE;
  bool isBesideDiagonal = place.x != place.y && place.x / 2 == place.y / 2;
  if (value > 0.0 && (isBesideDiagonal || ((odd.x == 0 || isEdge.x) && (odd.y == 0 || isEdge.y))))
  {
    atomicMax(oitTiles[oitFindTile()].x, value < 64.0 ? uint(value) : OIT_TRY_AGAIN);
  }
}
#endif

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
#ifdef OIT_SECOND_CHANCE
  for (; node != OIT_END; ++count)
  {
    node = oitLoadNext(OIT_WORD(node));
  }
  atomicMax(oitTiles[oitFindTile()].y, count);
  if (isLeft)
  {
    imageStore(oitHeads, pixel, uvec4(head | OIT_LEFT));
    atomicOr(oitTiles[oitFindTile()].x, OIT_HAS_LISTS);
  }
  bool isMine = (isTied || count > uint(oitNetworkSize)) && !isLeft;
#else
  oitNote(count, isLeft);
  bool isMine = head != OIT_END && !isLeft;
#endif
  if (!isMine)
  {
    discard;
  }
  oitWrite(color, transmittance);
}
