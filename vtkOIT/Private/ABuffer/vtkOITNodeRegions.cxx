// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITNodeRegions.h"

#include <algorithm>
#include <cstddef>

namespace
{
constexpr int Size = OIT_REGION_SIZE;

// Frames that are drawn before regions are used, and before memory is asked for them.
constexpr int FramesToStart = 2;
constexpr int FramesToGrow = 8;

// What a region may have more than the last frame, in parts of the most in it and its neighbours: when it is
// made, and when it is kept.
constexpr int PartsMade = 4;
constexpr int PartsKept = 16;

// Nodes of a region where nothing was near.
constexpr std::int64_t LeastNodes = 64 * OIT_PAGE_SIZE;

// Frames without regions after one that has exceeded them, at first and at most: a camera that jumps each
// time draws one of so many frames twice.
constexpr int ShortestPause = 8;
constexpr int LongestPause = 128;
}

//------------------------------------------------------------------------------
void vtkOITNodeRegions::Update(
  const vtkOITTileGrid& tiles, const std::vector<std::uint32_t>& fragments)
{
  constexpr int tilesPerRegion = Size / vtkOITTileGrid::TileSize;
  this->Columns = (tiles.FirstColumn + tiles.Columns + tilesPerRegion - 1) / tilesPerRegion;
  this->Rows = (tiles.FirstRow + tiles.Rows + tilesPerRegion - 1) / tilesPerRegion;
  this->Fragments.assign(static_cast<std::size_t>(this->Columns) * this->Rows, 0);
  for (int row = 0; row < tiles.Rows; ++row)
  {
    for (int column = 0; column < tiles.Columns; ++column)
    {
      const int regionRow = (tiles.FirstRow + row) / tilesPerRegion;
      const int regionColumn = (tiles.FirstColumn + column) / tilesPerRegion;
      this->Fragments[static_cast<std::size_t>(regionRow) * this->Columns + regionColumn] +=
        fragments[static_cast<std::size_t>(row) * tiles.Columns + column];
    }
  }
  this->Frames = std::min(this->Frames + 1, FramesToGrow);
  this->Paused = std::max(this->Paused - 1, 0);
}

//------------------------------------------------------------------------------
void vtkOITNodeRegions::NoteExceeded()
{
  this->Pause = std::clamp(2 * this->Pause, ShortestPause, LongestPause);
  this->Paused = this->Pause;
  this->Regions.clear();
}

//------------------------------------------------------------------------------
std::int64_t vtkOITNodeRegions::GetFragments(int column, int row) const
{
  const bool isKnown = column >= 0 && row >= 0 && column < this->Columns && row < this->Rows;
  return isKnown ? this->Fragments[static_cast<std::size_t>(row) * this->Columns + column] : 0;
}

//------------------------------------------------------------------------------
// Nodes that a region is to have. Each pixel leaves three nodes of its last page empty at most.
std::int64_t vtkOITNodeRegions::FindSize(
  const vtkOITRectangle& rectangle, int column, int row, int parts) const
{
  std::int64_t most = 0;
  for (int y = row - 1; y <= row + 1; ++y)
  {
    for (int x = column - 1; x <= column + 1; ++x)
    {
      most = std::max(most, this->GetFragments(x, y));
    }
  }
  const std::int64_t fragments = this->GetFragments(column, row) + most / parts;
  vtkOITRectangle square;
  square.X = column * Size;
  square.Y = row * Size;
  square.Width = square.Height = Size;
  const std::int64_t pixels = std::min(fragments, square.Intersect(rectangle).GetArea());
  constexpr std::int64_t page = OIT_PAGE_SIZE;
  const std::int64_t nodes = std::max(LeastNodes, fragments + (page - 1) * pixels);
  return (nodes + page - 1) / page * page;
}

//------------------------------------------------------------------------------
std::int64_t vtkOITNodeRegions::FindNodes(const vtkOITRectangle& rectangle) const
{
  if (this->Frames < FramesToGrow || this->Paused > 0)
  {
    return 0;
  }
  const vtkOITTileGrid grid(rectangle, Size);
  std::int64_t nodes = OIT_PAGE_SIZE;
  for (int row = grid.FirstRow; row < grid.FirstRow + grid.Rows; ++row)
  {
    for (int column = grid.FirstColumn; column < grid.FirstColumn + grid.Columns; ++column)
    {
      nodes += this->FindSize(rectangle, column, row, PartsMade);
    }
  }
  return nodes;
}

//------------------------------------------------------------------------------
// Whether the last regions are large enough.
bool vtkOITNodeRegions::Holds(const vtkOITRectangle& rectangle, std::int64_t nodes) const
{
  const vtkOITTileGrid grid(rectangle, Size);
  if (this->Regions.empty() || this->Regions.back().End > nodes ||
    grid.FirstColumn != this->Grid.FirstColumn || grid.FirstRow != this->Grid.FirstRow ||
    grid.Columns != this->Grid.Columns || grid.Rows != this->Grid.Rows)
  {
    return false;
  }
  for (std::size_t i = 0; i < this->Regions.size(); ++i)
  {
    const int row = grid.FirstRow + static_cast<int>(i) / grid.Columns;
    const int column = grid.FirstColumn + static_cast<int>(i) % grid.Columns;
    if (this->FindSize(rectangle, column, row, PartsKept) >
      static_cast<std::int64_t>(this->Regions[i].End) - this->Regions[i].Begin)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITNodeRegions::Plan(const vtkOITRectangle& rectangle, std::int64_t nodes)
{
  if (this->Frames < FramesToStart || this->Paused > 0)
  {
    return false;
  }
  if (this->Holds(rectangle, nodes))
  {
    return true;
  }
  this->Grid = vtkOITTileGrid(rectangle, Size);
  this->Regions.clear();
  std::int64_t end = OIT_PAGE_SIZE; // node 0 is never used
  for (int row = this->Grid.FirstRow; row < this->Grid.FirstRow + this->Grid.Rows; ++row)
  {
    for (int i = 0; i < this->Grid.Columns; ++i)
    {
      const std::int64_t begin = end;
      end += this->FindSize(rectangle, this->Grid.FirstColumn + i, row, PartsMade);
      if (end > nodes)
      {
        this->Regions.clear();
        return false;
      }
      this->Regions.push_back(
        { static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end) });
    }
  }
  return true;
}
