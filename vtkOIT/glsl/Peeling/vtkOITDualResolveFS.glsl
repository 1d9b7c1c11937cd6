//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, for dual depth peeling where shaders can read the framebuffer: groups peeled from the
// front go under what is in front, groups peeled from the back over what is behind.

//VTK::OIT::State

OIT_STATE_LAYER(3) // colour and transmittance of the layers peeled from the back

//VTK::OIT::Layers

uniform int oitFirst;
uniform int oitRest;

void oitBlendOver(vec3 color, float opacity)
{
  oitState3.rgb += opacity * (color - oitState3.rgb);
  oitState3.a -= opacity * oitState3.a;
}

void main()
{
  oitLoadLayers(ivec2(gl_FragCoord.xy));
  bool isFirst = oitFirst != 0;
  oitState0 = isFirst ? vec4(0.0, 0.0, 0.0, 1.0) : oitState0;
  oitState3 = isFirst ? vec4(0.0, 0.0, 0.0, 1.0) : oitState3;
  oitState1.w = isFirst ? 0.0 : oitState1.w;
  bool isMore = (oitKept[OIT_LAYERS - 1].Key & OIT_MORE) != 0;
  oitKept[OIT_LAYERS - 1].Key -= isMore ? OIT_MORE : 0;
  for (int i = 0; i < OIT_SIDE; ++i)
  {
    bool isEmpty = oitKept[i].Key == OIT_NO_NEAR;
    vec4 color = isEmpty ? vec4(0.0) : oitUnpack(oitKept[i].Color);
    float opacity = isEmpty ? 0.0 : oitKept[i].Opacity;
    if (oitRest != 0 && color.a > 1.0) // not just one fragment
    {
      oitNoteError(oitState0.a * opacity);
    }
    oitBlendUnder(opacity * color.rgb, opacity);
  }
  for (int i = OIT_SIDE; i < OIT_LAYERS; ++i)
  {
    bool isEmpty = oitKept[i].Key == OIT_NO_FAR;
    oitBlendOver(isEmpty ? vec3(0.0) : oitUnpack(oitKept[i].Color).rgb,
      isEmpty ? 0.0 : oitKept[i].Opacity);
  }
  oitSetBounds(isMore ? oitGetKeyDepth(oitKept[OIT_SIDE - 1].Key) : 2.0,
    isMore ? oitGetKeyDepth(oitKept[OIT_LAYERS - 1].Key) : -2.0);
}
