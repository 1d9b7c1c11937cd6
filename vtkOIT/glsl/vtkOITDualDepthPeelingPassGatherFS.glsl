// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather, for dual depth peeling where shaders can read the framebuffer: the two nearest and the
// two farthest layers of a pixel are summed up, each as a group of coincident fragments, and the
// next two of each side are found inside. In the first pass everything is inside.

uniform int oitRest; // not 0: all that is left counts as one group

layout(location = 0) inout vec4 oitInside; // nearest, farthest, second nearest, second farthest of
                                           // what is inside, for the next peel
layout(location = 1) inout vec4 oitBounds; // the same of what is left
layout(location = 2) inout vec4 oitFront;  // sums of opacity times colour and of opacity
layout(location = 3) inout vec4 oitSecondFront;
layout(location = 4) inout vec4 oitBack;
layout(location = 5) inout vec4 oitSecondBack;
layout(location = 6) inout vec4 oitOpacities; // of the groups, in the order of the bounds
layout(location = 7) inout vec4 oitStatistics;

void main()
{
  oitShade();
  float depth = oitGetDepth();
  vec4 color = oitGetColor();
  bool isLeft = color.a > 0.0 && depth >= oitBounds.x && depth <= oitBounds.y;
  bool isRest = oitRest != 0;
  bool isFront = isLeft && (isRest || depth == oitBounds.x);
  bool isSecondFront = isLeft && !isFront && depth == oitBounds.z;
  bool isFromFront = isFront || isSecondFront;
  bool isBack = isLeft && !isFromFront && depth == oitBounds.y;
  bool isSecondBack = isLeft && !isFromFront && !isBack && depth == oitBounds.w;
  bool isInside = isLeft && !isFromFront && !isBack && !isSecondBack;

  // Two smallest and two largest distinct values.
  float near = isInside ? depth : 2.0;
  float far = isInside ? depth : -2.0;
  vec4 inside = oitInside;
  inside.z = near < inside.x ? inside.x : near > inside.x ? min(inside.z, near) : inside.z;
  inside.w = far > inside.y ? inside.y : far < inside.y ? max(inside.w, far) : inside.w;
  inside.x = min(inside.x, near);
  inside.y = max(inside.y, far);
  oitInside = inside;

  vec4 weighted = vec4(color.a * color.rgb, color.a);
  vec4 match = vec4(isFront, isBack, isSecondFront, isSecondBack);
  oitFront += match.x * weighted;
  oitBack += match.y * weighted;
  oitSecondFront += match.z * weighted;
  oitSecondBack += match.w * weighted;
  oitOpacities += (1.0 - oitOpacities) * (color.a * match);
  oitStatistics.x += dot(match, vec4(1.0));
}
