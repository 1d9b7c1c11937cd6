// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDepthComplexityMap_h
#define vtkOITDepthComplexityMap_h

#include "Private/ABuffer/vtkOITFragmentStore.h"

#include <cstdint>
#include <vector>

/// The depth complexity of a framebuffer's tiles in the last frame, from which the next one knows
/// what to expect. A wrong expectation costs time, never correctness.
class vtkOITDepthComplexityMap
{
public:
  bool IsEmpty() const { return this->Columns == 0; }

  void Clear();

  /// Stores what was found in the tiles of a grid.
  void Update(const vtkOITTileGrid& grid, const std::vector<std::uint32_t>& tiles);

  /// What to expect of the tiles of a grid; 0 where nothing is known.
  std::vector<std::uint32_t> GetExpected(const vtkOITTileGrid& grid) const;

private:
  int Columns = 0;
  int Rows = 0;
  std::vector<std::uint32_t> Tiles; // all tiles of the framebuffer, from its lower left corner
};

#endif
