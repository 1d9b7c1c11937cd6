// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Fragments in registers, for the stages Resolve and SecondChance: variables key0, color0, key1 and
// so on. The text that loads, sorts and blends them is generated. Variables of the stage: the next
// node, count of loaded ones, isTied; color and transmittance of what is composited.
//
// With OIT_DEFERRED a register holds the node of a fragment instead of its colour, and blending puts it
// into an array: one loop lights what is seen, in order.

#ifdef OIT_DEFERRED
#define OITKept uint
#define OIT_READ(i)                                                                                \
  color##i = OIT_WORD(node);                                                                       \
  key##i = oitLoadKey(color##i);                                                                   \
  node = oitLoadNext(color##i);
#else
#define OITKept OITColor
#define OIT_READ(i)                                                                                \
  OITFragment f = oitRead(node);                                                                   \
  key##i = f.Key;                                                                                  \
  color##i = f.Color;                                                                              \
  node = f.Next;
#endif

#define OIT_DECLARE(i)                                                                             \
  uint key##i = OIT_NO_KEY;                                                                        \
  OITKept color##i = OITKept(0u);

#define OIT_LOAD(i)                                                                                \
  key##i = OIT_NO_KEY;                                                                             \
  color##i = OITKept(0u);                                                                          \
  if (node != OIT_END)                                                                             \
  {                                                                                                \
    OIT_READ(i)                                                                                    \
    ++count;                                                                                       \
  }

#define OIT_COMPARE_EXCHANGE(i, j)                                                                 \
  {                                                                                                \
    bool swap = key##j < key##i;                                                                   \
    uint nearKey = min(key##i, key##j);                                                            \
    key##j = max(key##i, key##j);                                                                  \
    key##i = nearKey;                                                                              \
    OITKept nearColor = swap ? color##j : color##i;                                               \
    color##j = swap ? color##i : color##j;                                                         \
    color##i = nearColor;                                                                          \
  }

#define OIT_NOTE_TIE(i, j) isTied = isTied || (key##i == key##j && key##i != OIT_NO_KEY);

// Composites, front to back. Lists of more than OIT_LONG_LIST fragments end at the threshold, as in
// Composite; without it there are none in registers.
#if defined(OIT_ENDS_LONG_LISTS) || defined(OIT_DEFERRED)
uniform float oitThreshold; // of the transmittance
#endif
#ifdef OIT_ENDS_LONG_LISTS
#define OIT_IS_AT_END (count > uint(OIT_LONG_LIST) && transmittance <= oitThreshold)
#else
#define OIT_IS_AT_END false
#endif

#ifdef OIT_HAS_LIGHT
#define OIT_ADD_LIGHT(c) color += (OIT_IS_AT_END ? 0.0 : transmittance) * oitGetAdded(c);
#else
#define OIT_ADD_LIGHT(c)
#endif

#ifdef OIT_DEFERRED
#define OIT_BLEND(i) sorted[i] = color##i;
#else
#define OIT_BLEND(i)                                                                               \
  {                                                                                                \
    vec4 c = oitUnpack(color##i);                                                                  \
    OIT_ADD_LIGHT(c)                                                                               \
    float w = OIT_IS_AT_END ? 0.0 : transmittance * oitGetCover(c);                                \
    color += w * c.rgb;                                                                            \
    transmittance -= w;                                                                            \
  }
#endif
