//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth check: passes the pixels whose opaque depth is not what it was, for an occlusion query to
// count. Nothing is written.

uniform sampler2D oitDepth;
uniform sampler2D oitKeptDepth;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (texelFetch(oitDepth, pixel, 0).r == texelFetch(oitKeptDepth, pixel, 0).r)
  {
    discard;
  }
}
