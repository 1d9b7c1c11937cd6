//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Composite: the layer of all translucent props, premultiplied with its alpha 1 - T, over what the
// framebuffer holds.

//VTK::OIT::Output

uniform sampler2DArray oitLayer;

void main()
{
  vec4 layer = texelFetch(oitLayer, ivec3(ivec2(gl_FragCoord.xy), 0), 0);
  if (layer == vec4(0.0))
  {
    discard; // no fragments
  }
  oitWriteLayer(layer);
}
