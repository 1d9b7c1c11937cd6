//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Composite, for dual depth peeling when the first peel has all layers: front to back, over what
// the framebuffer holds.

//VTK::OIT::Layers
//VTK::OIT::Output

uniform ivec2 oitOrigin; // framebuffer pixel of the texel (0, 0)

void main()
{
  oitLoadLayers(ivec2(gl_FragCoord.xy) - oitOrigin);
  if (oitKept[0].Key == OIT_NO_NEAR)
  {
    discard; // no fragments
  }
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  for (int i = 0; i < OIT_LAYERS; ++i)
  {
    // The far layers, which begin with the farthest, from the end.
    OITLayer layer = oitKept[i < OIT_SIDE ? i : OIT_LAYERS - 1 + OIT_SIDE - i];
    bool isEmpty = layer.Key == OIT_NO_NEAR || layer.Key == OIT_NO_FAR;
    float weight = isEmpty ? 0.0 : transmittance * layer.Opacity;
    color += weight * (isEmpty ? vec3(0.0) : oitUnpack(layer.Color).rgb);
    transmittance -= weight;
  }
  oitWrite(color, transmittance);
}
