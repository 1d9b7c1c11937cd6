//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve: sort the fragments of the pixel by depth and composite them front to back,
// C += T alpha c, T -= T alpha, over what the framebuffer holds.
//
// Up to 32 fragments are sorted in registers by an odd-even merge network (Batcher, Sorting
// networks and their applications, AFIPS 1968), which a CPU runs for eight pixels at once without
// a branch. The text of the networks is generated: //VTK::OIT::Load*, Sort*.

//VTK::OIT::Node
//VTK::OIT::Sort

#ifdef OIT_FRAMEBUFFER_FETCH
inout vec4 oitTarget;
#else
out vec4 oitTarget;
#endif

// Always 1. A loop that runs oitOnce times is a branch that llvmpipe skips when none of its eight
// pixels takes it; an `if` is executed always there. Elsewhere it is as good as an `if`.
uniform int oitOnce;
#define OIT_IF_ANY(condition) for (int once_ = oitOnce; once_ > 0 && (condition); --once_)

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

#define OIT_NOTE_TIE(i, j) tied = tied || (key##i == key##j && key##i != OIT_NO_KEY);

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
  // After an overflow the frame is rendered again: nothing may be drawn now.
  if (head == OIT_END || oitOverflow != 0u)
  {
    discard;
  }

  vec3 color = vec3(0.0);
  float transmittance = 1.0;
#if OIT_SAMPLES > 0
  oitCompositeList(head, 1u << uint(gl_SampleID), color, transmittance); // sorted by Sort
#else
  uint node = head;
  uint count = 0u;
  bool tied = false;
  //VTK::OIT::Registers
  OIT_IF_ANY(tied || node != OIT_END)
  {
    color = vec3(0.0);
    transmittance = 1.0;
    for (; node != OIT_END; ++count)
    {
      node = oitLoad(OIT_WORD(node)).w;
    }
    oitCompositeList(oitSortList(head), 0u, color, transmittance);
  }
  OIT_IF_ANY(count > oitMaximumDepthComplexity)
  {
    atomicMax(oitMaximumDepthComplexity, count);
  }
#endif

#ifdef OIT_FRAMEBUFFER_FETCH
  oitTarget = vec4(color, 1.0 - transmittance) + transmittance * oitTarget;
#else
  oitTarget = vec4(color, 1.0 - transmittance);
#endif
}
