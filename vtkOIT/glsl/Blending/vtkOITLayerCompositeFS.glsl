//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Composite: the layer of all translucent props, premultiplied with its alpha 1 - T, over what the
// framebuffer holds. The layer is a texture, or with OIT_BESIDE a second colour buffer, which is
// cheaper to read on llvmpipe.

//VTK::OIT::Output

#ifdef OIT_BESIDE
layout(location = 1) inout vec4 oitLayer;

vec4 oitReadLayer()
{
  return oitLayer;
}
#else
uniform sampler2DArray oitLayer;

vec4 oitReadLayer()
{
  return texelFetch(oitLayer, ivec3(ivec2(gl_FragCoord.xy), 0), 0);
}
#endif

void main()
{
  vec4 layer = oitReadLayer();
  if (layer == vec4(0.0))
  {
    discard; // no fragments
  }
  oitWriteLayer(layer);
}
