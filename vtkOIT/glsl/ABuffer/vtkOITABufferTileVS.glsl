//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Two triangles for each tile that the stage is for; other tiles vanish. The viewport is the tile
// grid. llvmpipe runs every branch of a fragment shader for every pixel, so a shader that only some
// pixels need must not be started elsewhere.

uniform usamplerBuffer oitTileTexels;     // OITCounters as a texture: OIT_COUNTER_WORDS, then three a tile
uniform usamplerBuffer oitExpectedTexels; // depth complexity that is expected of each tile
uniform int oitCapacity;
uniform ivec2 oitTileDimensions;          // columns, rows
uniform ivec2 oitTileClass; // smallest and largest expected depth complexity; or -1 and the mark
flat out int oitNetworkSize; // of the first try; -1: this is the first

int oitFindNetworkSize(int expected)
{
  int sizes[OIT_NETWORK_COUNT] = int[OIT_NETWORK_COUNT](OIT_NETWORK_SIZES);
  int i = 0;
  while (i + 1 < OIT_NETWORK_COUNT && sizes[i] < expected)
  {
    ++i;
  }
  return sizes[i];
}

void main()
{
  int tile = gl_VertexID / 6;
  int corner = gl_VertexID - 6 * tile;
  int expected = int(texelFetch(oitExpectedTexels, tile).x);
  oitNetworkSize = -1;
  bool isMine = oitTileClass.x <= expected && expected <= oitTileClass.y;
  if (oitTileClass.x < 0)
  {
    oitNetworkSize = oitFindNetworkSize(expected);
    isMine = (texelFetch(oitTileTexels, OIT_COUNTER_WORDS + OIT_TILE_WORDS * tile).x & uint(oitTileClass.y)) != 0u;
  }
  bool hasOverflown = texelFetch(oitTileTexels, OIT_WORD_OVERFLOW).x != 0u // the frame will be rendered again
    || texelFetch(oitTileTexels, 0).x > uint(oitCapacity);
  if (!isMine || hasOverflown)
  {
    gl_Position = vec4(-2.0, -2.0, 0.0, 1.0);
    return;
  }
  ivec2 at = ivec2(tile % oitTileDimensions.x, tile / oitTileDimensions.x);
  // 0 1 2 of the lower right triangle, 3 4 5 of the upper left one
  at += ivec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner >= 4);
  gl_Position = vec4(2.0 * vec2(at) / vec2(oitTileDimensions) - 1.0, 0.0, 1.0);
}
