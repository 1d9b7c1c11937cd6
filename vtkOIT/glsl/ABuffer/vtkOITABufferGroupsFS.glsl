// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Groups of fragments, for the stages Composite and Merge, which have them in order.
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

#define OIT_DECLARE_GROUP                                                                          \
  float rest = 0.0; /* what rounding took from the transmittance */                                \
  uint key = OIT_NO_KEY; /* of the group so far */                                                 \
  float opacity = 0.0;                                                                             \
  float weight = 0.0;                                                                              \
  vec3 weighted = vec3(0.0);                                                                       \
  uint members = 0u;                                                                               \
  vec3 latest = vec3(0.0);                                                                         \
  uint groups = 0u;                                                                                \
  vec3 light = vec3(0.0);

#define OIT_BEGIN_GROUP(newKey)                                                                    \
  key = newKey;                                                                                    \
  opacity = 0.0;                                                                                   \
  weight = 0.0;                                                                                    \
  weighted = vec3(0.0);                                                                            \
  members = 0u;                                                                                    \
  light = vec3(0.0);

#define OIT_ADD_COVER(c)                                                                           \
  opacity += (1.0 - opacity) * c.a;                                                                \
  weight += c.a;                                                                                   \
  weighted += c.a * c.rgb;                                                                         \
  latest = c.rgb;                                                                                  \
  ++members;

#ifdef OIT_HAS_LIGHT
#define OIT_ADD_TO_GROUP(c)                                                                        \
  light += oitGetAdded(c);                                                                         \
  if (c.a <= 1.0)                                                                                  \
  {                                                                                                \
    OIT_ADD_COVER(c)                                                                               \
  }
#else
#define OIT_ADD_TO_GROUP(c) OIT_ADD_COVER(c)
#endif
