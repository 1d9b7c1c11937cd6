// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The general way to resolve a pixel: any number of fragments, coincident ones, single samples.
// Slower than a sorting network in registers, so Resolve takes it only where that is needed.

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

// A total order: fragments that still compare equal are the same, so that the picture does not
// depend on the order in which they were drawn, to the last bit.
bool oitIsBefore(OITFragment a, OITFragment b)
{
  if (a.Key != b.Key) return a.Key < b.Key;
  if (a.Color.x != b.Color.x) return a.Color.x < b.Color.x;
#ifdef OIT_FLOAT_COLOR
  if (a.Color.y != b.Color.y) return a.Color.y < b.Color.y;
  if (a.Color.z != b.Color.z) return a.Color.z < b.Color.z;
  return a.Color.w < b.Color.w;
#else
  return a.Color.y < b.Color.y;
#endif
}

// Bottom-up merge sort: relinks the nodes, needs no memory beside them.
uint oitSortList(uint head)
{
  for (uint width = 1u;; width *= 2u)
  {
    uint first = head;
    uint tail = OIT_END;
    uint merges = 0u;
    while (first != OIT_END)
    {
      ++merges;
      uint second = first;
      uint firstSize = 0u;
      while (firstSize < width && second != OIT_END)
      {
        second = oitLoad(OIT_WORD(second)).w;
        ++firstSize;
      }
      uint secondSize = second == OIT_END ? 0u : width;
      OITFragment a = oitRead(first);
      OITFragment b = a;
      if (secondSize > 0u)
      {
        b = oitRead(second);
      }
      while (firstSize + secondSize > 0u)
      {
        uint node = first;
        if (firstSize == 0u || (secondSize > 0u && oitIsBefore(b, a)))
        {
          node = second;
          second = b.Next;
          secondSize = second == OIT_END ? 0u : secondSize - 1u;
          if (secondSize > 0u)
          {
            b = oitRead(second);
          }
        }
        else
        {
          first = a.Next;
          --firstSize;
          if (firstSize > 0u)
          {
            a = oitRead(first);
          }
        }
        if (tail == OIT_END)
        {
          head = node;
        }
        else
        {
          oitStoreNext(OIT_WORD(tail), node);
        }
        tail = node;
      }
      first = second;
    }
    oitStoreNext(OIT_WORD(tail), OIT_END);
    if (merges <= 1u)
    {
      return head;
    }
  }
  return head;
}

// Composites a sorted list front to back. Fragments of one depth form a group, each counted once:
// the group's opacity is 1 - prod(1 - alpha), its colour the mean weighted by alpha.
void oitCompositeList(uint node, uint sampleBit, inout vec3 color, inout float transmittance)
{
  while (node != OIT_END)
  {
    OITFragment fragment = oitRead(node);
    uint key = fragment.Key;
    float opacity = 0.0;
    float weight = 0.0;
    vec3 weighted = vec3(0.0);
    uint members = 0u;
    bool isMember = true;
    while (isMember)
    {
      if (sampleBit == 0u || (fragment.Mask & sampleBit) != 0u)
      {
        vec4 c = oitUnpack(fragment.Color);
        opacity += (1.0 - opacity) * c.a;
        weight += c.a;
        weighted += c.a * c.rgb;
        ++members;
      }
      node = fragment.Next;
      isMember = node != OIT_END;
      if (isMember)
      {
        fragment = oitRead(node);
        isMember = fragment.Key == key;
      }
    }
    if (members > 1u)
    {
      weighted *= opacity / weight;
    }
    color += transmittance * weighted;
    transmittance -= transmittance * opacity;
  }
}
