//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, for depth peeling and dual depth peeling: the group peeled from the front goes under
// what is in front, the one peeled from the back over what is behind (Bavoil and Myers 2008).

//VTK::OIT::State
//VTK::OIT::Group

uniform sampler2DArray oitSums; // the colour buffers of Gather, without oitDepths
uniform int oitRest;

vec4 oitLoadSums(int layer)
{
  return texelFetch(oitSums, ivec3(gl_FragCoord.xy, layer), 0);
}

#ifdef OIT_JOINT_BLENDING
OITGroup oitLoadFront()
{
  vec4 sums = oitLoadSums(1);
  return OITGroup(oitLoadSums(0).rgb, sums.x, sums.y, sums.z);
}
OITGroup oitLoadBack()
{
  vec4 sums = oitLoadSums(3);
  return OITGroup(oitLoadSums(2).rgb, sums.x, sums.y, sums.z);
}
vec2 oitLoadDepths()
{
  return vec2(oitLoadSums(0).a, oitLoadSums(1).a);
}
#else
uniform sampler2DArray oitDepths;
OITGroup oitLoadFront()
{
  return OITGroup(oitLoadSums(0).rgb, oitLoadSums(0).a, oitLoadSums(1).x, oitLoadSums(1).y);
}
OITGroup oitLoadBack()
{
  return OITGroup(oitLoadSums(2).rgb, oitLoadSums(2).a, oitLoadSums(1).z, oitLoadSums(1).w);
}
vec2 oitLoadDepths()
{
  return texelFetch(oitDepths, ivec3(gl_FragCoord.xy, 0), 0).xy;
}
#endif

#ifdef OIT_DUAL
OIT_STATE_LAYER(3) // colour and transmittance of the layers peeled from the back

void oitBlendOver(vec3 color, float opacity)
{
  oitState3.rgb += color - opacity * oitState3.rgb;
  oitState3.a -= opacity * oitState3.a;
}
#endif

void main()
{
  oitLoadCommonState();
  OITGroup front = oitLoadFront();
  float opacity = oitGetGroupOpacity(front);
  if (oitRest != 0 && front.Count > 1.5)
  {
    oitNoteError(oitState0.a * opacity);
  }
  oitBlendUnder(oitGetGroupColor(front, opacity), opacity);
  oitState1.x += front.Count;
#ifdef OIT_DUAL
  OIT_LOAD_STATE(3)
  OITGroup back = oitLoadBack();
  float backOpacity = oitGetGroupOpacity(back);
  oitBlendOver(oitGetGroupColor(back, backOpacity), backOpacity);
  oitState1.x += back.Count;
#endif
  vec2 depths = oitLoadDepths();
  oitSetBounds(-depths.x, depths.y);
}
