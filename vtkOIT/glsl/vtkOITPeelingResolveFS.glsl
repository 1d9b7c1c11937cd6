//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, for depth peeling and dual depth peeling: the group peeled from the front goes under
// what is in front, the one peeled from the back over what is behind (Bavoil and Myers 2008).

//VTK::OIT::State
//VTK::OIT::Group

uniform sampler2DArray oitSums; // the buffers of Gather
uniform int oitRest;

OITGroup oitLoadGroup(vec4 color, vec4 sums)
{
  return OITGroup(color.rgb, sums.x, sums.y, sums.z);
}

vec4 oitLoadSums(int layer)
{
  return texelFetch(oitSums, ivec3(gl_FragCoord.xy, layer), 0);
}

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
  vec4 color = oitLoadSums(0);
  vec4 sums = oitLoadSums(1);
  OITGroup front = oitLoadGroup(color, sums);
  float opacity = oitGetGroupOpacity(front);
  if (oitRest != 0 && front.Count > 1.5)
  {
    oitNoteError(oitState0.a * opacity);
  }
  oitBlendUnder(oitGetGroupColor(front, opacity), opacity);
  oitState1.x += front.Count;
#ifdef OIT_DUAL
  OIT_LOAD_STATE(3)
  OITGroup back = oitLoadGroup(oitLoadSums(2), oitLoadSums(3));
  float backOpacity = oitGetGroupOpacity(back);
  oitBlendOver(oitGetGroupColor(back, backOpacity), backOpacity);
  oitState1.x += back.Count;
#endif
  oitSetBounds(-color.a, sums.a);
}
