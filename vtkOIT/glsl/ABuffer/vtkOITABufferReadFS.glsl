// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// One fragment out of the pool, for the stages Sort, Resolve and Composite.

struct OITFragment
{
  uint Key;
  uint Mask;
  OITColor Color;
  uint Next;
#ifdef OIT_LAST_ON_TOP
  uvec3 Order; // of drawing: draw, primitive, and the node, which later fragments of a pixel have later
#endif
};
#ifdef OIT_LAST_ON_TOP
#define OIT_FRAGMENT(key, mask, color, next, order) OITFragment(key, mask, color, next, order)
#else
#define OIT_FRAGMENT(key, mask, color, next, order) OITFragment(key, mask, color, next)
#endif
#define OIT_NO_FRAGMENT OIT_FRAGMENT(OIT_NO_KEY, 0u, OITColor(0u), OIT_END, uvec3(0u))

#ifdef OIT_HAS_DRAW_ORDER
#define OIT_ORDER(node) uvec3(oitLoad(OIT_WORD(node) + uint(OIT_NODE_TEXELS - 1)).xy, node)
#else
#define OIT_ORDER(node) uvec3(0u, 0u, node)
#endif

// Whether a fragment belongs to the group of the depth `key`.
#ifdef OIT_LAST_ON_TOP
#define OIT_IS_OF_GROUP(fragment) false
#else
#define OIT_IS_OF_GROUP(fragment) (fragment.Key == key)
#endif

// What of an unpacked colour lies over what is behind it, and what is only added to that.
#ifdef OIT_HAS_LIGHT
float oitGetCover(vec4 color) { return color.a > 1.0 ? 0.0 : color.a; }
vec3 oitGetAdded(vec4 color) { return color.a > 1.0 ? color.rgb : vec3(0.0); }
#else
#define oitGetCover(color) color.a
#endif

OITFragment oitRead(uint node)
{
  uvec4 word = oitLoad(OIT_WORD(node));
#ifdef OIT_WIDE_NODES
  uvec4 color = oitLoad(OIT_WORD(node) + 1u);
#ifdef OIT_FLOAT_COLOR
  return OIT_FRAGMENT(word.x, word.y, color, word.w, OIT_ORDER(node));
#else
  return OIT_FRAGMENT(word.x, word.y, color.xy, word.w, OIT_ORDER(node));
#endif
#else
  return OIT_FRAGMENT(word.x, 0u, word.yz, word.w, OIT_ORDER(node));
#endif
}

// A total order. With OIT_LAST_ON_TOP a coincident fragment that was drawn later is before; otherwise
// fragments that still compare equal are the same, so that the picture does not depend on the order in
// which they were drawn, to the last bit.
bool oitIsBefore(OITFragment a, OITFragment b)
{
  if (a.Key != b.Key) return a.Key < b.Key;
#if defined(OIT_LAST_ON_TOP)
  if (a.Order.x != b.Order.x) return a.Order.x > b.Order.x;
  if (a.Order.y != b.Order.y) return a.Order.y > b.Order.y;
  return a.Order.z > b.Order.z;
#else
  if (a.Color.x != b.Color.x) return a.Color.x < b.Color.x;
#ifdef OIT_FLOAT_COLOR
  if (a.Color.y != b.Color.y) return a.Color.y < b.Color.y;
  if (a.Color.z != b.Color.z) return a.Color.z < b.Color.z;
  return a.Color.w < b.Color.w;
#else
  return a.Color.y < b.Color.y;
#endif
#endif
}
