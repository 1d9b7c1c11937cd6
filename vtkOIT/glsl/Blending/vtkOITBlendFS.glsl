// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Blend: a fragment of a prop over what the target holds, for props that are drawn back to front.
// The mapper's own shader, renamed oitShade(), leaves its colour in oitFragColor.
// Output: the target, by framebuffer fetch in float32, or premultiplied for blending
// (GL_ONE, GL_ONE_MINUS_SRC_ALPHA).

//VTK::OIT::Output

void main()
{
  oitShade();
#ifdef OIT_FRAMEBUFFER_FETCH
  // A mean of colours cannot overflow, and the target clamps it: they may be infinite.
  float opacity = oitGetOpacity();
  if (opacity == 0.0)
  {
    return;
  }
  oitWrite(opacity * oitGetRGB(), 1.0 - opacity);
#else
  vec4 color = oitGetColor();
  oitWrite(color.a * color.rgb, 1.0 - color.a);
#endif
}
