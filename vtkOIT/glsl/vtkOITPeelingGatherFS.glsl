// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, for depth peeling and dual depth peeling: fragments at the bounds of the pixel are summed
// up as the group of coincident fragments that is peeled now; of the fragments inside, the bounds
// of the next peel are found. Colours are added, depths are kept as the maximum. In the first
// pass everything is inside.
//
// Where each buffer can blend in its own way, depths have their own buffer. Otherwise, with
// OIT_JOINT_BLENDING, they are the alpha of the sums: one way of blending for colours, one for alpha.

uniform sampler2DArray oitState;
uniform int oitRest; // not 0: all that is left counts as one group

const float OIT_NO_DEPTH = -2.0;

#ifdef OIT_JOINT_BLENDING
layout(location = 0) out vec4 oitFront;     // sum of opacity times colour; -depth of the nearest
layout(location = 1) out vec4 oitFrontSums; // opacity, optical depth, count; depth of the farthest
#ifdef OIT_DUAL
layout(location = 2) out vec4 oitBack;
layout(location = 3) out vec4 oitBackSums;
#endif
#else
layout(location = 0) out vec4 oitDepths; // -depth of the nearest, depth of the farthest
layout(location = 1) out vec4 oitFront;  // sums of opacity times colour and of opacity
layout(location = 2) out vec4 oitSums;   // optical depth and count, of the front, of the back
#ifdef OIT_DUAL
layout(location = 3) out vec4 oitBack;
#endif
#endif

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
  const bool isBack = false;
  bool isInside = isLeft && !isFront;
#endif
  vec2 depths = isInside ? vec2(-depth, depth) : vec2(OIT_NO_DEPTH);
  vec4 front = isFront ? vec4(color.a * color.rgb, color.a) : vec4(0.0);
  vec4 back = isBack ? vec4(color.a * color.rgb, color.a) : vec4(0.0);
  vec2 sums = vec2(oitGetOpticalDepth(color.a), 1.0);
  vec2 frontSums = isFront ? sums : vec2(0.0);
  vec2 backSums = isBack ? sums : vec2(0.0);
#ifdef OIT_JOINT_BLENDING
  oitFront = vec4(front.rgb, depths.x);
  oitFrontSums = vec4(front.a, frontSums, depths.y);
#ifdef OIT_DUAL
  oitBack = vec4(back.rgb, OIT_NO_DEPTH);
  oitBackSums = vec4(back.a, backSums, OIT_NO_DEPTH);
#endif
#else
  oitDepths = vec4(depths, 0.0, 0.0);
  oitFront = front;
  oitSums = vec4(frontSums, backSums);
#ifdef OIT_DUAL
  oitBack = back;
#endif
#endif
}
