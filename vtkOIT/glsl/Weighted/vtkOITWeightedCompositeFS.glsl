//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Composite: the sums as one layer over what the framebuffer holds. The equations are those of
// Bavoil and Myers 2008, sections Weighted average and Weighted sum.

//VTK::OIT::Output

uniform sampler2DArray oitState;
uniform ivec2 oitOrigin; // framebuffer pixel of the state's texel (0, 0)

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;
  vec4 colors = texelFetch(oitState, ivec3(pixel, 0), 0);
  vec4 counts = texelFetch(oitState, ivec3(pixel, 1), 0);
  float count = counts.x;
  if (count == 0.0)
  {
    discard;
  }
#if defined(OIT_SUM)
  // C = sum(A c) + C_bg (1 - sum(A))
  oitWrite(colors.rgb, 1.0 - counts.w);
#else
#if defined(OIT_BLENDED)
  float opacity = count < 1.5 ? counts.w : 1.0 - exp(-counts.y); // 1 - prod(1 - A)
#else
  // C = sum(A c) / sum(A), A = sum(A) / n: C (1 - (1 - A)^n) + C_bg (1 - A)^n
  float mean = counts.w / count;
  float opacity = count < 1.5 ? mean : 1.0 - exp(count * log(max(1.0 - mean, 0.0)));
#endif
  oitWrite(colors.rgb * (opacity / colors.a), 1.0 - opacity);
#endif
}
