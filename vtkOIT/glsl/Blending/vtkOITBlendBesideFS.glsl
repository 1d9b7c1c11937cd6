// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Output of Blend into two colour buffers, both by framebuffer fetch: the target, in which the pixel
// is right after each fragment, and beside it the same in float32, for the next fragment to go on
// from. So a pixel of several layers is rounded once, and needs no stage that composites them.
//
// The float32 buffer is not cleared for each frame: the lowest bits of its alpha tell in which frame
// it was written. That costs alpha at most 2^-15 of itself.

layout(location = 0) inout vec4 oitTarget;
layout(location = 1) inout vec4 oitUnrounded;

uniform int oitStamp; // of this frame, [1, OIT_STAMPS]

void oitWrite(vec3 color, float transmittance)
{
  const uint mask = uint(OIT_STAMPS);
  bool isMine = (floatBitsToUint(oitUnrounded.a) & mask) == uint(oitStamp);
  // What is infinite is finite again in the target, and hidden by a layer that lets nothing through.
  vec4 below = isMine && transmittance > 0.0 ? oitUnrounded : oitTarget;
  vec4 sum = vec4(color, 1.0 - transmittance) + transmittance * below;
  uint alpha = (floatBitsToUint(sum.a) & ~mask) | uint(oitStamp);
  oitUnrounded = vec4(sum.rgb, uintBitsToFloat(alpha));
  oitTarget = sum;
}
