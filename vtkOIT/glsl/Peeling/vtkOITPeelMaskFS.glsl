//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Mask: a depth buffer that lets the hardware reject fragments that are peeled already, and all
// fragments of finished pixels, before they are shaded. An occlusion query counts the pixels that
// are not finished: those which are not discarded here.

uniform sampler2DArray oitState;

void main()
{
  vec2 bounds = texelFetch(oitState, ivec3(gl_FragCoord.xy, OIT_STATE_BOUNDS), 0).xy;
  if (!(bounds.x <= bounds.y))
  {
    discard;
  }
  // The margin is for hardware whose depth test sees another last bit than gl_FragCoord.z; the
  // shaders compare exactly.
  const float margin = 1e-6;
#ifdef OIT_MASK_FRONT
  gl_FragDepth = max(bounds.x - margin, 0.0);
#else
  gl_FragDepth = min(bounds.y + margin, 1.0);
#endif
}
