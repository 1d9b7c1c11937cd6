// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The nearest layers of a pixel that are left, OIT_SLOTS buffers in ascending order. With OIT_PAIRS
// a buffer holds two layers:
//
//   one layer    depth, identity, colour rg, colour ba (halves)
//   OIT_PAIRS    depth, colour (RGBA8), depth, colour
//
// Depths are the bits of a float in [0, 1], so they sort as integers and have two bits to spare. The
// identity tells coincident fragments apart: fragments are ordered by depth, then by identity. With
// OIT_LAST_ON_TOP they come in the order of drawing, and stay in it without an identity; that of the last
// slot counts, in a geometry pass, those which have the depth of the layer peeled last.

#define OIT_DEPTH_MASK 0x3fffffffu
#define OIT_MORE 0x80000000u // of the last depth: fragments behind it were left out
#define OIT_TIED 0x40000000u // of the last depth: one of them had the same depth

#if defined(OIT_RESOLVE)
uniform usampler2DArray oitSlots;
#define OIT_LOAD_SLOT(i) slots[i] = texelFetch(oitSlots, ivec3(gl_FragCoord.xy, i), 0);
#elif defined(OIT_FETCH) // Gather, ordered by the hardware
#define OIT_SLOT_BUFFER(i) layout(location = i) inout uvec4 oitSlot##i;
#define OIT_LOAD_SLOT(i) slots[i] = oitSlot##i;
#define OIT_STORE_SLOT(i) oitSlot##i = slots[i];
#elif defined(OIT_INTERLOCK) // Gather, one fragment of a pixel after the other
layout(pixel_interlock_ordered) in;
layout(binding = OIT_IMAGE_SLOTS, rgba32ui) coherent uniform uimage2DArray oitSlots;
#define OIT_SLOT_BUFFER(i)
#define OIT_LOAD_SLOT(i) slots[i] = imageLoad(oitSlots, ivec3(gl_FragCoord.xy, i));
#define OIT_STORE_SLOT(i) imageStore(oitSlots, ivec3(gl_FragCoord.xy, i), slots[i]);
#elif defined(OIT_BARRIER) // Gather, reading what it writes
uniform usampler2DArray oitSlots;
#define OIT_SLOT_BUFFER(i) layout(location = i) out uvec4 oitSlot##i;
#define OIT_LOAD_SLOT(i) slots[i] = texelFetch(oitSlots, ivec3(gl_FragCoord.xy, i), 0);
#define OIT_STORE_SLOT(i) oitSlot##i = slots[i];
#endif

#if defined(OIT_PAIRS)
uint oitPack8(vec4 color)
{
  uvec4 c = uvec4(clamp(color, vec4(0.0), vec4(1.0)) * 255.0 + 0.5);
  return c.x | (c.y << 8u) | (c.z << 16u) | (c.w << 24u);
}
vec4 oitUnpack8(uint bits)
{
  uvec4 c = (uvec4(bits) >> uvec4(0u, 8u, 16u, 24u)) & 0xffu;
  return vec4(c) / 255.0;
}
#endif
