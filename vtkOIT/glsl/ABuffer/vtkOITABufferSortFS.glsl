//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Sorts lists in place, of any length: for the pixels that Resolve left over, and (OIT_SORTS_ALL) for
// all pixels of multisampled framebuffers, which are composited once a sample, and of frames in which
// rays of volumes walk the lists. Writes no colour.
//
// A merge sort that relinks the nodes and needs no memory beside them: blocks of OIT_RUN nodes come out
// of a sorting network in registers, then neighbouring runs are merged. A block that lies behind or
// before all of its run is put at the end of it, so what was drawn front to back or back to front
// is one run from the start and not merged. One invocation merges runs of oitFirstWidth nodes up to
// oitLastWidth: software rasterizers limit the iterations of a shader's loops (llvmpipe: 65535
// together), so long lists take several draws.

//VTK::OIT::Node
//VTK::OIT::Read

uniform int oitFirstWidth;
uniform int oitLastWidth;

#define OIT_LOAD(i)                                                                                \
  OITFragment f##i = OIT_NO_FRAGMENT;                                                            \
  if (node != OIT_END)                                                                             \
  {                                                                                                \
    f##i = oitRead(node);                                                                          \
    uint next = f##i.Next;                                                                         \
    f##i.Next = node; /* from here on, the node itself */                                          \
    node = next;                                                                                   \
  }

#define OIT_COMPARE_EXCHANGE(i, j)                                                                 \
  if (oitIsBefore(f##j, f##i))                                                                     \
  {                                                                                                \
    OITFragment nearer = f##j;                                                                     \
    f##j = f##i;                                                                                   \
    f##i = nearer;                                                                                 \
  }

#define OIT_LINK(i)                                                                                \
  if (f##i.Next != OIT_END)                                                                        \
  {                                                                                                \
    if (i > 0)                                                                                     \
    {                                                                                              \
      oitStoreNext(OIT_WORD(last.Next), f##i.Next);                                                \
    }                                                                                              \
    last = f##i;                                                                                   \
  }

// Sorts blocks of nodes and joins them to runs. Runs are made of whole blocks but for the last one, so
// any nodes of a block's number from a multiple of that on are sorted. Returns the new head.
uint oitMakeRuns(uint head, out uint runs)
{
  uint node = head;
  uint tailBefore = OIT_END; // of the run before the current one
  // The ends of the current run.
  OITFragment nearest = OIT_NO_FRAGMENT;
  OITFragment farthest = nearest;
  runs = 0u;
  while (node != OIT_END)
  {
    //VTK::OIT::SortRun
    bool isLast = node == OIT_END; // so it may have fewer nodes
    if (runs > 0u && !oitIsBefore(f0, farthest))
    {
      oitStoreNext(OIT_WORD(farthest.Next), f0.Next);
      farthest = last;
    }
    else if (runs > 0u && !oitIsBefore(nearest, last) && (runs == 1u || !isLast))
    {
      oitStoreNext(OIT_WORD(last.Next), nearest.Next);
      nearest = f0;
    }
    else
    {
      if (runs == 1u)
      {
        head = nearest.Next;
      }
      else if (runs > 1u)
      {
        oitStoreNext(OIT_WORD(tailBefore), nearest.Next);
      }
      tailBefore = farthest.Next;
      nearest = f0;
      farthest = last;
      ++runs;
    }
  }
  if (runs == 1u)
  {
    head = nearest.Next;
  }
  else if (runs > 1u)
  {
    oitStoreNext(OIT_WORD(tailBefore), nearest.Next);
  }
  oitStoreNext(OIT_WORD(farthest.Next), OIT_END);
  return head;
}

// Merges neighbouring runs of `width` nodes. Returns the new head.
uint oitMergeRuns(uint head, uint width, out uint merges)
{
  uint first = head;
  uint tail = OIT_END;
  merges = 0u;
  while (first != OIT_END)
  {
    ++merges;
    uint second = first;
    uint firstSize = 0u;
    while (firstSize < width && second != OIT_END)
    {
      second = oitLoadNext(OIT_WORD(second));
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
  return head;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;
  uint head = imageLoad(oitHeads, pixel).x;
#ifdef OIT_SORTS_ALL
  uint mark = 0u;
  bool isMine = head != OIT_END;
#else
  uint mark = OIT_LEFT;
  bool isMine = (head & OIT_LEFT) != 0u;
#endif
  if (!isMine)
  {
    discard;
  }
  head &= ~mark;
  uint runs = 2u; // or more
  if (oitFirstWidth == OIT_RUN)
  {
    head = oitMakeRuns(head, runs);
  }
  for (uint width = uint(oitFirstWidth); width <= uint(oitLastWidth) && runs > 1u; width *= 2u)
  {
    head = oitMergeRuns(head, width, runs);
  }
  imageStore(oitHeads, pixel, uvec4(head | mark));
}
