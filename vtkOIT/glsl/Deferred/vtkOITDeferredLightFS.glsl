// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights a material as VTK's mappers do: ambient, diffuse (Lambert) and specular (Phong) light of
// headlights, directional and positional lights, with attenuation and cone. Normals face the viewer
// already. What VTK computes for each light anew is computed once: with V towards the viewer,
// reflect(L, N) V is L V - 2 (N L) (N V).
//
// Lights are in a buffer texture, those of a kind together: four texels each, position or direction
// and attenuation x, colour and attenuation y, axis and cosine of the cone (position of a directional
// light), attenuation z and exponent. The first directional one is in uniforms, too, which a software renderer reads once for all
// pixels of a block.

uniform samplerBuffer oitLightTexels;
uniform ivec2 oitLightEnds;  // of the directional and of the positional ones; spot lights follow
uniform int oitLightCount;
uniform vec3 oitFirstAlong;  // direction of the first directional light
uniform vec3 oitFirstColor;
uniform vec3 oitFirstPosition;
uniform int oitIsHeadlight;  // the only light is one at the camera
uniform vec4 oitViewportMap; // origin in pixels, and clip coordinates a pixel
uniform mat4 oitFromClip;    // clip coordinates to view coordinates

struct OITMaterial
{
  vec3 Ambient;
  vec3 Diffuse;
  vec3 Specular;
  float Power;
  vec3 Normal; // of length 1
  bool IsLit;
  float Opacity;
#ifdef OIT_HAS_PHYSICAL
  bool IsPhysical; // then Specular is the reflectance, Power the roughness
  float Occlusion;
  float Grazing;
#endif
};

#ifdef OIT_DEFERRED // nodes of the A-buffer
OITMaterial oitUnpackMaterial(uvec2 first, uvec4 second)
{
  vec4 d = oitUnpack(second.xy);
  vec4 a = oitUnpack(uvec2(second.z, first.x));
  OITMaterial m;
  m.Ambient = vec3(a.rg, d.a);
  m.Diffuse = d.rgb;
  m.Specular = oitUnpackShared(second.w);
  m.Power = a.a;
  m.Normal = oitUnpackNormal(first.y);
  m.IsLit = first.y != OIT_UNLIT;
  m.Opacity = a.b;
#ifdef OIT_HAS_PHYSICAL
  m.IsPhysical = (first.x & OIT_PHYSICAL) != 0u;
  m.Occlusion = float(second.y >> 22u) / 1023.0;
  m.Grazing = float((second.y >> 16u) & 63u) / 63.0;
  m.Power = m.IsPhysical ? float((first.x >> 16u) & 32767u) / 32767.0 : a.a;
  m.Ambient = m.IsPhysical ? oitUnpackShared(second.z) : m.Ambient;
#endif
  return m;
}
#endif

// Clip coordinates to those of the view are a sum of this, once for a pixel, and a part for each depth.
vec4 oitOfPixel;

void oitBeginLight()
{
  vec2 clip = (gl_FragCoord.xy - oitViewportMap.xy) * oitViewportMap.zw - 1.0;
  oitOfPixel = oitFromClip * vec4(clip, -1.0, 1.0);
}

vec3 oitFindPosition(float depth)
{
  vec4 p = oitOfPixel + 2.0 * depth * oitFromClip[2];
  return p.xyz / p.w;
}

struct OITLit
{
  vec3 Diffuse;
  vec3 Specular;
};

#ifdef OIT_HAS_PHYSICAL
vec3 oitTowards = vec3(0.0); // the viewer, from the fragment

// GGX (Walter et al., Microfacet models for refraction, EGSR 2007), with the correlated term of Smith and
// Schlick's reflectance; a headlight is taken to come from the viewer.
void oitAddPhysical(inout OITLit lit, OITMaterial m, vec3 along, vec3 color)
{
  bool isHeadlight = oitIsHeadlight != 0;
  vec3 middleWay = normalize(oitTowards - along);
  vec4 cosines = vec4(dot(m.Normal, oitTowards), -dot(m.Normal, along), dot(m.Normal, middleWay), -dot(middleWay, along));
  cosines = clamp(cosines, 1e-5, 1.0);
  float viewer = cosines.x;
  float light = isHeadlight ? viewer : cosines.y;
  float middle = isHeadlight ? viewer : cosines.z;
  float between = isHeadlight ? 1.0 : cosines.w;
  float width = m.Power * m.Power;
  float square = width * width;
  float spread = (middle * square - middle) * middle + 1.0;
  float facets = square / (3.14159265 * spread * spread);
  float shadows = 0.5 / (light * sqrt(width + viewer * (viewer - width * viewer)) +
    viewer * sqrt(width + light * (light - width * light)));
  vec3 reflected = m.Specular + (m.Grazing - m.Specular) * pow(1.0 - between, 5.0);
  lit.Diffuse += light * color * (1.0 - reflected);
  lit.Specular += light * color * facets * shadows * reflected;
}
#endif

// The direction of a directional light. VTK before 9.6 has it come from its position, in physically based
// rendering and where there are positional lights.
vec3 oitFindDirection(OITMaterial m, vec3 along, vec3 from, vec3 position)
{
#if defined(OIT_HAS_PHYSICAL) && defined(OIT_DIRECTIONAL_FROM_POSITION)
  return m.IsPhysical && oitLightCount > oitLightEnds.x ? normalize(position - from) : along;
#else
  return along;
#endif
}

// Light of one colour: `along` is the direction in which it goes.
void oitAddLight(inout OITLit lit, OITMaterial m, vec3 view, float towards, vec3 along, vec3 color)
{
#ifdef OIT_HAS_PHYSICAL
  if (m.IsPhysical)
  {
    oitAddPhysical(lit, m, along, color);
    return;
  }
#endif
  float facing = -dot(m.Normal, along);
  lit.Diffuse += max(facing, 0.0) * color;
#ifdef OIT_HAS_SPECULAR
  // VTK takes the normal itself for the mirrored direction of a headlight.
  float mirrored = oitIsHeadlight != 0 ? facing : dot(along, view) + 2.0 * facing * towards;
  float strength = facing > 0.0 ? pow(max(mirrored, 0.0), m.Power) : 0.0;
  lit.Specular += strength * color;
#endif
}

vec3 oitLight(OITMaterial m, float depth)
{
  OITLit lit = OITLit(vec3(0.0), vec3(0.0));
  vec3 position = oitFindPosition(depth);
  vec3 view = oitIsHeadlight != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-position);
  float towards = dot(m.Normal, view);
#ifdef OIT_HAS_PHYSICAL
  oitTowards = normalize(-position);
#endif
  // None for what has no normal: then loops end where no pixel needs them.
  ivec3 ends = m.IsLit ? ivec3(oitLightEnds, oitLightCount) : ivec3(0);
  int i = 0;
  for (; i < min(ends.x, 1); ++i)
  {
    vec3 along = oitFindDirection(m, oitFirstAlong, oitFirstPosition, position);
    oitAddLight(lit, m, view, towards, along, oitFirstColor);
  }
  for (; i < ends.x; ++i)
  {
    vec3 along = texelFetch(oitLightTexels, 4 * i).xyz;
    along = oitFindDirection(m, along, texelFetch(oitLightTexels, 4 * i + 2).xyz, position);
    oitAddLight(lit, m, view, towards, along, texelFetch(oitLightTexels, 4 * i + 1).rgb);
  }
  for (; i < ends.z; ++i)
  {
    vec4 at = texelFetch(oitLightTexels, 4 * i);
    vec4 color = texelFetch(oitLightTexels, 4 * i + 1);
    vec4 rest = texelFetch(oitLightTexels, 4 * i + 3);
    vec3 along = position - at.xyz;
    float reach = length(along);
    along /= reach;
    float attenuation = 1.0 / (at.w + reach * (color.a + reach * rest.x));
    if (i >= ends.y)
    {
      vec4 cone = texelFetch(oitLightTexels, 4 * i + 2);
      float inside = dot(along, cone.xyz);
      attenuation *= inside >= cone.w ? pow(inside, rest.y) : 0.0;
    }
    oitAddLight(lit, m, view, towards, along, attenuation * color.rgb);
  }
#ifdef OIT_HAS_PHYSICAL
  if (m.IsPhysical)
  {
    vec3 color = m.Ambient + m.Occlusion * (lit.Diffuse * m.Diffuse + lit.Specular);
    return pow(max(color, 0.0), vec3(1.0 / 2.2));
  }
#endif
  return m.Ambient + lit.Diffuse * m.Diffuse + lit.Specular * m.Specular;
}

// As a colour that was shaded in the geometry pass is stored.
vec3 oitClampLight(vec3 color)
{
#ifdef OIT_CLAMP_COLOR
  return clamp(color, 0.0, 1.0);
#else
  return clamp(color, 0.0, 65504.0);
#endif
}

#ifdef OIT_DEFERRED
vec4 oitLightNode(uvec4 first, uvec4 second)
{
  OITMaterial m = oitUnpackMaterial(first.yz, second);
  return vec4(oitClampLight(oitLight(m, uintBitsToFloat(first.x))), m.Opacity);
}
#endif
