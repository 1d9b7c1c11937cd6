// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Colour to and from half floats, rounded to nearest. The built-in packHalf2x16 costs three times
// as much on llvmpipe, and truncates there. Values are clamped to [0, 65504]; 2^-14 is the smallest
// normal half, below it the bits count units of 2^-24. Float colours are kept as they are, but for
// what is infinite or not a number. With OIT_CLAMP_COLOR colours are clamped to [0, 1], as OpenGL
// does before it blends in a fixed-point target.
#ifdef OIT_FLOAT_COLOR
uvec4 oitPack(vec4 color)
{
  const float bound = 1e30; // so that sums stay finite
#ifdef OIT_CLAMP_COLOR
  const vec4 smallest = vec4(vec3(0.0), -bound);
  const vec4 largest = vec4(vec3(1.0), bound);
#else
  const vec4 smallest = vec4(-bound);
  const vec4 largest = vec4(bound);
#endif
  color = mix(color, vec4(0.0), isnan(color));
  return floatBitsToUint(clamp(color, smallest, largest));
}
vec4 oitUnpack(uvec4 bits) { return uintBitsToFloat(bits); }
#else
uvec2 oitPackUpTo(vec4 color, vec4 largest)
{
  const float smallest = 6.103515625e-5;
  vec4 c = min(max(color, vec4(0.0)), largest);
  uvec4 normal = (floatBitsToUint(max(c, vec4(smallest))) - 0x37fff000u) >> 13u;
  uvec4 bits = normal - 0x400u + uvec4(min(c, vec4(smallest)) * 16777216.0 + 0.5);
  return bits.xz | (bits.yw << 16u);
}
uvec2 oitPack(vec4 color)
{
#ifdef OIT_CLAMP_COLOR
  return oitPackUpTo(color, vec4(vec3(1.0), 65504.0));
#else
  return oitPackUpTo(color, vec4(65504.0));
#endif
}
vec4 oitUnpack(uvec2 bits)
{
  uvec4 h = uvec4(bits.x & 0xffffu, bits.x >> 16u, bits.y & 0xffffu, bits.y >> 16u);
  vec4 normal = uintBitsToFloat((h << 13u) + 0x38000000u);
  vec4 denormal = vec4(h) * 5.9604644775390625e-8;
  return mix(normal, denormal, lessThan(h, uvec4(0x400u)));
}
#endif
