// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// One fragment out of the pool, for the stages Sort, Resolve and Composite.

struct OITFragment
{
  uint Key;
  uint Mask;
  OITColor Color;
  uint Next;
};

OITFragment oitRead(uint node)
{
  uvec4 word = oitLoad(OIT_WORD(node));
#ifdef OIT_WIDE_NODES
  uvec4 color = oitLoad(2u * node + 1u);
#ifdef OIT_FLOAT_COLOR
  return OITFragment(word.x, word.y, color, word.w);
#else
  return OITFragment(word.x, word.y, color.xy, word.w);
#endif
#else
  return OITFragment(word.x, 0u, word.yz, word.w);
#endif
}
