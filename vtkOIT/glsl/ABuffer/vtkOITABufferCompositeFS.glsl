//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Composites the lists that Sort has sorted, front to back: C += T alpha c, T -= T alpha. Runs once
// a sample in multisampled framebuffers.
//
// Fragments of one depth form a group, in which each counts once: the group's opacity is
// 1 - prod(1 - alpha), its colour the mean of the members weighted by alpha; light lies on top of it.
// With OIT_LAST_ON_TOP each fragment is a group of its own: Sort has the last drawn before the others.
//
// The rounding error of T -= T alpha is kept and added again (Kahan, Further remarks on reducing
// truncation errors, CACM 1965): a thousand layers of opacity 1e-6 would be 1 % off without. Not for
// the first 64, which are blended as Resolve would: what it has behind a group of opacity 1, or has
// not, does not change the picture then. Nothing is seen behind such a group, so it ends the walk,
// as does a transmittance of at most the threshold.
//
// With OIT_DEFERRED fragments are lit here, in this order: what is not seen is not lit.

//VTK::OIT::Node
//VTK::OIT::Read
//VTK::OIT::Output

#ifdef OIT_DEFERRED
//VTK::OIT::Light
#define oitGetColorOf(fragment, node) oitLightNode(oitLoad(OIT_WORD(node)), oitLoad(OIT_WORD(node) + 1u))
#else
#define oitGetColorOf(fragment, node) oitUnpack(fragment.Color)
#endif

#if OIT_SAMPLES > 0
#define OIT_IS_COVERED(fragment) (((fragment.Mask >> uint(gl_SampleID)) & 1u) != 0u)
#else
#define OIT_IS_COVERED(fragment) true
#endif

// The sum, and what rounding took from it. A function of its own: glslangValidator, the reference
// compiler, does not end where `precise` stands in a loop.
vec2 oitAdd(float value, float change)
{
  precise float sum = value + change;
  precise float rest = change - (sum - value);
  return vec2(sum, rest);
}

#ifdef OIT_HAS_LIGHT
#define OIT_ADD_LIGHT color += transmittance * light;
#else
#define OIT_ADD_LIGHT
#endif

#define OIT_BLEND_GROUP                                                                            \
  {                                                                                                \
    OIT_ADD_LIGHT                                                                                  \
    float w = transmittance * opacity;                                                             \
    color += members > 1u ? transmittance * (weighted * (opacity / weight)) : w * latest;          \
    vec2 sum = oitAdd(transmittance, rest - w);                                                    \
    ++groups;                                                                                      \
    rest = groups > OIT_PLAIN_GROUPS && opacity < 1.0 ? sum.y : 0.0;                               \
    transmittance = opacity < 1.0 ? sum.x : 0.0;                                                   \
  }

const uint OIT_PLAIN_GROUPS = 64u; // the first is empty; the error of the last one counts behind it

uniform float oitThreshold; // of the transmittance

void main()
{
  uint node = imageLoad(oitHeads, ivec2(gl_FragCoord.xy) - oitOrigin).x;
#if OIT_SAMPLES > 0
  bool isMine = node != OIT_END;
#ifdef OIT_VOLUMES
  uint taken = oitLoad(OIT_WORD(node)).z; // samples in which a volume's ray was here
  isMine = isMine && ((taken >> uint(gl_SampleID)) & 1u) == 0u;
#endif
#elif defined(OIT_VOLUMES)
  bool isMine = node != OIT_END && (node & OIT_LEFT) == 0u; // marked: a volume's ray was here
#else
  bool isMine = (node & OIT_LEFT) != 0u;
  node &= ~OIT_LEFT;
#endif
  if (!isMine)
  {
    discard;
  }

#ifdef OIT_DEFERRED
  oitBeginLight();
#endif
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  float rest = 0.0; // what rounding took from the transmittance
  // The group so far, and its depth.
  uint key = OIT_NO_KEY;
  float opacity = 0.0;
  float weight = 0.0;
  vec3 weighted = vec3(0.0);
  uint members = 0u;
  vec3 latest = vec3(0.0);
  uint groups = 0u;
#ifdef OIT_HAS_LIGHT
  vec3 light = vec3(0.0);
#endif
  while (node != OIT_END && transmittance > oitThreshold)
  {
    OITFragment fragment = oitRead(node);
    uint current = node;
    node = fragment.Next;
    if (OIT_IS_COVERED(fragment))
    {
      if (!OIT_IS_OF_GROUP(fragment))
      {
        OIT_BLEND_GROUP
        key = fragment.Key;
        opacity = 0.0;
        weight = 0.0;
        weighted = vec3(0.0);
        members = 0u;
#ifdef OIT_HAS_LIGHT
        light = vec3(0.0);
#endif
      }
      vec4 c = oitGetColorOf(fragment, current);
#ifdef OIT_HAS_LIGHT
      light += oitGetAdded(c);
      if (c.a > 1.0)
      {
        continue;
      }
#endif
      opacity += (1.0 - opacity) * c.a;
      weight += c.a;
      weighted += c.a * c.rgb;
      latest = c.rgb;
      ++members;
    }
  }
  if (transmittance > oitThreshold)
  {
    OIT_BLEND_GROUP
  }
  else if (transmittance > 0.0)
  {
    atomicMax(oitSkipped, floatBitsToUint(transmittance));
  }
  oitWrite(color, transmittance);
}
