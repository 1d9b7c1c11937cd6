// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITTileGrid_h
#define vtkOITTileGrid_h

#include "Private/Frame/vtkOITRectangle.h"

#include "glsl/Common/vtkOITConstants.h"

/// The tiles that cover a rectangle, aligned to multiples of their size; or larger squares.
struct vtkOITTileGrid
{
  static constexpr int TileSize = OIT_TILE_SIZE;

  explicit vtkOITTileGrid(const vtkOITRectangle& r = {}, int size = TileSize)
    : FirstColumn(r.X / size)
    , FirstRow(r.Y / size)
    , Columns((r.X + r.Width + size - 1) / size - this->FirstColumn)
    , Rows((r.Y + r.Height + size - 1) / size - this->FirstRow)
  {
  }
  int GetNumberOfTiles() const { return this->Columns * this->Rows; }

  int FirstColumn;
  int FirstRow;
  int Columns;
  int Rows;
};

#endif
