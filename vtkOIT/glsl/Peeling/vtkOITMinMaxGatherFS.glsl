// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, for depth peeling, and for dual depth peeling where shaders cannot read the framebuffer:
// fragments at the bounds of the pixel are summed up as the group of coincident fragments that is
// peeled now; of the fragments inside, the bounds of the next peel are found. In the first pass
// everything is inside.
//
// With OIT_IN_PLACE the shader reads and writes what the pixel has. Otherwise sums are blended:
// colours are added and alpha is kept as the maximum, one way of blending for all buffers.
//
// With OIT_LAST_ON_TOP the group is blended in the order of drawing: GL_ONE, GL_ONE_MINUS_SRC_ALPHA in
// all buffers but the one with the depths, which keeps the maximum of them and sums up alpha.

uniform int oitRest; // not 0: all that is left counts as one group

const float OIT_NO_DEPTH = -2.0;

#ifdef OIT_IN_PLACE
layout(location = 0) inout vec4 oitBounds; // nearest, farthest; -nearest and farthest inside
layout(location = 1) inout vec4 oitFront;  // sums of opacity times colour and of opacity
layout(location = 2) inout vec4 oitGroup;  // opacity of the group and count
#elif defined(OIT_LAST_ON_TOP)
uniform sampler2DArray oitState;
layout(location = 0) out vec4 oitFront;  // opacity times colour, opacity
layout(location = 1) out vec4 oitDepths; // -depth of the nearest, depth of the farthest, 0; count
#ifdef OIT_DUAL
layout(location = 2) out vec4 oitBack;
#endif
#else
uniform sampler2DArray oitState;
layout(location = 0) out vec4 oitFront;     // sum of opacity times colour; -depth of the nearest
layout(location = 1) out vec4 oitFrontSums; // opacity, optical depth, count; depth of the farthest
#ifdef OIT_DUAL
layout(location = 2) out vec4 oitBack;
layout(location = 3) out vec4 oitBackSums;
#endif
#endif

void main()
{
  oitShade();
  float depth = oitGetDepth();
  vec4 color = oitGetColor();
#ifdef OIT_IN_PLACE
  vec2 bounds = oitBounds.xy;
#else
  vec2 bounds = texelFetch(oitState, ivec3(gl_FragCoord.xy, OIT_STATE_BOUNDS), 0).xy;
#endif
  bool isLeft = color.a > 0.0 && depth >= bounds.x && depth <= bounds.y;
  bool isFront = isLeft && (oitRest != 0 || depth == bounds.x);
#ifdef OIT_DUAL
  bool isBack = isLeft && !isFront && depth == bounds.y;
#else
  bool isBack = false;
#endif
  vec2 inside = isLeft && !isFront && !isBack ? vec2(-depth, depth) : vec2(OIT_NO_DEPTH);
  vec3 weighted = color.a * color.rgb;
#ifdef OIT_IN_PLACE
  oitBounds.zw = max(oitBounds.zw, inside);
  oitGroup.x += isFront ? (1.0 - oitGroup.x) * color.a : 0.0;
  oitGroup.y += float(isFront);
#ifdef OIT_LAST_ON_TOP
  oitFront = isFront ? vec4(weighted, color.a) + (1.0 - color.a) * oitFront : oitFront;
#else
  oitFront += isFront ? vec4(weighted, color.a) : vec4(0.0);
#endif
#elif defined(OIT_LAST_ON_TOP)
  vec4 layer = vec4(weighted, color.a);
  oitFront = isFront ? layer : vec4(0.0);
  oitDepths = vec4(inside, 0.0, float(isFront || isBack));
#ifdef OIT_DUAL
  oitBack = isBack ? layer : vec4(0.0);
#endif
#else
  vec3 sums = vec3(color.a, oitGetOpticalDepth(color.a), 1.0);
  oitFront = vec4(isFront ? weighted : vec3(0.0), inside.x);
  oitFrontSums = vec4(isFront ? sums : vec3(0.0), inside.y);
#ifdef OIT_DUAL
  oitBack = vec4(isBack ? weighted : vec3(0.0), OIT_NO_DEPTH);
  oitBackSums = vec4(isBack ? sums : vec3(0.0), OIT_NO_DEPTH);
#endif
#endif
}
