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
// fragments, or coincident ones, are left alone and marked. The largest network then tries again
// (OIT_SECOND_CHANCE), and what is still marked is for Sort and Composite.

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

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;
  uint head = imageLoad(oitHeads, pixel).x;
#ifdef OIT_SECOND_CHANCE
  uint node = (head & OIT_LEFT) != 0u ? head & ~OIT_LEFT : OIT_END;
#else
  uint node = head;
#endif
  bool isEmpty = node == OIT_END;
  uint count = 0u;
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  bool isTied = false;
  //VTK::OIT::Registers
  bool isLeft = isTied || node != OIT_END;
#ifdef OIT_SECOND_CHANCE
  if (!isEmpty && !isLeft)
  {
    imageStore(oitHeads, pixel, uvec4(head & ~OIT_LEFT));
  }
#else
  for (; node != OIT_END; ++count)
  {
    node = oitLoadNext(OIT_WORD(node));
  }
  if (isLeft)
  {
    imageStore(oitHeads, pixel, uvec4(head | OIT_LEFT));
    oitTiles[oitFindTile()].y = 1u;
  }
  if (!isEmpty)
  {
    atomicMax(oitTiles[oitFindTile()].x, count);
  }
#endif
  if (isEmpty || isLeft)
  {
    discard;
  }
  oitWrite(color, transmittance);
}
