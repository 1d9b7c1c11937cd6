// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPeelRegion_h
#define vtkOITPeelRegion_h

#include "Private/Frame/vtkOITRectangle.h"
#include "Private/GL/vtkOITOcclusionQueries.h"

#include <cstdint>
#include <functional>
#include <vector>

struct vtkOITFrame;

/**
 * Where pixels are left to peel, and how many: occlusion queries count them in cells of the band,
 * and the scissor of the next peels is what encloses the cells that have some.
 *
 * Rasterization is the larger part of a geometry pass on a CPU, and late peels concern few pixels.
 */
class vtkOITPeelRegion
{
public:
  /// Starts a band: all of it. Without `counts` nothing is asked, and the region stays.
  void Begin(const vtkOITFrame& frame, const vtkOITRectangle& band, bool counts);

  const vtkOITRectangle& GetRegion() const { return this->Region; }
  /// Sets the scissor to the region.
  void SetScissor() const;

  /// Counts what `draw` draws after this peel: it is called once for each cell of the region, with
  /// the scissor set to it.
  void Count(std::size_t peel, const std::function<void()>& draw);

  /// Whether the counts after a peel can be had without waiting.
  bool IsAvailable(std::size_t peel) const;
  /// Pixels left after a peel; waits for it.
  std::int64_t GetRemaining(std::size_t peel) const;
  /// Limits the region to the cells that have pixels after a peel; waits for it.
  void ShrinkTo(std::size_t peel);

  /// Whether a count is missing that was asked for.
  bool HasFailed() const { return this->Queries.HasFailed(); }

  void Release() { this->Queries.Release(); }

private:
  struct Cell
  {
    vtkOITRectangle Rectangle;
    std::size_t Query = 0;
  };

  vtkOITOcclusionQueries Queries;
  const vtkOITFrame* Frame = nullptr;
  bool Counts = false;
  int CellSize = 1; // pixels a side
  vtkOITRectangle Band;
  vtkOITRectangle Region;
  std::vector<std::vector<Cell>> Peels; // the cells counted after each peel
  std::size_t NextQuery = 0;
};

#endif
