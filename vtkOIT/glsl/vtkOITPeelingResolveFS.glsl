//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, for depth peeling and dual depth peeling: the group peeled from the front goes under
// what is in front, the one peeled from the back over what is behind (Bavoil and Myers 2008).

//VTK::OIT::State
//VTK::OIT::Group

uniform sampler2DArray oitGathered;
uniform int oitRest;

#ifdef OIT_DUAL
OIT_STATE_LAYER(3) // colour and transmittance of the layers peeled from the back

void oitBlendOver(vec3 color, float opacity)
{
  oitState3.rgb += color - opacity * oitState3.rgb;
  oitState3.a -= opacity * oitState3.a;
}
#endif

OITGroup oitLoadGroup(int layer)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  return oitMakeGroup(texelFetch(oitGathered, ivec3(pixel, layer), 0),
    texelFetch(oitGathered, ivec3(pixel, layer + 1), 0));
}

void main()
{
  oitLoadCommonState();
  OITGroup front = oitLoadGroup(0);
  float opacity = oitGetGroupOpacity(front);
  if (oitRest != 0 && front.Count > 1.5)
  {
    oitNoteError(oitState0.a * opacity);
  }
  oitBlendUnder(oitGetGroupColor(front, opacity), opacity);
  oitState1.x += front.Count;
#ifdef OIT_DUAL
  OIT_LOAD_STATE(3)
  OITGroup back = oitLoadGroup(2);
  float backOpacity = oitGetGroupOpacity(back);
  oitBlendOver(oitGetGroupColor(back, backOpacity), backOpacity);
  oitState1.x += back.Count;
#endif
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  oitSetBounds(-texelFetch(oitGathered, ivec3(pixel, 0), 0).a,
    texelFetch(oitGathered, ivec3(pixel, 1), 0).a);
}
