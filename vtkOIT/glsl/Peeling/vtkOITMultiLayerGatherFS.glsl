// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather: insertion sort of the fragments behind the layer peeled last, as far as there are slots
// (Liu, Wei and Xu 2006, table 2).

uniform sampler2DArray oitState;
uniform int oitRest;       // not 0: all that is left counts as one group
uniform int oitDrawNumber; // the same for a draw in each peel

uniform sampler2D oitOpaqueDepth;
uniform int oitTestsDepth; // 0: nothing is in the way; 1: the hardware tests; 2: against a Mask only
//VTK::OIT::DepthTest

//VTK::OIT::SlotBuffers

uvec4 slots[OIT_SLOTS];

bool oitIsBefore(uvec2 a, uvec2 b)
{
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// Ends with what does not fit in. Depths keep their flags out of the comparisons by being masked.
#ifdef OIT_PAIRS
void oitInsert(uint depth, vec4 color)
{
  uvec2 layer = uvec2(depth, oitPack8(color));
  uint flags = slots[OIT_SLOTS - 1].z & ~OIT_DEPTH_MASK;
  slots[OIT_SLOTS - 1].z &= OIT_DEPTH_MASK;
  uint last = slots[OIT_SLOTS - 1].z;
  for (int i = 0; i < OIT_SLOTS; ++i)
  {
    uvec2 first = slots[i].xy;
    bool isBefore = layer.x < first.x;
    slots[i].xy = isBefore ? layer : first;
    layer = isBefore ? first : layer;
    uvec2 second = slots[i].zw;
    isBefore = layer.x < second.x;
    slots[i].zw = isBefore ? layer : second;
    layer = isBefore ? second : layer;
  }
  uint newLast = slots[OIT_SLOTS - 1].z;
  bool isTied = layer.x == newLast || (newLast == last && (flags & OIT_TIED) != 0u);
  if (layer.x < OIT_EMPTY)
  {
    flags |= OIT_MORE;
  }
  slots[OIT_SLOTS - 1].z = newLast | (flags & OIT_MORE) |
    (isTied && newLast < OIT_EMPTY ? OIT_TIED : 0u);
}
#else
void oitInsert(uint depth, uint id, vec4 color)
{
  uvec4 layer = uvec4(depth, id, oitPack(color));
  uint more = slots[OIT_SLOTS - 1].x & OIT_MORE;
  slots[OIT_SLOTS - 1].x &= OIT_DEPTH_MASK;
  for (int i = 0; i < OIT_SLOTS; ++i)
  {
    uvec4 slot = slots[i];
    bool isBefore = oitIsBefore(layer.xy, slot.xy);
    slots[i] = isBefore ? layer : slot;
    layer = isBefore ? slot : layer;
  }
  slots[OIT_SLOTS - 1].x |= layer.x < OIT_EMPTY ? OIT_MORE : more;
}
#endif

// Sums instead of layers: opacity times colour and opacity; opacity of the group and count.
void oitAddToRest(vec4 color, bool isLeft)
{
  vec4 sums = uintBitsToFloat(slots[0]);
  vec4 group = uintBitsToFloat(slots[1]);
  if (isLeft)
  {
#ifdef OIT_LAST_ON_TOP
    sums *= 1.0 - color.a;
#endif
    sums += vec4(color.a * color.rgb, color.a);
    group.x += (1.0 - group.x) * color.a;
    group.y += 1.0;
  }
  slots[0] = floatBitsToUint(sums);
  slots[1] = floatBitsToUint(group);
}

void main()
{
  oitShade();
  float depth = oitGetDepth();
  vec4 color = oitGetColor();
  vec4 bounds = texelFetch(oitState, ivec3(gl_FragCoord.xy, OIT_STATE_BOUNDS), 0);
  bool isLeft = color.a > 0.0 && bounds.x <= bounds.y && depth >= bounds.x;
#if defined(OIT_INTERLOCK) && defined(OIT_WRITES_DEPTH)
  // What goes into an image is not undone by a test that comes after the shader.
  const int leastUntested = 1;
#else
  const int leastUntested = 2;
#endif
  if (oitTestsDepth >= leastUntested)
  {
    float opaqueDepth = texelFetch(oitOpaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
    isLeft = isLeft && oitPassesDepthTest(depth, opaqueDepth);
  }
#ifdef OIT_PAIRS
  isLeft = isLeft && depth != bounds.x;
#elif !defined(OIT_LAST_ON_TOP)
  uint id = uint(gl_PrimitiveID) + uint(oitDrawNumber) * 2654435761u;
  uint lastId = uint(bounds.z) * 65536u + uint(bounds.w);
  isLeft = isLeft && (depth != bounds.x || id > lastId);
#endif
#ifdef OIT_INTERLOCK
  beginInvocationInterlockARB();
#endif
  //VTK::OIT::LoadSlots
#if defined(OIT_LAST_ON_TOP) && !defined(OIT_PAIRS)
  const uint id = 0u;
  bool isAtLast = isLeft && depth == bounds.x;
  uint taken = uint(bounds.z) * 65536u + uint(bounds.w); // of those
  uint seen = slots[OIT_SLOTS - 1].y + uint(isAtLast);
  slots[OIT_SLOTS - 1].y = id;
  isLeft = isLeft && (!isAtLast || seen > taken);
#endif
  uint key = isLeft ? floatBitsToUint(depth) : OIT_EMPTY;
#ifdef OIT_BARRIER
  // Finds out whether the fragment changes anything: it does not when it is in a slot already, or
  // behind all of them. The product of the paper's duplicate test underflows for close layers.
  uvec2 me = uvec2(key, id);
  bool isKept = isLeft && oitIsBefore(me, slots[OIT_SLOTS - 1].xy);
  for (int i = 0; i < OIT_SLOTS; ++i)
  {
    isKept = isKept && slots[i].xy != me;
  }
  if (oitRest == 0 && !isKept)
  {
    discard;
  }
#endif
  if (oitRest != 0)
  {
    oitAddToRest(color, isLeft);
  }
  else
  {
#ifdef OIT_PAIRS
    oitInsert(key, color);
#else
    oitInsert(key, id, color);
#endif
  }
#if defined(OIT_LAST_ON_TOP) && !defined(OIT_PAIRS)
  slots[OIT_SLOTS - 1].y = seen;
#endif
  //VTK::OIT::StoreSlots
#ifdef OIT_INTERLOCK
  endInvocationInterlockARB();
#endif
}
