//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Merge: in place of Sort and Composite, for lists of up to OIT_MERGED_RUNS runs of OIT_RUN fragments that
// Resolve left over. Each fragment is read twice and written once, however long the list: a merge sort of two
// runs at a time goes over the list once more whenever it is twice as long.
//
// Fragments of a run come out of a sorting network in registers, and go back into the run's nodes in order,
// so the links stay. Then the nearest ones of all runs are in registers: the nearest of these is composited,
// and the next one of its run loaded. Ends where nothing is seen behind, as Composite does.

//VTK::OIT::Node
//VTK::OIT::Read
//VTK::OIT::Output

//VTK::OIT::Groups

uniform float oitThreshold; // of the transmittance

void oitRewrite(uint node, OITFragment fragment, uint next)
{
  if (node != OIT_END)
  {
#ifdef OIT_FLOAT_COLOR
    oitStore(OIT_WORD(node), uvec4(fragment.Key, 0u, 0u, next));
    oitStore(OIT_WORD(node) + 1u, fragment.Color);
#else
    oitStore(OIT_WORD(node), uvec4(fragment.Key, fragment.Color, next));
#endif
  }
}

// A run in registers, and its nodes in the order of the list.
#define OIT_LOAD(i)                                                                                \
  uint node##i = node;                                                                             \
  OITFragment f##i = OIT_NO_FRAGMENT;                                                              \
  if (node != OIT_END)                                                                             \
  {                                                                                                \
    f##i = oitRead(node);                                                                          \
    node = f##i.Next;                                                                              \
  }

#define OIT_COMPARE_EXCHANGE(i, j)                                                                 \
  {                                                                                                \
    bool swap = oitIsBefore(f##j, f##i);                                                           \
    uint nearKey = swap ? f##j.Key : f##i.Key;                                                     \
    f##j.Key = swap ? f##i.Key : f##j.Key;                                                         \
    f##i.Key = nearKey;                                                                            \
    OITColor nearColor = swap ? f##j.Color : f##i.Color;                                           \
    f##j.Color = swap ? f##i.Color : f##j.Color;                                                   \
    f##i.Color = nearColor;                                                                        \
  }

#define OIT_REWRITE(i, j) oitRewrite(node##i, f##i, node##j);

// Of each run: its first node, the nearest fragment that is left, and the node behind it.
#define OIT_DECLARE_RUN(i)                                                                         \
  uint start##i = OIT_END;                                                                         \
  uint next##i = OIT_END;                                                                          \
  OITFragment nearest##i = OIT_NO_FRAGMENT;

#define OIT_START_RUN(i)                                                                           \
  start##i = runs == uint(i) ? node : start##i;                                                    \
  next##i = start##i;

#define OIT_CHOOSE(i) at = run == uint(i) ? next##i : at;

// `j`: the run that lies behind in the list.
#define OIT_TAKE(i, j)                                                                             \
  {                                                                                                \
    bool isThis = run == uint(i);                                                                  \
    nearest##i.Key = isThis ? loaded.Key : nearest##i.Key;                                         \
    nearest##i.Color = isThis ? loaded.Color : nearest##i.Color;                                   \
    next##i = isThis ? (loaded.Next == start##j ? OIT_END : loaded.Next) : next##i;                \
  }

#define OIT_COMPARE(i)                                                                             \
  {                                                                                                \
    bool isBefore = oitIsBefore(nearest##i, fragment);                                             \
    run = isBefore ? uint(i) : run;                                                                \
    fragment.Key = isBefore ? nearest##i.Key : fragment.Key;                                       \
    fragment.Color = isBefore ? nearest##i.Color : fragment.Color;                                 \
  }

void main()
{
  uint node = imageLoad(oitHeads, ivec2(gl_FragCoord.xy) - oitOrigin).x;
  bool isMine = (node & OIT_LEFT) != 0u;
  node &= ~OIT_LEFT;
  if (!isMine)
  {
    discard;
  }
  node = isMine ? node : OIT_END; // pixels that are discarded run along
  uint runs = 0u;
  //VTK::OIT::MergeDeclare
  while (node != OIT_END)
  {
    //VTK::OIT::MergeRun
    ++runs;
  }
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  OIT_DECLARE_GROUP
  uint run = 0u;
  uint loads = 0u;
  OITFragment fragment = OIT_NO_FRAGMENT;
  // Loads the nearest one of each run, then of the run from which one was taken.
  do
  {
    uint at = OIT_END;
    //VTK::OIT::MergeLoad
    ++loads;
    run = loads;
    if (loads >= runs)
    {
      fragment = OIT_NO_FRAGMENT;
      //VTK::OIT::MergeCompare
      if (fragment.Key != key)
      {
        OIT_BLEND_GROUP
        OIT_BEGIN_GROUP(fragment.Key)
      }
      vec4 c = oitUnpack(fragment.Color);
      OIT_ADD_TO_GROUP(c)
    }
  } while (loads < runs || (fragment.Key != OIT_NO_KEY && transmittance > oitThreshold));
  if (fragment.Key != OIT_NO_KEY && transmittance > 0.0)
  {
    atomicMax(oitSkipped, floatBitsToUint(transmittance));
  }
  oitWrite(color, transmittance);
}
