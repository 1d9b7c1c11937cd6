//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve, for deferred depth peeling: the layer that was peeled is lit, and goes under what is in front
// of it. Coincident fragments are lit as one material, the mean weighted by opacity, which is the mean of
// their light where they have one normal and one specular power; otherwise it is not exact, and noted.

//VTK::OIT::State
//VTK::OIT::Group
//VTK::OIT::Light

uniform sampler2DArray oitSums;
uniform int oitRest;

vec4 oitLoadSums(int layer)
{
  return texelFetch(oitSums, ivec3(gl_FragCoord.xy, layer), 0);
}

void main()
{
  oitLoadCommonState();
  vec4 ambient = oitLoadSums(0);
  vec4 diffuse = oitLoadSums(1);
  vec3 normal = oitLoadSums(3).xyz;
  vec3 sums = oitLoadSums(4).xyz;
  vec3 powers = oitLoadSums(5).xyz;
  OITGroup group = OITGroup(ambient.rgb, sums.x, sums.y, sums.z);
  float opacity = oitGetGroupOpacity(group);
  float scale = sums.x > 0.0 ? 1.0 / sums.x : 0.0;

  OITMaterial m;
  m.Ambient = ambient.rgb * scale;
  m.Diffuse = diffuse.rgb * scale;
  m.Specular = oitLoadSums(2).rgb * scale;
  m.Opacity = opacity;
  m.IsLit = powers.x > 0.0;
  m.Power = m.IsLit ? powers.y / powers.x : 0.0;
  m.Normal = m.IsLit ? normalize(normal) : vec3(0.0, 0.0, 1.0);
  oitBeginLight();
  vec3 color = oitLight(m, clamp(oitState2.x, 0.0, 1.0));
  vec3 clamped = max(color, 0.0);
#ifdef OIT_CLAMP_COLOR
  clamped = min(clamped, 1.0);
#else
  clamped = min(clamped, 1e30);
#endif

  bool isGroup = sums.z > 1.5;
  const float tolerance = 1e-3;
  bool differs = length(normal) < (1.0 - tolerance) * powers.x ||
    abs(powers.z * powers.x - powers.y * powers.y) > tolerance * powers.y * powers.y ||
    any(notEqual(clamped, color));
  if (isGroup && (oitRest != 0 || (m.IsLit && differs)))
  {
    oitNoteError(oitState0.a * opacity);
  }
  // Without light it is as peeled without lighting, to the last bit.
  oitBlendUnder(m.IsLit ? clamped * opacity : oitGetGroupColor(group, opacity), opacity);
  oitState1.x += sums.z;
  oitSetBounds(-ambient.a, diffuse.a);
}
