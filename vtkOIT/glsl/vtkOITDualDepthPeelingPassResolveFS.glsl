//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, for dual depth peeling where shaders can read the framebuffer: groups peeled from the
// front go under what is in front, groups peeled from the back over what is behind.

//VTK::OIT::State

OIT_STATE_LAYER(3) // colour and transmittance of the layers peeled from the back
OIT_STATE_LAYER(4) // bounds of what is inside
OIT_STATE_LAYER(5) // opacities of the groups

uniform sampler2DArray oitSums; // front, second front, back, second back
uniform int oitRest;

// The mean of the colours weighted by opacity, times the opacity of the group. For a single
// fragment the factor is 1.
vec3 oitGetColor(int layer, float opacity)
{
  vec4 sums = texelFetch(oitSums, ivec3(gl_FragCoord.xy, layer), 0);
  return sums.rgb * (sums.a > 0.0 ? opacity / sums.a : 0.0);
}

void oitBlendOver(vec3 color, float opacity)
{
  oitState3.rgb += color - opacity * oitState3.rgb;
  oitState3.a -= opacity * oitState3.a;
}

void main()
{
  oitLoadCommonState();
  vec4 opacities = oitState5;
  vec4 inside = oitState4;
  float weight = texelFetch(oitSums, ivec3(gl_FragCoord.xy, 0), 0).a;
  if (oitRest != 0 && weight > opacities.x) // not just one fragment
  {
    oitNoteError(oitState0.a * opacities.x);
  }
  oitBlendUnder(oitGetColor(0, opacities.x), opacities.x);
  oitBlendUnder(oitGetColor(1, opacities.z), opacities.z);
  oitBlendOver(oitGetColor(2, opacities.y), opacities.y);
  oitBlendOver(oitGetColor(3, opacities.w), opacities.w);
  oitSetBounds(inside.x, inside.y);
  oitState2.zw = inside.zw;
  // In parts: Mesa 22.3 takes a variable that is assigned once, a constant, for a constant, and
  // forgets that an inout variable had a value before.
  oitState4.xz = vec2(2.0);
  oitState4.yw = vec2(-2.0);
  oitState5.xz = vec2(0.0);
  oitState5.yw = vec2(0.0);
}
