//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Composite: what was peeled, over what the framebuffer holds.

//VTK::OIT::Output

uniform sampler2DArray oitState;
uniform ivec2 oitOrigin; // framebuffer pixel of the state's texel (0, 0)

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;
  if (texelFetch(oitState, ivec3(pixel, OIT_STATE_STATISTICS), 0).x == 0.0)
  {
    discard; // no fragments
  }
  vec4 front = texelFetch(oitState, ivec3(pixel, OIT_STATE_FRONT), 0);
#ifdef OIT_HAS_BACK
  vec4 back = texelFetch(oitState, ivec3(pixel, OIT_STATE_BACK), 0);
  front = vec4(front.rgb + front.a * back.rgb, front.a * back.a);
#endif
  oitWrite(front.rgb, front.a);
}
