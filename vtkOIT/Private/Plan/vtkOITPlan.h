// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPlan_h
#define vtkOITPlan_h

#include "Private/Blending/vtkOITBlendSteps.h"
#include "Private/Frame/vtkOITFrame.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

class vtkProp;

/// Job blend: props whose order is known. Job sort, over them: others, and where they are.
struct vtkOITBatch
{
  vtkOITBlendSteps Blend;
  vtkOITFrame Sort;
};

/// Batches back to front; all props are in one of them.
struct vtkOITOrder
{
  std::vector<vtkOITBatch> Batches;

  bool HasSorted() const
  {
    return std::any_of(this->Batches.begin(), this->Batches.end(),
      [](const vtkOITBatch& batch) { return !batch.Sort.Props.empty(); });
  }
  int CountBlended() const
  {
    return std::accumulate(this->Batches.begin(), this->Batches.end(), 0,
      [](int count, const vtkOITBatch& batch) { return count + batch.Blend.NumberOfProps; });
  }
  /// Whether pixels are blended to several times, so that each would be rounded.
  bool NeedsLayer() const
  {
    return this->Batches.size() > 1 || this->Batches.front().Blend.MaximumLayers > 1;
  }
};

/// How a frame is drawn: its jobs, made without touching OpenGL. vtkOITPlanRunner carries them out.
struct vtkOITPlan
{
  /// The frame without the props that leave no trace.
  vtkOITFrame Frame;

  /// Job reuse: nothing has changed since the last plan, as far as that can be told without OpenGL.
  /// The layer of the last frame is composited again, if it was kept and the opaque depth is as it
  /// was; otherwise it is kept from this frame on.
  bool IsStill = false;

  /// Props that cannot be sorted, and are blended as VTK draws them. They divide the frame into groups
  /// (vtkOITFindGroups()), each with jobs of its own, drawn one over the other.
  std::vector<vtkProp*> Unsorted;

  /// The jobs blend and sort of a group, found only for one that is drawn. Default: all is sorted.
  std::function<vtkOITOrder(const vtkOITFrame& group)> FindOrder;

  /// What the plan does without, and why; empty for nothing.
  std::string Summary;
};

#endif
