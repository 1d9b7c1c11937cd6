// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Frame/vtkOITBands.h"

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
bool vtkOITBands::Split(std::int64_t needed, std::int64_t capacity)
{
  if (this->Current.GetArea() <= 1)
  {
    return false;
  }
  // By the rows that fit. Of 512 rows that need 64.5 times the capacity 7 do: 74 parts. 65 parts
  // would have 8 rows, a little too many, and each would be split once more, into 130.
  const std::int64_t extent = GetExtent(this->Current);
  const std::int64_t fitting = std::max<std::int64_t>(1, extent * capacity / needed);
  this->Push(this->Current, std::max<std::int64_t>(2, (extent + fitting - 1) / fitting));
  return true;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBands::DrawAll(const std::function<vtkOITFailure(const vtkOITRectangle&)>& draw,
  const std::function<void()>& free)
{
  vtkOITRectangle part;
  while (this->GetNext(part))
  {
    vtkOITFailure failure = draw(part);
    if (!failure)
    {
      this->Accept();
      continue;
    }
    free();
    if (!failure.IsOfMemory() || !this->Split(2, 1))
    {
      failure.Undrawn = this->GetUndrawn();
      return failure;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::vector<vtkOITRectangle> vtkOITBands::GetUndrawn() const
{
  std::vector<vtkOITRectangle> parts = this->Waiting;
  parts.push_back(this->Current);
  return parts;
}

//------------------------------------------------------------------------------
/// What is divided: rows, or the columns of a single row.
int vtkOITBands::GetExtent(const vtkOITRectangle& rectangle)
{
  return rectangle.Height > 1 ? rectangle.Height : rectangle.Width;
}

//------------------------------------------------------------------------------
// Slices of whole rows, which rasterise best; columns once a single row is left.
void vtkOITBands::Push(const vtkOITRectangle& r, std::int64_t parts)
{
  const bool byRows = r.Height > 1;
  const int extent = GetExtent(r);
  const int count = static_cast<int>(std::clamp<std::int64_t>(parts, 1, extent));
  for (int i = count - 1; i >= 0; --i)
  {
    const int from = static_cast<int>(static_cast<std::int64_t>(extent) * i / count);
    const int to = static_cast<int>(static_cast<std::int64_t>(extent) * (i + 1) / count);
    this->Waiting.push_back(byRows ? vtkOITRectangle{ r.X, r.Y + from, r.Width, to - from }
                                   : vtkOITRectangle{ r.X + from, r.Y, to - from, r.Height });
  }
}
