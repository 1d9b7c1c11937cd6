//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Composites the lists that Sort has sorted, front to back: C += T alpha c, T -= T alpha. Runs once
// a sample in multisampled framebuffers.
//
// Fragments of one depth form a group, in which each counts once: the group's opacity is
// 1 - prod(1 - alpha), its colour the mean of the members weighted by alpha.
//
// The rounding error of T -= T alpha is kept and added again (Kahan, Further remarks on reducing
// truncation errors, CACM 1965): a thousand layers of opacity 1e-6 would be 1 % off without.

//VTK::OIT::Node
//VTK::OIT::Read
//VTK::OIT::Output

#if OIT_SAMPLES > 0
#define OIT_IS_COVERED(fragment) (((fragment.Mask >> uint(gl_SampleID)) & 1u) != 0u)
#else
#define OIT_IS_COVERED(fragment) true
#endif

#define OIT_BLEND_GROUP                                                                            \
  {                                                                                                \
    color += transmittance * (members > 1u ? weighted * (opacity / weight) : weighted);            \
    precise float change = rest - transmittance * opacity;                                         \
    precise float sum = transmittance + change;                                                    \
    rest = change - (sum - transmittance);                                                         \
    transmittance = sum;                                                                           \
  }

void main()
{
  uint node = imageLoad(oitHeads, ivec2(gl_FragCoord.xy) - oitOrigin).x;
#if OIT_SAMPLES > 0
  bool isMine = node != OIT_END;
#else
  bool isMine = (node & OIT_LEFT) != 0u;
  node &= ~OIT_LEFT;
#endif
  if (!isMine)
  {
    discard;
  }

  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  float rest = 0.0; // what rounding took from the transmittance
  // The group so far, and its depth.
  uint key = OIT_NO_KEY;
  float opacity = 0.0;
  float weight = 0.0;
  vec3 weighted = vec3(0.0);
  uint members = 0u;
  while (node != OIT_END)
  {
    OITFragment fragment = oitRead(node);
    node = fragment.Next;
    if (OIT_IS_COVERED(fragment))
    {
      if (fragment.Key != key)
      {
        OIT_BLEND_GROUP
        key = fragment.Key;
        opacity = 0.0;
        weight = 0.0;
        weighted = vec3(0.0);
        members = 0u;
      }
      vec4 c = oitUnpack(fragment.Color);
      opacity += (1.0 - opacity) * c.a;
      weight += c.a;
      weighted += c.a * c.rgb;
      ++members;
    }
  }
  OIT_BLEND_GROUP
  oitWrite(color, transmittance);
}
