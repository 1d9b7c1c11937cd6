// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The material of the fragment that a mapper's own shader, renamed oitShade(), has left: in oitAmbient
// and its like where vtkOITDeferredText has cut its lighting out (OIT_CAPTURES), and oitFragColor is
// then what textures multiply all of them with; otherwise oitFragColor is the shaded colour.

uvec4 oitPackMaterial(float opacity, out uvec2 first)
{
#ifdef OIT_CAPTURES
  const vec4 largest = vec4(65504.0);
  uint normal = oitPackNormal(oitNormal);
  bool isLit = normal != OIT_UNLIT;
  vec3 factor = oitFragColor.rgb;
  vec3 diffuse = isLit ? oitDiffuse * factor : vec3(0.0);
  vec3 specular = isLit ? oitSpecular * factor : vec3(0.0);
#ifdef OIT_CAPTURES_PHYSICAL
  uvec2 c = oitPackUpTo(vec4(diffuse, 0.0), largest);
  c.y |= (uint(clamp(oitOcclusion, 0.0, 1.0) * 1023.0 + 0.5) << 22u) | (uint(oitGrazing * 63.0 + 0.5) << 16u);
  uint opaque = oitPackUpTo(vec4(opacity, 0.0, 0.0, 0.0), largest).x;
  uint roughness = uint(clamp(oitPower, 0.0, 1.0) * 32767.0 + 0.5);
  first = uvec2(opaque | (roughness << 16u) | OIT_PHYSICAL, normal);
  return uvec4(c, oitPackShared(oitAmbient), oitPackShared(specular));
#else
  vec3 ambient = oitAmbient * factor;
  uvec2 d = oitPackUpTo(vec4(diffuse, ambient.b), largest);
  uvec2 a = oitPackUpTo(vec4(ambient.rg, opacity, oitPower), largest);
  first = uvec2(a.y, normal);
  return uvec4(d, a.x, oitPackShared(specular));
#endif
#else
  return oitPackShaded(vec4(oitFragColor.rgb, opacity), first);
#endif
}
