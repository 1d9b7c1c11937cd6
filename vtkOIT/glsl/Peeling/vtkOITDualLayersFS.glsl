// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What a peel takes from a pixel: the OIT_SIDE nearest and the OIT_SIDE farthest layers, each a
// group of coincident fragments. Buffers 0 to OIT_SIDE - 1 have the near groups in ascending order,
// the others the far ones in descending order:
//
//   half colours   key, mean colour rg, b and ratio, opacity
//   float colours  key, opacity; in a buffer after those of all keys: mean colour, ratio
//
// The key is the bits of the depth, a float in [0, 1], plus 1. The ratio is that of the sum of
// opacities to the opacity of the group: 1 for a single fragment, and larger for a true group.

#define OIT_MORE 0x40000000 // of the last key: layers were left out
#define OIT_LAYERS (2 * OIT_SIDE)

#ifdef OIT_FLOAT_COLOR
#define OITPacked uvec4
#else
#define OITPacked uvec2
#endif

struct OITLayer
{
  int Key;
  float Opacity;
  OITPacked Color; // mean colour, ratio
};

OITLayer oitKept[OIT_LAYERS];

#ifdef OIT_FLOAT_COLOR
OITLayer oitToLayer(uvec4 first, uvec4 second)
{
  return OITLayer(int(first.x), uintBitsToFloat(first.y), second);
}
#else
OITLayer oitToLayer(uvec4 bits)
{
  return OITLayer(int(bits.x), uintBitsToFloat(bits.w), bits.yz);
}
#endif

int oitGetKey(float depth) { return int(floatBitsToUint(depth)) + 1; }
float oitGetKeyDepth(int key) { return uintBitsToFloat(uint(key - 1)); }

// What reads the groups after Gather.
#ifdef OIT_READ_LAYERS
uniform usampler2DArray oitLayers;

#ifdef OIT_FLOAT_COLOR
#define OIT_LOAD_LAYER(i)                                                                          \
  oitKept[i] = oitToLayer(                                                                          \
    texelFetch(oitLayers, ivec3(pixel, i), 0),                                                     \
    texelFetch(oitLayers, ivec3(pixel, i + OIT_LAYERS), 0));
#else
#define OIT_LOAD_LAYER(i) oitKept[i] = oitToLayer(texelFetch(oitLayers, ivec3(pixel, i), 0));
#endif

void oitLoadLayers(ivec2 pixel)
{
  //VTK::OIT::LoadLayers
}
#endif
