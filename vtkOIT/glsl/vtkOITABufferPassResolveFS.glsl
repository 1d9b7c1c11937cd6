//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve for tiles of up to OIT_NETWORK_SIZE fragments a pixel: load them into registers, sort
// them by depth with an odd-even merge network (Batcher, Sorting networks and their applications,
// AFIPS 1968), which a CPU runs for eight pixels at once without a branch, and composite them
// front to back, C += T alpha c, T -= T alpha. The text of the network is generated.
//
// Pixels with coincident fragments are left alone and marked: Sort and Composite do them.

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
  uint node = head;
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  bool isTied = false;
  //VTK::OIT::Registers
  if (isTied)
  {
    imageStore(oitHeads, pixel, uvec4(head | OIT_TIED));
    atomicOr(oitTiles[oitFindTile()], OIT_TIED);
  }
  if (isTied || head == OIT_END)
  {
    discard;
  }
  oitWrite(color, transmittance);
}
