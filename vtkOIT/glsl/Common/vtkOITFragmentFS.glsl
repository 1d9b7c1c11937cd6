// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The fragment that a mapper's own shader, renamed oitShade(), has made: its depth, opacity and
// colour as every method sees them.

#ifdef OIT_WRITES_DEPTH
#define OIT_DEPTH gl_FragDepth
#else
#define OIT_DEPTH gl_FragCoord.z
#endif

// In [0, 1]: clipped triangles reach a little beyond; -0 becomes +0.
float oitGetDepth()
{
  return abs(clamp(OIT_DEPTH, 0.0, 1.0));
}

// In [0, 1]; 0 when the fragment leaves no trace: also for an opacity that is not a number.
float oitGetOpacity()
{
  return oitFragColor.a > 0.0 ? min(oitFragColor.a, 1.0) : 0.0;
}

// Without what is not a number. In a fixed-point target OpenGL would clamp it before it blends
// (OIT_CLAMP_COLOR); otherwise it may be infinite.
vec3 oitGetRGB()
{
  vec3 color = mix(oitFragColor.rgb, vec3(0.0), isnan(oitFragColor.rgb));
#ifdef OIT_CLAMP_COLOR
  return clamp(color, vec3(0.0), vec3(1.0));
#else
  return color;
#endif
}

// With OIT_HAS_LIGHT some props add light: their fragments have no opacity, and their colour is
// premultiplied with what would be it. OIT_LIGHT stands in the place of the opacity.
#ifdef OIT_HAS_LIGHT
uniform int oitIsLight; // the prop is one of those
vec4 oitGetLightOr(vec4 color)
{
  return oitIsLight != 0 ? vec4(color.a * oitGetRGB(), OIT_LIGHT) : color;
}
#endif

// Colour and opacity, finite, so that sums are.
vec4 oitGetColor()
{
  const float largest = 1e30;
  return vec4(clamp(oitGetRGB(), vec3(-largest), vec3(largest)), oitGetOpacity());
}

// -log(1 - opacity), also where 1 - opacity would lose the digits of a faint layer. Bounded, so
// that sums stay finite; exp(-1e4) is 0.
float oitGetOpticalDepth(float opacity)
{
  float series = opacity * (1.0 + opacity * (0.5 + opacity * (1.0 / 3.0 + opacity * 0.25)));
  return opacity < 0.01 ? series : min(-log(max(1.0 - opacity, 0.0)), 1e4);
}
