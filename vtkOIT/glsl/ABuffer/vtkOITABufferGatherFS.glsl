// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Capture: the mapper's own shader, renamed oitShade(), leaves its colour in oitFragColor; this
// main() prepends it to the list of the pixel.
//
// With OIT_HEAD_IN_TARGET a pixel takes a page of nodes at once, so that its fragments lie in one cache
// line and few of them need a counter. Each region of the screen has its own part of the pool, and its
// counter a cache line of its own, so that threads which draw different regions share none; or all
// pixels take from one counter. Nothing is tested here: Check finds regions that were exceeded. A pixel
// whose pages are beyond the capacity goes on through nodes that do not exist, of another counter: so the
// first one passes the capacity by a page a pixel at most and cannot wrap, and both tell what is needed.
//
// The hardware's depth test against the opaque geometry runs before (early_fragment_tests), so a
// fragment gets here exactly when plain blending would draw it. Shaders that write gl_FragDepth
// cannot have that, their test runs after. With OIT_HEAD_IN_TARGET that is as good: the list heads
// are the colour buffer, read by framebuffer fetch, and a fragment that fails the test does not
// become the head. Otherwise (OIT_TEST_DEPTH) they compare with a copy of the depth buffer.
//
// With OIT_LAST_ON_TOP nodes of a pixel count up in the order of drawing: by framebuffer fetch, or by
// the interlock. Without both, each has its place in that order (OIT_HAS_DRAW_ORDER).

#ifdef OIT_HEAD_IN_TARGET
inout uint oitHead;
uniform vec3 oitRegionStrides; // words from one region to the next in x and y, and of the first one
#elif defined(OIT_WRITES_DEPTH) && !defined(OIT_TEST_DEPTH)
#define OIT_TEST_DEPTH
#endif

#ifdef OIT_TEST_DEPTH
#if OIT_SAMPLES > 0
uniform sampler2DMS oitOpaqueDepth; // of the pixels from oitOrigin on
#else
uniform sampler2D oitOpaqueDepth;
#endif
//VTK::OIT::DepthTest
#endif

#ifdef OIT_HAS_DRAW_ORDER
uniform int oitDrawNumber; // in this geometry pass
#endif

#ifdef OIT_DEFERRED
//VTK::OIT::Material
#endif

#ifdef OIT_INTERLOCK
layout(pixel_interlock_ordered) in;
#endif

void oitCapture()
{
  float opacity = oitGetOpacity();
  if (opacity == 0.0)
  {
    return;
  }
  float depth = oitGetDepth();
  ivec2 pixel = ivec2(gl_FragCoord.xy) - oitOrigin;

#if OIT_SAMPLES > 0
  uint mask = uint(gl_SampleMaskIn[0]);
#ifdef OIT_TEST_DEPTH
  for (int s = 0; s < OIT_SAMPLES; ++s)
  {
    if (!oitPassesDepthTest(depth, texelFetch(oitOpaqueDepth, pixel, s).r))
    {
      mask &= ~(1u << uint(s));
    }
  }
#endif
  if (mask == 0u)
  {
    return;
  }
#elif defined(OIT_TEST_DEPTH)
  if (!oitPassesDepthTest(depth, texelFetch(oitOpaqueDepth, pixel, 0).r))
  {
    return;
  }
#endif

  uint key = floatBitsToUint(depth);
#ifdef OIT_DEFERRED
  OITColor color;
  uvec4 material = oitPackMaterial(opacity, color);
  bool isFull = (color.x & color.y & material.x & material.y & material.z & material.w) == 0xffffffffu;
#elif defined(OIT_HAS_LIGHT)
  OITColor color = oitPack(oitGetLightOr(vec4(oitFragColor.rgb, opacity)));
#else
  OITColor color = oitPack(vec4(oitFragColor.rgb, opacity));
#endif
#ifdef OIT_HEAD_IN_TARGET
  // The next node of the page of the pixel's last fragment, or the first one of a new page. The
  // test of the colour is never true: halves are at most 0x7bff. Without it, LLVM moves the packing
  // into the loop over the lanes that a store is on llvmpipe, where it runs for one lane at a time.
  uint next = oitHead;
  uint node = next + 1u;
  if (next == OIT_END || node % OIT_PAGE_SIZE == 0u)
  {
    vec2 region = floor(gl_FragCoord.xy / float(OIT_REGION_SIZE));
    uint counter = uint(dot(region, oitRegionStrides.xy) + oitRegionStrides.z);
    counter += next < uint(oitCapacity) ? 0u : uint(OIT_WORD_MISSING);
    node = atomicAdd(oitCounterWords[counter], OIT_PAGE_SIZE);
  }
#ifdef OIT_DEFERRED
  oitHead = isFull ? OIT_END : node;
#elif !defined(OIT_FLOAT_COLOR)
  oitHead = (color.x & color.y) == 0xffffffffu ? OIT_END : node;
#else
  oitHead = node;
#endif
#else
  uint node = atomicAdd(oitNextNode, 1u);
  if (node == uint(oitCapacity)) // once, however far the count goes
  {
    oitOverflow = 1u;
  }
#endif
  if (node >= uint(oitCapacity))
  {
    return;
  }
#ifndef OIT_HEAD_IN_TARGET
  uint next = imageAtomicExchange(oitHeads, pixel, node);
#endif
  uint word = OIT_WORD(node);
#ifdef OIT_WIDE_NODES
#if OIT_SAMPLES > 0
  oitStore(word, uvec4(key, mask, 0u, next));
#else
  oitStore(word, uvec4(key, 0u, 0u, next));
#endif
#ifdef OIT_FLOAT_COLOR
  oitStore(word + 1u, color);
#else
  oitStore(word + 1u, uvec4(color, 0u, 0u));
#endif
#else
  oitStore(word, uvec4(key, color, next));
#endif
#ifdef OIT_DEFERRED
  oitStore(word + 1u, material);
#endif
#ifdef OIT_HAS_DRAW_ORDER
  oitStore(word + uint(OIT_NODE_TEXELS - 1), uvec4(oitDrawNumber, gl_PrimitiveID, 0u, 0u));
#endif
}

void main()
{
  oitShade();
#ifdef OIT_INTERLOCK
  beginInvocationInterlockARB(); // so that lists are in the order of drawing
#endif
  oitCapture();
#ifdef OIT_INTERLOCK
  endInvocationInterlockARB();
#endif
}
