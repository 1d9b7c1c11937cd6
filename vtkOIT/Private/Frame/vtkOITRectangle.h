// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITRectangle_h
#define vtkOITRectangle_h

#include <algorithm>
#include <cstdint>

/// A rectangle of framebuffer pixels, lower left corner first, as glScissor takes it.
struct vtkOITRectangle
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;

  bool IsEmpty() const { return this->Width <= 0 || this->Height <= 0; }

  std::int64_t GetArea() const
  {
    return this->IsEmpty() ? 0 : static_cast<std::int64_t>(this->Width) * this->Height;
  }

  bool operator==(const vtkOITRectangle& other) const
  {
    return this->X == other.X && this->Y == other.Y && this->Width == other.Width &&
      this->Height == other.Height;
  }

  vtkOITRectangle Intersect(const vtkOITRectangle& other) const
  {
    const int x0 = std::max(this->X, other.X);
    const int y0 = std::max(this->Y, other.Y);
    const int x1 = std::min(this->X + this->Width, other.X + other.Width);
    const int y1 = std::min(this->Y + this->Height, other.Y + other.Height);
    return { x0, y0, std::max(0, x1 - x0), std::max(0, y1 - y0) };
  }

  /// The smallest rectangle that has both.
  vtkOITRectangle Unite(const vtkOITRectangle& other) const
  {
    if (this->IsEmpty() || other.IsEmpty())
    {
      return this->IsEmpty() ? other : *this;
    }
    const int x0 = std::min(this->X, other.X);
    const int y0 = std::min(this->Y, other.Y);
    const int x1 = std::max(this->X + this->Width, other.X + other.Width);
    const int y1 = std::max(this->Y + this->Height, other.Y + other.Height);
    return { x0, y0, x1 - x0, y1 - y0 };
  }
};

#endif
