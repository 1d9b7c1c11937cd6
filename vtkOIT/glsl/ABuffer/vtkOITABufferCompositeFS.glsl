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
#define oitGetColorOf(fragment, node) oitLightNode(oitLoad(OIT_WORD(node)), oitLoad(OIT_WORD(node) + 1u))
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
