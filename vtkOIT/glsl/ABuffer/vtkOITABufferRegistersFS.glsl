// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Fragments in registers, for the stages Resolve and SecondChance: variables key0, color0, key1 and
// so on. The text that loads, sorts and blends them is generated. Variables of the stage: the next
// node, count of loaded ones, isTied; color and transmittance of what is composited.

#define OIT_DECLARE(i)                                                                             \
  uint key##i = OIT_NO_KEY;                                                                        \
  OITColor color##i = OITColor(0u);

#define OIT_LOAD(i)                                                                                \
  key##i = OIT_NO_KEY;                                                                             \
  color##i = OITColor(0u);                                                                         \
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

// Composites, front to back. Lists of more than OIT_LONG_LIST fragments end at the threshold, as in
// Composite; without it there are none in registers.
#ifdef OIT_ENDS_LONG_LISTS
uniform float oitThreshold; // of the transmittance
#define OIT_IS_AT_END (count > uint(OIT_LONG_LIST) && transmittance <= oitThreshold)
#else
#define OIT_IS_AT_END false
#endif

#ifdef OIT_HAS_LIGHT
#define OIT_ADD_LIGHT(c) color += (OIT_IS_AT_END ? 0.0 : transmittance) * oitGetAdded(c);
#else
#define OIT_ADD_LIGHT(c)
#endif

#define OIT_BLEND(i)                                                                               \
  {                                                                                                \
    vec4 c = oitUnpack(color##i);                                                                  \
    OIT_ADD_LIGHT(c)                                                                               \
    float w = OIT_IS_AT_END ? 0.0 : transmittance * oitGetCover(c);                                \
    color += w * c.rgb;                                                                            \
    transmittance -= w;                                                                            \
  }
