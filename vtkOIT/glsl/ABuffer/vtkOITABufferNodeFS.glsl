// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Storage of the A-buffer, shared by all stages: Gather, Count, Sort, Resolve, Composite.
//
// A pixel's fragments are a linked list of nodes in capture order; oitHeads holds its first node.
// A node is one uvec4 (two with OIT_WIDE_NODES): one store instruction instead of several is what
// makes capture cheap on a CPU.
//
//   narrow  [0] = depth key, colour rg, colour ba, next node
//   wide    [0] = depth key, sample mask, unused, next node   [1] = colour
//   deferred[0] = depth key, material, next node              [1] = material, which is lit later
//
// With OIT_HAS_DRAW_ORDER one more uvec4 follows: number of the draw, and of the primitive in it.
//
// Defined by the pass: OIT_WIDE_NODES, OIT_FLOAT_COLOR, OIT_NODES_IN_IMAGE (the pool is larger than
// a storage block may be, so it is reached as a buffer texture), OIT_SAMPLES, OIT_NODE_TEXELS.

// Node 0 is never used, it is the end of a list: llvmpipe gives 0 to pixels of a block that are not
// covered but run along, and a walk over a list must end for them, too.
const uint OIT_NO_KEY = 0xffffffffu; // sorts behind every depth

#ifdef OIT_FLOAT_COLOR
#define OITColor uvec4
#else
#define OITColor uvec2
#endif

layout(binding = OIT_IMAGE_HEADS, r32ui) uniform uimage2D oitHeads;

struct OITTile
{
  uint Complexity; // largest number of fragments of a pixel, or marks
  uint Marked;     // that number, in tiles with marks
  uint Fragments;  // of all pixels
};
layout(std430, binding = OIT_BUFFER_COUNTERS) buffer OITCounters
{
  uint oitNextNode;    // where there are no regions, or they are exceeded
  uint oitMissingNode; // what pixels count on that are beyond the capacity: the size that is needed
  uint oitOverflow;    // set by Gather where it may wrap, and by Check for a region
  uint oitSkipped;     // bits of the largest transmittance in front of what was not composited
  uint oitUnused[12];
  OITTile oitTiles[];
};
layout(std430, binding = OIT_BUFFER_COUNTERS) buffer OITCounterWords // the same memory, with the regions
{
  uint oitCounterWords[];
};

uniform int oitCapacity; // nodes, the unused ones included
bool oitHasOverflown() { return oitOverflow != 0u || oitNextNode > uint(oitCapacity); }
uniform ivec2 oitOrigin; // framebuffer pixel of oitHeads' texel (0, 0)
uniform ivec2 oitCorner; // lower left pixel of the rectangle that is being rendered
uniform ivec2 oitSize;   // of that rectangle

// Tiles are aligned to multiples of their size in the framebuffer, as rasterizers have them.
uniform ivec2 oitFirstTile; // column, row
uniform int oitTileColumns;
int oitFindTile()
{
  ivec2 tile = ivec2(gl_FragCoord.xy) / OIT_TILE_SIZE - oitFirstTile;
  return tile.y * oitTileColumns + tile.x;
}

#ifdef OIT_NODES_IN_TEXTURE
// Of stages that only read: llvmpipe gathers texels for eight pixels by vector instructions.
uniform usamplerBuffer oitNodeTexels;
uvec4 oitLoad(uint word) { return texelFetch(oitNodeTexels, int(word)); }
uint oitLoadKey(uint word) { return oitLoad(word).x; }
uint oitLoadNext(uint word) { return oitLoad(word).w; }
#elif defined(OIT_NODES_IN_IMAGE)
layout(binding = OIT_IMAGE_NODES, rgba32ui) uniform uimageBuffer oitNodes;
uvec4 oitLoad(uint word) { return imageLoad(oitNodes, int(word)); }
uint oitLoadKey(uint word) { return imageLoad(oitNodes, int(word)).x; }
uint oitLoadNext(uint word) { return imageLoad(oitNodes, int(word)).w; }
void oitStore(uint word, uvec4 value) { imageStore(oitNodes, int(word), value); }
void oitStoreNext(uint word, uint next)
{
  uvec4 value = imageLoad(oitNodes, int(word));
  value.w = next;
  imageStore(oitNodes, int(word), value);
}
#else
layout(std430, binding = OIT_BUFFER_NODES) buffer OITNodes
{
  uvec4 oitNodes[];
};
layout(std430, binding = OIT_BUFFER_NODES) buffer OITNodeWords // the same memory: llvmpipe loads all of a vector
{
  uint oitNodeWords[];
};
uvec4 oitLoad(uint word) { return oitNodes[word]; }
void oitStore(uint word, uvec4 value) { oitNodes[word] = value; }
uint oitLoadKey(uint word) { return oitNodeWords[4u * word]; }
uint oitLoadNext(uint word) { return oitNodeWords[4u * word + 3u]; }
void oitStoreNext(uint word, uint next) { oitNodeWords[4u * word + 3u] = next; }
#endif

#define OIT_WORD(node) (uint(OIT_NODE_TEXELS) * (node))

//VTK::OIT::Half
