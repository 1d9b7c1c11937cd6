//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Two triangles for each tile whose depth complexity is in oitTileClass; other tiles vanish. The
// viewport is the tile grid. llvmpipe runs every branch of a fragment shader, so a shader that
// only some pixels need must not be started elsewhere.

uniform usamplerBuffer oitTileTexels; // OITCounters as a texture, four words before the tiles
uniform ivec2 oitTileDimensions;      // columns, rows
uniform ivec2 oitTileClass;           // smallest and largest depth complexity
uniform int oitTiedTiles;             // 1: also tiles with coincident fragments

void main()
{
  int tile = gl_VertexID / 6;
  int corner = gl_VertexID - 6 * tile;
  uint info = texelFetch(oitTileTexels, 4 + tile).x;
  int count = int(info & 0x7fffffffu);
  bool isTied = (info & 0x80000000u) != 0u;
  bool isInClass = oitTileClass.x <= count && count <= oitTileClass.y;
  if (!isInClass && !(isTied && oitTiedTiles == 1))
  {
    gl_Position = vec4(-2.0, -2.0, 0.0, 1.0);
    return;
  }
  ivec2 at = ivec2(tile % oitTileDimensions.x, tile / oitTileDimensions.x);
  // 0 1 2 of the lower right triangle, 3 4 5 of the upper left one
  at += ivec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner >= 4);
  gl_Position = vec4(2.0 * vec2(at) / vec2(oitTileDimensions) - 1.0, 0.0, 1.0);
}
