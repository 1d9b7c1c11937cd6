// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITDepthComplexityMap.h"

#include <algorithm>
#include <cstddef>

//------------------------------------------------------------------------------
void vtkOITDepthComplexityMap::Clear()
{
  this->Columns = 0;
  this->Rows = 0;
  this->Tiles.clear();
}

//------------------------------------------------------------------------------
void vtkOITDepthComplexityMap::Update(
  const vtkOITTileGrid& grid, const std::vector<std::uint32_t>& tiles)
{
  const int columns = std::max(this->Columns, grid.FirstColumn + grid.Columns);
  const int rows = std::max(this->Rows, grid.FirstRow + grid.Rows);
  if (columns != this->Columns || rows != this->Rows)
  {
    std::vector<std::uint32_t> grown(static_cast<std::size_t>(columns) * rows, 0u);
    for (int row = 0; row < this->Rows; ++row)
    {
      std::copy_n(this->Tiles.begin() + static_cast<std::ptrdiff_t>(row) * this->Columns,
        this->Columns, grown.begin() + static_cast<std::ptrdiff_t>(row) * columns);
    }
    this->Tiles.swap(grown);
    this->Columns = columns;
    this->Rows = rows;
  }
  for (int row = 0; row < grid.Rows; ++row)
  {
    std::copy_n(tiles.begin() + static_cast<std::ptrdiff_t>(row) * grid.Columns, grid.Columns,
      this->Tiles.begin() + static_cast<std::ptrdiff_t>(grid.FirstRow + row) * this->Columns +
        grid.FirstColumn);
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkOITDepthComplexityMap::GetExpected(const vtkOITTileGrid& grid) const
{
  std::vector<std::uint32_t> expected;
  expected.reserve(grid.GetNumberOfTiles());
  for (int row = grid.FirstRow; row < grid.FirstRow + grid.Rows; ++row)
  {
    for (int column = grid.FirstColumn; column < grid.FirstColumn + grid.Columns; ++column)
    {
      const bool isKnown = row < this->Rows && column < this->Columns;
      expected.push_back(
        isKnown ? this->Tiles[static_cast<std::size_t>(row) * this->Columns + column] : 0u);
    }
  }
  return expected;
}
