// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITCounterLayout_h
#define vtkOITCounterLayout_h

#include "Private/Frame/vtkOITCompatibility.h"

#include "glsl/Common/vtkOITConstants.h"

#include <cstdint>

/// The sizes of what vtkOITFragmentStore has in its buffers of counters.
namespace vtkOITCounterLayout
{
constexpr std::int64_t RoundUp(std::int64_t value, std::int64_t step)
{
  return (value + step - 1) / step * step;
}

/// Of the counters and the tiles, and the word where regions begin.
constexpr std::int64_t GetTileWords(int tiles)
{
  return RoundUp(OIT_COUNTER_WORDS + INT64_C(1) * OIT_TILE_WORDS * tiles, OIT_REGION_WORDS);
}

constexpr std::int64_t GetCounterWords(int tiles, int regions)
{
  return GetTileWords(tiles) + INT64_C(1) * OIT_REGION_WORDS * regions;
}

constexpr GLsizeiptr GetBytes(std::int64_t words)
{
  return static_cast<GLsizeiptr>(sizeof(std::uint32_t)) * static_cast<GLsizeiptr>(words);
}

constexpr GLsizeiptr GetExpectedBytes(int tiles)
{
  return static_cast<GLsizeiptr>(sizeof(std::uint32_t)) * tiles;
}
}

#endif
