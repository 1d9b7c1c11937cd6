// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITBands.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkOITBands::Begin(const vtkOITRectangle& rectangle, std::int64_t largestArea)
{
  this->Waiting.clear();
  if (rectangle == this->Whole && largestArea == this->LargestArea && !this->Accepted.empty())
  {
    this->Waiting.assign(this->Accepted.rbegin(), this->Accepted.rend());
  }
  else
  {
    const std::int64_t byArea = (rectangle.GetArea() + largestArea - 1) / largestArea;
    this->Push(
      rectangle, std::max<std::int64_t>({ 1, byArea, std::int64_t(this->Accepted.size()) }));
  }
  this->Whole = rectangle;
  this->LargestArea = largestArea;
  this->Accepted.clear();
}

//------------------------------------------------------------------------------
bool vtkOITBands::GetNext(vtkOITRectangle& band)
{
  if (this->Waiting.empty())
  {
    return false;
  }
  this->Current = band = this->Waiting.back();
  this->Waiting.pop_back();
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITBands::Split(std::int64_t parts)
{
  if (this->Current.GetArea() <= 1)
  {
    return false;
  }
  this->Push(this->Current, std::max<std::int64_t>(2, parts));
  return true;
}

//------------------------------------------------------------------------------
// Slices of whole rows, which rasterise best; columns once a single row is left.
void vtkOITBands::Push(const vtkOITRectangle& r, std::int64_t parts)
{
  const bool byRows = r.Height > 1;
  const int extent = byRows ? r.Height : r.Width;
  const int count = static_cast<int>(std::clamp<std::int64_t>(parts, 1, extent));
  for (int i = count - 1; i >= 0; --i)
  {
    const int from = static_cast<int>(static_cast<std::int64_t>(extent) * i / count);
    const int to = static_cast<int>(static_cast<std::int64_t>(extent) * (i + 1) / count);
    this->Waiting.push_back(byRows ? vtkOITRectangle{ r.X, r.Y + from, r.Width, to - from }
                                   : vtkOITRectangle{ r.X + from, r.Y, to - from, r.Height });
  }
}
