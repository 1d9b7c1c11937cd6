// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, for deferred depth peeling: of the fragments at the near bound of the pixel, materials are
// summed up, weighted by opacity; of those behind it, the bounds of the next peel are found. Colours are
// added and alpha is kept as the maximum, one way of blending for all buffers: the layer's G-buffer.
//
// The mapper's own shader has left a material where its lighting was cut out (OIT_CAPTURES), and then
// oitFragColor is what textures multiply it with; otherwise it is the shaded colour.

uniform int oitRest; // not 0: all that is left counts as one group
uniform sampler2DArray oitState;

const float OIT_NO_DEPTH = -2.0;

layout(location = 0) out vec4 oitAmbientSum;  // -depth of the nearest behind
layout(location = 1) out vec4 oitDiffuseSum;  // depth of the farthest
layout(location = 2) out vec4 oitSpecularSum;
layout(location = 3) out vec4 oitNormalSum;
layout(location = 4) out vec4 oitOpacitySum; // opacity, optical depth, count
layout(location = 5) out vec4 oitPowerSum;   // opacity, power, and its square, of what is lit

void main()
{
  oitShade();
  float depth = oitGetDepth();
  float opacity = oitGetOpacity();
  vec2 bounds = texelFetch(oitState, ivec3(gl_FragCoord.xy, OIT_STATE_BOUNDS), 0).xy;
  bool isLeft = opacity > 0.0 && depth >= bounds.x && depth <= bounds.y;
  bool isFront = isLeft && (oitRest != 0 || depth == bounds.x);
  float weight = isFront ? opacity : 0.0;
#ifdef OIT_CAPTURES
  vec3 factor = mix(oitFragColor.rgb, vec3(0.0), isnan(oitFragColor.rgb));
  bool isLit = dot(oitNormal, oitNormal) > 0.5; // not so for what is not a number
  vec3 normal = isLit ? oitNormal : vec3(0.0);
  vec3 ambient = oitAmbient * factor;
  vec3 diffuse = isLit ? oitDiffuse * factor : vec3(0.0);
  vec3 specular = isLit ? oitSpecular * factor : vec3(0.0);
  vec3 power = isLit ? vec3(1.0, oitPower, oitPower * oitPower) : vec3(0.0);
#else
  vec3 normal = vec3(0.0);
  vec3 ambient = oitGetColor().rgb;
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  vec3 power = vec3(0.0);
#endif
  vec2 inside = isLeft && !isFront ? vec2(-depth, depth) : vec2(OIT_NO_DEPTH);
  oitAmbientSum = vec4(weight * ambient, inside.x);
  oitDiffuseSum = vec4(weight * diffuse, inside.y);
  oitSpecularSum = vec4(weight * specular, OIT_NO_DEPTH);
  oitNormalSum = vec4(weight * normal, OIT_NO_DEPTH);
  oitOpacitySum = vec4(weight, isFront ? oitGetOpticalDepth(opacity) : 0.0, float(isFront), OIT_NO_DEPTH);
  oitPowerSum = vec4(weight * power, OIT_NO_DEPTH);
}
