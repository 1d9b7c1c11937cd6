//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, for depth peeling, and for dual depth peeling where shaders cannot read the framebuffer:
// the group peeled from the front goes under what is in front, the one peeled from the back over
// what is behind (Bavoil and Myers 2008).

//VTK::OIT::State
//VTK::OIT::Group

uniform int oitRest;

#ifdef OIT_DUAL
OIT_STATE_LAYER(3) // colour and transmittance of the layers peeled from the back

// Before oitBlendOver(): a compiler that goes by the order of the text calls it uninitialized.
void oitLoadBackState()
{
  OIT_LOAD_STATE(3)
}

void oitBlendOver(vec3 color, float opacity)
{
  oitState3.rgb += color - opacity * oitState3.rgb;
  oitState3.a -= opacity * oitState3.a;
}
#endif

// What Gather has summed up: in place as layers of the state, emptied again for the next peel, or
// the buffers that it blended into.
#ifdef OIT_IN_PLACE
OIT_STATE_LAYER(3) // sums of opacity times colour and of opacity
OIT_STATE_LAYER(4) // opacity of the group and count
#else
uniform sampler2DArray oitSums;
vec4 oitLoadSums(int layer)
{
  return texelFetch(oitSums, ivec3(gl_FragCoord.xy, layer), 0);
}
#endif

void main()
{
  oitLoadCommonState();
#ifdef OIT_IN_PLACE
  vec4 group = oitState4;
  OITGroup front = OITGroup(oitState3.rgb, oitState3.a, 0.0, group.y);
  float opacity = group.x;
  vec2 depths = oitState2.zw;
#elif defined(OIT_LAST_ON_TOP)
  vec4 color = oitLoadSums(0);
  vec4 sums = oitLoadSums(1);
  OITGroup front = OITGroup(color.rgb, color.a, 0.0, sums.a); // and those at the back
  float opacity = color.a;
  vec2 depths = sums.xy;
#else
  vec4 color = oitLoadSums(0);
  vec4 sums = oitLoadSums(1);
  OITGroup front = OITGroup(color.rgb, sums.x, sums.y, sums.z);
  float opacity = oitGetGroupOpacity(front);
  vec2 depths = vec2(color.a, sums.a);
#endif
  if (oitRest != 0 && front.Count > 1.5)
  {
    oitNoteError(oitState0.a * opacity);
  }
  oitBlendUnder(oitGetGroupColor(front, opacity), opacity);
  oitState1.x += front.Count;

#ifdef OIT_DUAL
  oitLoadBackState();
  vec4 backColor = oitLoadSums(2);
#ifdef OIT_LAST_ON_TOP
  OITGroup back = OITGroup(backColor.rgb, backColor.a, 0.0, 0.0);
#else
  vec4 backSums = oitLoadSums(3);
  OITGroup back = OITGroup(backColor.rgb, backSums.x, backSums.y, backSums.z);
#endif
  float backOpacity = oitGetGroupOpacity(back);
  oitBlendOver(oitGetGroupColor(back, backOpacity), backOpacity);
  oitState1.x += back.Count;
#endif

  oitSetBounds(-depths.x, depths.y);
#ifdef OIT_IN_PLACE
  oitState2.zw = vec2(-2.0);
  // By halves: Mesa 22.3 takes a variable that is assigned once, a constant, for a constant, and
  // forgets that an inout variable had a value before.
  oitState3.xy = vec2(0.0);
  oitState3.zw = vec2(0.0);
  oitState4.xy = vec2(0.0);
  oitState4.zw = vec2(0.0);
#endif
}
