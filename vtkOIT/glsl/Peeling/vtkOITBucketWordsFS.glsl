// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Words: colours and opacities as positive normal floats, which MAX blending keeps whole. Bits that would
// be a denormal or no number never come up: 31 bits of payload, whose topmost 7 are not all ones.

const uint OIT_SMALLEST_NORMAL = 0x00800000u;

float oitToWord(uint payload) { return uintBitsToFloat(payload + OIT_SMALLEST_NORMAL); }
uint oitFromWord(float word) { return floatBitsToUint(word) - OIT_SMALLEST_NORMAL; }

// Into [0, 1]. Colours of a float target are not bounded.
#ifdef OIT_CLAMP_COLOR
vec3 oitCompress(vec3 color) { return color; }
vec3 oitExpand(vec3 color) { return color; }
#else
vec3 oitCompress(vec3 color) { return max(color, vec3(0.0)) / (1.0 + max(color, vec3(0.0))); }
vec3 oitExpand(vec3 color) { return color / max(1.0 - color, vec3(1e-5)); }
#endif

// 24 bits of colour and some of the root of opacity, so that faint layers keep one.
uint oitPackCoarse(vec4 color, uint largestOpacity)
{
  uvec3 bytes = uvec3(oitCompress(color.rgb) * 255.0 + 0.5);
  uint opacity = max(uint(sqrt(color.a) * float(largestOpacity) + 0.5), 1u);
  return (opacity << 24u) | (bytes.r << 16u) | (bytes.g << 8u) | bytes.b;
}

vec4 oitUnpackCoarse(uint payload, uint largestOpacity)
{
  float root = float(payload >> 24u) / float(largestOpacity);
  uvec3 bytes = uvec3(payload >> 16u, payload >> 8u, payload) & uvec3(255u);
  return vec4(oitExpand(vec3(bytes) / 255.0), root * root);
}

// Of buckets: a key above opacity and colour. Where each prop has one opacity, and the frame few, the opacity
// is its number, and the key has the bits that are left of four.
uniform int oitOpacityBits;
uniform int oitOpacityNumber;    // of the prop; -1: the root of the opacity
uniform float oitOpacities[16];  // those of the frame
uniform int oitHasOpacityNumbers;

int oitGetNumberOfKeys() { return 7 << (4 - oitOpacityBits); }
uint oitGetKeyShift() { return 24u + uint(oitOpacityBits); }
uint oitGetColorMask() { return (1u << oitGetKeyShift()) - 1u; }

uint oitPackBucket(vec4 color)
{
  uint coarse = oitPackCoarse(color, 15u);
  uint numbered = (uint(max(oitOpacityNumber, 0)) << 24u) | (coarse & 0xffffffu);
  return oitOpacityNumber >= 0 ? numbered : coarse;
}

vec4 oitUnpackBucket(uint payload)
{
  vec4 color = oitUnpackCoarse(payload & oitGetColorMask(), 15u);
  int number = int((payload & oitGetColorMask()) >> 24u);
  return vec4(color.rgb, oitHasOpacityNumbers != 0 ? oitOpacities[number] : color.a);
}

// 15 bits each.
uint oitPackFine(vec2 values)
{
  uvec2 bits = uvec2(values * 32767.0 + 0.5);
  return (bits.x << 15u) | bits.y;
}

vec2 oitUnpackFine(uint payload)
{
  return vec2(uvec2(payload >> 15u, payload) & uvec2(32767u)) / 32767.0;
}

float oitToOpticalDepth(float opacity) { return min(-log(max(1.0 - opacity, 0.0)), 1e4); }
