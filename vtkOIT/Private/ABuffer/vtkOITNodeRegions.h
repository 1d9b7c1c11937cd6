// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITNodeRegions_h
#define vtkOITNodeRegions_h

#include "Private/ABuffer/vtkOITTileGrid.h"

#include "glsl/Common/vtkOITConstants.h"

#include <cstdint>
#include <vector>

/**
 * Parts of the pool of an A-buffer, one for each region of OIT_REGION_SIZE pixels a side, so that no two
 * threads take nodes from one counter: llvmpipe draws such a region by one thread. Their sizes are what the
 * last frame had there and around, and more. A frame that exceeds one is drawn again without regions, and some
 * frames after it have none. Knows nothing of OpenGL.
 */
class vtkOITNodeRegions
{
public:
  /// Nodes [Begin, End), whole pages.
  struct Region
  {
    std::uint32_t Begin;
    std::uint32_t End;
  };

  /// The fragments that a frame had in each tile of a grid.
  void Update(const vtkOITTileGrid& tiles, const std::vector<std::uint32_t>& fragments);

  /// Whether the next frame of this rectangle has regions, in a pool of so many nodes: from its third frame
  /// on, as memory that moves is touched anew, and where there is room. The last ones are kept while they are
  /// large enough.
  bool Plan(const vtkOITRectangle& rectangle, std::int64_t nodes);

  /// What Plan() needs for it, in nodes; 0 while frames are too few to ask for more memory.
  std::int64_t FindNodes(const vtkOITRectangle& rectangle) const;

  /// A frame has exceeded a region.
  void NoteExceeded();
  void Clear() { *this = vtkOITNodeRegions(); }

  /// Of the last Plan(), row by row.
  ///@{
  const vtkOITTileGrid& GetGrid() const { return this->Grid; }
  const std::vector<Region>& GetRegions() const { return this->Regions; }
  ///@}

private:
  std::int64_t GetFragments(int column, int row) const;
  std::int64_t FindSize(const vtkOITRectangle& rectangle, int column, int row, int parts) const;
  bool Holds(const vtkOITRectangle& rectangle, std::int64_t nodes) const;

  // Of the last frame, of the whole framebuffer as far as it is known.
  int Columns = 0;
  int Rows = 0;
  std::vector<std::int64_t> Fragments;
  int Frames = 0; // that were noted
  int Paused = 0; // frames that still have no regions
  int Pause = 0;  // of the last one
  vtkOITTileGrid Grid;
  std::vector<Region> Regions;
};

#endif
