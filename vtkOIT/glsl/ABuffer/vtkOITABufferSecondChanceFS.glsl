//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// SecondChance: for pixels that Resolve left, in the tiles that it marked, with a network of
// OIT_LONG_LIST fragments. Also the first try of tiles that are expected to have more than Resolve takes.
//
// Longer lists are read to their end, keeping the nearest OIT_KEPT fragments: as long as the
// transmittance behind them is at most the threshold, which 0 is when one of them has opacity 1,
// others are not seen. Otherwise, and for coincident fragments, the pixel is marked for Sort and
// Composite. So the picture does not depend on the order of drawing: a list of more than
// OIT_LONG_LIST fragments is composited up to the first at which the threshold is reached, here
// or there.
//
// Walk, in place of this and of Resolve while their networks are not compiled, is the same with other
// text in registers: it walks each list several times, and keeps the nearest fragments behind those
// that it has blended.

//VTK::OIT::Node
//VTK::OIT::Read
//VTK::OIT::Output
//VTK::OIT::RegisterMacros

flat in int oitNetworkSize; // of the first try; -1: this is the first

// As it is blended, to the bit; not the last one kept, which might coincide with one that was not.
#define OIT_THIN(i) thin -= thin * oitGetCover(oitUnpack(color##i));

// What is not one of the nearest of a long list.
#define OIT_FORGET(i)                                                                              \
  key##i = isLong ? OIT_NO_KEY : key##i;                                                           \
  color##i = isLong ? OITColor(0u) : color##i;

#define OIT_RESET(i)                                                                               \
  key##i = OIT_NO_KEY;                                                                             \
  color##i = OITColor(0u);

// Of a fragment and the one kept at place i the nearer one stays, the other one goes on.
#define OIT_INSERT(i)                                                                              \
  {                                                                                                \
    bool isNearer = key < key##i;                                                                  \
    uint nearKey = min(key, key##i);                                                               \
    key = max(key, key##i);                                                                        \
    key##i = nearKey;                                                                              \
    OITColor nearColor = isNearer ? fresh : color##i;                                              \
    fresh = isNearer ? color##i : fresh;                                                           \
    color##i = nearColor;                                                                          \
  }

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;
  uint head = imageLoad(oitHeads, pixel).x;
  bool wasLeft = head != OIT_END && (head & OIT_LEFT) != 0u; // by the network for long lists
  head = wasLeft ? head & ~OIT_LEFT : head;
  uint node = head;
  uint count = 0u;
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  float thin = 1.0; // transmittance behind the nearest
  bool isTied = false;
  bool isLong = false;
  //VTK::OIT::Registers
  bool isHard = isTied || node != OIT_END || (isLong && thin > oitThreshold);
  for (; node != OIT_END; ++count)
  {
    node = oitLoadNext(OIT_WORD(node));
  }
  atomicMax(oitTiles[oitFindTile()].Marked, count);
  bool wasIncomplete = int(count) > oitNetworkSize;
  if (wasIncomplete)
  {
    atomicMax(oitTiles[oitFindTile()].Complexity, count); // of no effect on marks
    atomicAdd(oitTiles[oitFindTile()].Fragments, count);
  }
  // A long list that the network for long lists has composited, in a tile with others that it left.
  bool isDone = count > uint(OIT_LONG_LIST) && !wasIncomplete && !wasLeft;
  bool isLeft = isHard && !isDone;
  if (isLeft)
  {
    imageStore(oitHeads, pixel, uvec4(head | OIT_LEFT));
    atomicOr(oitTiles[oitFindTile()].Complexity, OIT_HAS_LISTS);
  }
  else if (wasLeft)
  {
    imageStore(oitHeads, pixel, uvec4(head));
  }
  if (isLeft || isDone || !(isTied || wasIncomplete || wasLeft) || head == OIT_END)
  {
    discard;
  }
  if (isLong && transmittance > 0.0)
  {
    atomicMax(oitSkipped, floatBitsToUint(transmittance));
  }
  oitWrite(color, transmittance);
}
