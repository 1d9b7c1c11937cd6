// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What a peeling pass keeps in each pixel from peel to peel, as layers of one texture array:
//
//   0  front: colour and transmittance of the layers peeled from the front
//   1  statistics: fragments; unused; error bound of what was cut off; fragments that were lost, or
//      1 while the first peel of layers that are kept has no room for all
//   2  bounds: depth of the nearest and of the farthest fragment left, or of the kept layers that are
//      just outside; nearest > farthest: none
//   3  and on: what a method adds
//
// A Resolve stage updates it in place where shaders can read the framebuffer (OIT_IN_PLACE).
// Otherwise it writes all layers anew, from the array of the last peel.

#define OIT_NO_BOUNDS vec4(2.0, -2.0, 0.0, 0.0)

#ifdef OIT_IN_PLACE
#define OIT_STATE_LAYER(i) layout(location = i) inout vec4 oitState##i;
#define OIT_LOAD_STATE(i)
#else
uniform sampler2DArray oitState;
#define OIT_STATE_LAYER(i) layout(location = i) out vec4 oitState##i;
#define OIT_LOAD_STATE(i) oitState##i = texelFetch(oitState, ivec3(gl_FragCoord.xy, i), 0);
#endif

OIT_STATE_LAYER(0)
OIT_STATE_LAYER(1)
OIT_STATE_LAYER(2)

uniform float oitTransmittanceThreshold;
uniform int oitFirstResolve; // not 0: there are no bounds yet

void oitLoadCommonState()
{
  OIT_LOAD_STATE(0)
  OIT_LOAD_STATE(1)
  OIT_LOAD_STATE(2)
}

// Under: behind what was peeled from the front.
void oitBlendUnder(vec3 color, float opacity)
{
  vec4 front = oitState0;
  front.rgb += front.a * color;
  front.a -= front.a * opacity;
  oitState0 = front;
}

// Notes the error of something that is left out, or blended out of order, behind this transmittance.
void oitNoteError(float bound)
{
  oitState1.z = max(oitState1.z, bound);
}

// Each peel takes the nearest fragment, so what is left is behind it, or equal in depth and later in
// the order of coincident fragments (multi-layer peeling). A pixel of which this does not hold has
// been drawn into past the Gather stage: it would be peeled for ever.
#ifdef OIT_SLOTS
vec2 oitOrder = vec2(0.0); // of the last fragment that was taken; next to the bounds from peel to peel
#endif
bool oitIsStalled(float nearest)
{
  bool advances = nearest > oitState2.x;
#ifdef OIT_SLOTS
  vec2 last = oitState2.zw;
  bool isLater = oitOrder.x > last.x || (oitOrder.x == last.x && oitOrder.y > last.y);
  advances = advances || (nearest == oitState2.x && isLater);
#endif
  return oitFirstResolve == 0 && !advances;
}

// What is left in the pixel. Nothing is peeled any more behind a transmittance at the threshold.
void oitSetBounds(float nearest, float farthest)
{
  bool isAlive = nearest <= farthest;
  if (isAlive && oitIsStalled(nearest))
  {
    oitNoteError(OIT_STALLED);
    isAlive = false;
  }
  if (isAlive && oitTransmittanceThreshold > 0.0 && oitState0.a <= oitTransmittanceThreshold)
  {
    oitNoteError(oitState0.a);
    isAlive = false;
  }
  oitState2 = isAlive ? vec4(nearest, farthest, 0.0, 0.0) : OIT_NO_BOUNDS;
}
