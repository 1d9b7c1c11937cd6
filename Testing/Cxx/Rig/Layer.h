// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What tests say about fragments: one of them, the format that a method keeps it in, and by how
 * much the pixel may be off.
 */

#ifndef Layer_h
#define Layer_h

#include <glm/vec4.hpp>

namespace vtkOITTest
{
/// One fragment: window depth and colour (not premultiplied) as the fragment shader has them.
struct Layer
{
  float Depth = 0.5f;
  glm::vec4 Color{ 0.0f, 0.0f, 0.0f, 0.5f };
};

/// How a method keeps the colour and opacity of a fragment.
enum class Storage
{
  Float32,
  Half
};

/// Allowed differences of the colour channels and of alpha.
struct Tolerance
{
  double Color = 0.0;
  double Alpha = 0.0;
};

inline Tolerance operator+(const Tolerance& a, const Tolerance& b)
{
  return { a.Color + b.Color, a.Alpha + b.Alpha };
}
}

#endif
