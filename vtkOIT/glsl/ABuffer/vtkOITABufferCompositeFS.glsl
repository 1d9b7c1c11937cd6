//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Composites the lists that Sort has sorted, front to back: C += T alpha c, T -= T alpha. Runs once
// a sample in multisampled framebuffers. Groups: vtkOITABufferGroupsFS.glsl.
//
// With OIT_DEFERRED fragments are lit here, in this order: what is not seen is not lit.

//VTK::OIT::Node
//VTK::OIT::Read
//VTK::OIT::Output

#ifdef OIT_DEFERRED
//VTK::OIT::Light
vec4 oitGetColorOf(OITFragment fragment, uint node)
{
  OITMaterial m = oitUnpackMaterial(fragment.Color, oitLoad(OIT_WORD(node) + 1u));
  vec3 color = oitLight(m, uintBitsToFloat(fragment.Key));
#ifdef OIT_CLAMP_COLOR
  const float largest = 1.0;
#else
  const float largest = 65504.0; // of what is stored shaded
#endif
  return vec4(min(max(color, 0.0), largest), oitUnpack(uvec2(fragment.Color.x)).r);
}
#else
#define oitGetColorOf(fragment, node) oitUnpack(fragment.Color)
#endif

#if OIT_SAMPLES > 0
#define OIT_IS_COVERED(fragment) (((fragment.Mask >> uint(gl_SampleID)) & 1u) != 0u)
#else
#define OIT_IS_COVERED(fragment) true
#endif

//VTK::OIT::Groups

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
#elif defined(OIT_DEFERRED)
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
  OIT_DECLARE_GROUP
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
        OIT_BEGIN_GROUP(fragment.Key)
      }
      vec4 c = oitGetColorOf(fragment, current);
      OIT_ADD_TO_GROUP(c)
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
