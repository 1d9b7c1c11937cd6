// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Constants that C++ and GLSL share: both compile this file. vtkOITShaderText puts it at the top of
// every stage.

// Texture units. Mappers count theirs up from 0, and GL has at least 16.
#define OIT_UNIT_BUCKET_TABLE 12 // slots of adaptive buckets
#define OIT_UNIT_STATE 13        // what pixels keep: state of peels, sums, tiles of the A-buffer
#define OIT_UNIT_GATHERED 14     // what Gather has written; expected depth complexity of tiles
#define OIT_UNIT_DEPTH 15        // opaque depth, or a layer
#define OIT_UNIT_NODES 15        // the pool of the A-buffer, where it is only read
#define OIT_UNIT_LIGHTS 12       // lights of deferred shading

// Image units and storage buffers of the A-buffer, image unit of multi-layer peeling.
#define OIT_IMAGE_HEADS 0
#define OIT_IMAGE_NODES 1
#define OIT_IMAGE_SLOTS 0
#define OIT_BUFFER_COUNTERS 0
#define OIT_BUFFER_NODES 1

// A-buffer: lists.
#define OIT_END 0u           // no node: node 0 is never used
#define OIT_PAGE_SIZE 4u     // nodes of a page
#define OIT_LEFT 0x80000000u // bit of a head: the pixel is left for Sort and Composite
#define OIT_LIGHT 2.0        // above all opacities: premultiplied light, see vtkOITFragmentFS.glsl
#define OIT_RUN_SIZE 16      // nodes of the runs that Sort starts from
#define OIT_SHORT_RUN 4      // the same until many lists were sorted: that compiles fast
#define OIT_MERGED_RUN 32    // fragments of the runs that Merge sorts
#define OIT_LONG_LIST 32     // fragments up to which all are composited, whatever the threshold
#define OIT_NETWORK_COUNT 8  // sorting networks in registers, and the fragments that they take
#define OIT_NETWORK_SIZES 4, 6, 8, 12, 16, 24, 32, 64

// Volumes: what a ray makes of its samples.
#define OIT_VOLUME_MARCHED 0   // each is composited, or each isosurface that it crosses
#define OIT_VOLUME_PROJECTED 1 // one layer
#define OIT_VOLUME_SLICE 2     // one layer, on a plane

// A-buffer: counters in words of 32 bits, a cache line; then the tiles, then a line for each region.
#define OIT_COUNTER_WORDS 16 // next node, next one that does not exist, overflow, skipped
#define OIT_WORD_MISSING 1
#define OIT_WORD_OVERFLOW 2
#define OIT_WORD_SKIPPED 3
#define OIT_REGION_SIZE 64  // pixels a side: of the tiles that llvmpipe draws by one thread
#define OIT_REGION_WORDS 16 // next node, next one that does not exist, end of the region
#define OIT_REGION_END 2
#define OIT_TILE_SIZE 16          // pixels a side
#define OIT_TILE_WORDS 3          // depth complexity or marks; that of marked tiles; fragments
#define OIT_TRY_AGAIN 0x20000000u // mark of a tile: some pixels need a second chance
#define OIT_HAS_LISTS 0x40000000u // mark of a tile: some pixels are left for Sort and Composite

// Blending into the framebuffer with a layer beside it: frames that are told apart, bits of an
// alpha, all ones.
#define OIT_STAMPS 255

// Statistics of pixels: pixels a side of a block that is summed up.
#define OIT_BLOCK_SIZE 16

// Peeling: layers of the state of a pixel.
#define OIT_STATE_FRONT 0
#define OIT_STATE_STATISTICS 1
#define OIT_STATE_BOUNDS 2
#define OIT_STATE_BACK 3 // what was peeled from the back, where that is done

// Peeling: an error bound that means that it would not have ended here.
#define OIT_STALLED 1e6

// Dual depth peeling: keys of no layer, near and far.
#define OIT_NO_NEAR 0x7fffffff // behind all others
#define OIT_NO_FAR 0           // before all others

// Multi-layer depth peeling: a depth behind all others.
#define OIT_EMPTY 0x3fffffffu

// Bucket depth peeling: layers of the state; no depth in a slot; the buffer that has the depths where
// coincident fragments are blended.
#define OIT_STATE_SLOTS 4
#define OIT_STATE_DIVISION 5
#define OIT_NO_SLOT 4.0
#define OIT_BUCKET_DEPTHS 4

// Single shots of it: stages; counts of two buckets in one float, below 4096 each; the layer of the
// table that is about the pixel.
#define OIT_SHOT_RANGE 0
#define OIT_SHOT_BUCKETS 1
#define OIT_SHOT_COLORS 2
#define OIT_COUNT_BASE 4096
#define OIT_TABLE_PIXEL 3
