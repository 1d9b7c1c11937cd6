// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Layers over what the framebuffer holds: C = C_layers + T C_dst, A = (1 - T) + T A_dst.
// llvmpipe blends 8-bit targets in 8 bits, up to 1.5 steps off; where a shader may read the target,
// it does the sum in float32 and only the result is rounded. Otherwise blending adds T times it.

#ifdef OIT_FRAMEBUFFER_FETCH
inout vec4 oitTarget;
#else
out vec4 oitTarget;
#endif

// What oitWrite() has written into an empty target, over another one.
void oitWriteLayer(vec4 layer)
{
#ifdef OIT_FRAMEBUFFER_FETCH
  oitTarget = layer + (1.0 - layer.a) * oitTarget;
#else
  oitTarget = layer;
#endif
}

void oitWrite(vec3 color, float transmittance)
{
#ifdef OIT_FRAMEBUFFER_FETCH
  oitTarget = vec4(color, 1.0 - transmittance) + transmittance * oitTarget;
#else
  oitTarget = vec4(color, 1.0 - transmittance);
#endif
}
