// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITPeelRegion.h"

#include "Private/Frame/vtkOITFrame.h"

#include "vtkOpenGLState.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr int CellsPerSide = 10;
constexpr int SmallestCell = 32; // pixels a side
}

//------------------------------------------------------------------------------
void vtkOITPeelRegion::Begin(const vtkOITFrame& frame, const vtkOITRectangle& band, bool counts)
{
  this->Frame = &frame;
  this->Counts = counts;
  this->Band = band;
  this->Region = band;
  const int longest = std::max(band.Width, band.Height);
  this->CellSize = std::max((longest + CellsPerSide - 1) / CellsPerSide, SmallestCell);
  this->Peels.clear();
  this->NextQuery = 0;
  if (counts)
  {
    this->Queries.StartRow(frame.Window);
  }
}

//------------------------------------------------------------------------------
void vtkOITPeelRegion::SetScissor() const
{
  const vtkOITRectangle& r = this->Region;
  this->Frame->GLState->vtkglScissor(r.X, r.Y, r.Width, r.Height);
}

//------------------------------------------------------------------------------
void vtkOITPeelRegion::Count(std::size_t peel, const std::function<void()>& draw)
{
  if (!this->Counts)
  {
    draw();
    return;
  }
  this->Peels.resize(peel + 1);
  // Regions consist of whole cells of the band.
  for (int y = this->Region.Y; y < this->Region.Y + this->Region.Height; y += this->CellSize)
  {
    for (int x = this->Region.X; x < this->Region.X + this->Region.Width; x += this->CellSize)
    {
      const vtkOITRectangle rectangle =
        this->Band.Intersect({ x, y, this->CellSize, this->CellSize });
      this->Peels[peel].push_back({ rectangle, this->NextQuery++ });
      this->Frame->GLState->vtkglScissor(
        rectangle.X, rectangle.Y, rectangle.Width, rectangle.Height);
      this->Queries.Begin(this->Peels[peel].back().Query);
      draw();
      this->Queries.End();
    }
  }
}

//------------------------------------------------------------------------------
bool vtkOITPeelRegion::IsAvailable(std::size_t peel) const
{
  const std::vector<Cell>& cells = this->Peels[peel];
  return std::all_of(cells.rbegin(), cells.rend(),
    [this](const Cell& cell) { return this->Queries.IsAvailable(cell.Query); });
}

//------------------------------------------------------------------------------
std::int64_t vtkOITPeelRegion::GetRemaining(std::size_t peel) const
{
  std::int64_t remaining = 0;
  for (const Cell& cell : this->Peels[peel])
  {
    const std::int64_t samples = this->Queries.GetResult(cell.Query);
    if (samples < 0)
    {
      return std::numeric_limits<std::int64_t>::max(); // not counted: all
    }
    remaining += samples;
  }
  return remaining;
}

//------------------------------------------------------------------------------
void vtkOITPeelRegion::ShrinkTo(std::size_t peel)
{
  vtkOITRectangle region;
  for (const Cell& cell : this->Peels[peel])
  {
    if (this->Queries.GetResult(cell.Query) != 0)
    {
      region = region.Unite(cell.Rectangle);
    }
  }
  this->Region = region;
}
