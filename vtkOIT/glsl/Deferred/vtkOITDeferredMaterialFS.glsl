// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What a fragment is made of before it is lit, in 24 bytes: its position is that of its depth.
//
//   uvec2: opacity and specular power in half floats; normal, octahedral in 16 bits a coordinate
//          (Meyer et al., On floating-point normal vectors, EGSR 2010), or OIT_UNLIT
//   uvec4: diffuse colour and ambient blue, ambient red and green in half floats; specular colour in
//          9 bits a channel and a common exponent of 5, the largest channel to 2^-10 of it
//
// With OIT_PHYSICAL, the free bit of the power, physically based rendering: roughness in 15 bits instead of the power,
// the diffuse part of the albedo, and instead of the ambient colour the emission as the specular colour
// is packed, which here is the reflectance; in place of ambient blue 10 bits of occlusion and 6 of the
// reflectance at grazing angles.
//
// What is shaded already, or has no lighting, has its colour as the ambient one.

const uint OIT_PHYSICAL = 0x80000000u;
const uint OIT_UNLIT = 0xffffffffu; // no normal: coordinates are at most 65534

uint oitPackNormal(vec3 n)
{
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 folded = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
  vec2 e = n.z < 0.0 ? folded : n.xy;
  uvec2 bits = uvec2(e * 32767.0 + 32767.5);
  bool isNormal = dot(n, n) > 0.0; // not so for what is not a number
  return isNormal ? bits.x | (bits.y << 16u) : OIT_UNLIT;
}

vec3 oitUnpackNormal(uint bits)
{
  vec2 e = (vec2(float(bits & 0xffffu), float(bits >> 16u)) - 32767.0) / 32767.0;
  vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
  float fold = max(-n.z, 0.0);
  n.xy -= vec2(n.x < 0.0 ? -fold : fold, n.y < 0.0 ? -fold : fold);
  return normalize(n);
}

uint oitPackShared(vec3 color)
{
  vec3 c = min(max(color, vec3(0.0)), vec3(65408.0));
  float largest = max(max(c.r, c.g), max(c.b, 6.103515625e-5));
  // The next power of two above the largest, so that its channel is at most 511 of 512.
  int exponent = int(floatBitsToUint(largest * (1.0 + 1.0 / 1022.0)) >> 23u) - 126;
  uvec3 bits = uvec3(c * uintBitsToFloat(uint(136 - exponent) << 23u) + 0.5);
  return bits.r | (bits.g << 9u) | (bits.b << 18u) | (uint(exponent + 15) << 27u);
}

vec3 oitUnpackShared(uint bits)
{
  vec3 c = vec3(uvec3(bits, bits >> 9u, bits >> 18u) & 511u);
  return c * uintBitsToFloat(((bits >> 27u) + 103u) << 23u);
}

// What is shaded already, in the two parts of a node.
uvec4 oitPackShaded(vec4 color, out uvec2 first)
{
  uvec2 d = oitPackUpTo(vec4(vec3(0.0), color.b), vec4(65504.0));
  uvec2 a = oitPackUpTo(vec4(color.rg, color.a, 0.0), vec4(65504.0));
  first = uvec2(a.y, OIT_UNLIT);
  return uvec4(d, a.x, oitPackShared(vec3(0.0)));
}
