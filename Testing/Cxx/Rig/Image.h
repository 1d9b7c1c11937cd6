// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A picture read back from a test's render target, as float RGBA.
 */

#ifndef Image_h
#define Image_h

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace vtkOITTest
{
struct Image
{
  int Width = 0;
  int Height = 0;
  std::vector<glm::vec4> Pixels; // rows from the bottom up, as OpenGL has them

  const glm::vec4& At(int x, int y) const
  {
    return this->Pixels[static_cast<std::size_t>(y) * this->Width + x];
  }
};

/// The part of the image that starts at (x, y).
inline Image Crop(const Image& image, int x, int y, int width, int height)
{
  Image part{ width, height, {} };
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      part.Pixels.push_back(image.At(x + column, y + row));
    }
  }
  return part;
}
}

#endif
