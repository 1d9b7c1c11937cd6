// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, for depth peeling and dual depth peeling: fragments at the bounds of the pixel are summed
// up as the group of coincident fragments that is peeled now; of the fragments inside, the bounds
// of the next peel are found. In the first pass everything is inside.
//
// Colours are added and alpha is kept as the maximum: one way of blending for all buffers.

uniform sampler2DArray oitState;
uniform int oitRest; // not 0: all that is left counts as one group

layout(location = 0) out vec4 oitFront;     // sum of opacity times colour; -depth of the nearest
layout(location = 1) out vec4 oitFrontSums; // opacity, optical depth, count; depth of the farthest
#ifdef OIT_DUAL
layout(location = 2) out vec4 oitBack;
layout(location = 3) out vec4 oitBackSums;
#endif

const float OIT_NO_DEPTH = -2.0;

void main()
{
  oitShade();
  float depth = oitGetDepth();
  vec4 color = oitGetColor();
  vec2 bounds = texelFetch(oitState, ivec3(gl_FragCoord.xy, 2), 0).xy;
  bool isLeft = color.a > 0.0 && depth >= bounds.x && depth <= bounds.y;
  bool isFront = isLeft && (oitRest != 0 || depth == bounds.x);
#ifdef OIT_DUAL
  bool isBack = isLeft && !isFront && depth == bounds.y;
  bool isInside = isLeft && !isFront && !isBack;
#else
  bool isInside = isLeft && !isFront;
#endif
  vec3 weighted = color.a * color.rgb;
  vec3 sums = vec3(color.a, oitGetOpticalDepth(color.a), 1.0);
  oitFront = vec4(isFront ? weighted : vec3(0.0), isInside ? -depth : OIT_NO_DEPTH);
  oitFrontSums = vec4(isFront ? sums : vec3(0.0), isInside ? depth : OIT_NO_DEPTH);
#ifdef OIT_DUAL
  oitBack = vec4(isBack ? weighted : vec3(0.0), OIT_NO_DEPTH);
  oitBackSums = vec4(isBack ? sums : vec3(0.0), OIT_NO_DEPTH);
#endif
}
