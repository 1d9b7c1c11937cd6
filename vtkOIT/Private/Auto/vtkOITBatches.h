// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBatches_h
#define vtkOITBatches_h

#include "Private/Auto/vtkOITPropOrder.h"
#include "Private/Blending/vtkOITBlendSteps.h"

#include <functional>
#include <vector>

/// What is drawn of a prop in one step of blending.
struct vtkOITPart
{
  const vtkOITPlacedProp* Whole = nullptr;
  vtkOITBlendSteps::Faces Side = vtkOITBlendSteps::Faces::All;
};
using vtkOITParts = std::vector<vtkOITPart>;

/// Parts whose order is known, and over them props that have to be sorted.
struct vtkOITPartBatch
{
  std::vector<vtkOITParts> Levels; // far to near
  std::vector<const vtkOITPlacedProp*> Sorted;
};

/**
 * Props as batches, far to near, as few as there can be.
 *
 * Any two props without a known order are sorted together, and so are those that one of them has no
 * order with. Such a cluster is one thing, which is behind others and in front of others. A part that
 * is blended over it waits for the next batch; clusters of one batch are sorted in one go. (Batches
 * by depth: Wexler and others, GPU-Accelerated High-Quality Hidden Surface Removal, 2005.)
 *
 * `needsSorting`: of a prop whose own layers are in no known order. One batch without sorted props
 * where all is known; no batch when there is no order, because some are in front of each other in
 * turn.
 */
std::vector<vtkOITPartBatch> vtkOITFindBatches(const std::vector<vtkOITPlacedProp*>& props,
  const vtkOITView& view, const std::function<bool(const vtkOITPlacedProp&)>& needsSorting);

/// Whether batches cost less than sorting all of the props, on `frameArea` pixels.
bool vtkOITBatchesPay(const std::vector<vtkOITPartBatch>& batches, double frameArea);

#endif
