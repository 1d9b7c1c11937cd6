// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPlanRunner_h
#define vtkOITPlanRunner_h

#include "Private/Blending/vtkOITBlendingEngine.h"
#include "Private/Blending/vtkOITLayerTarget.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "Private/Plan/vtkOITDepthCheck.h"
#include "Private/Plan/vtkOITSorters.h"

struct vtkOITGroup;
struct vtkOITOrder;
struct vtkOITPlan;

/**
 * Carries out the jobs of a plan, group by group, and blends the props that cannot be sorted between
 * them. The jobs of a group:
 *
 * 1. Reuse: the layer of the last frame over the framebuffer, where that is all.
 * 2. Choose what the others draw into: the framebuffer; a float32 layer, when it is to be kept, and
 *    when blending several layers in 8 bits would round each; or the framebuffer with the layer
 *    beside it, where few layers are blended and shaders can read both. The layer gives the same
 *    picture to the last bit in float framebuffers, so it is taken there, too.
 * 3. Blend, then sort, into it, batch by batch.
 * 4. The layer over the framebuffer, once.
 *
 * The memory of all together stays within the limit of the settings.
 */
class vtkOITPlanRunner
{
public:
  /// `own`: the engine of a pass's method, for what is sorted; nullptr for the best one.
  explicit vtkOITPlanRunner(vtkOITEngine* own)
    : Sorters(own)
  {
  }

  void Run(const vtkOITPlan& plan, const vtkOITSettings& settings, vtkOITGeometry& geometry,
    vtkOITSavedState& saved, vtkOITStatistics& statistics);

  vtkOITSorters& GetSorters() { return this->Sorters; }
  std::int64_t GetSizeInBytes() const;
  void Release();

private:
  /// A group that is being drawn.
  struct Task
  {
    const vtkOITFrame& Frame;
    const vtkOITOrder& Order;
    const vtkOITSettings& Settings;
    vtkOITGeometry& Geometry;
    vtkOITSavedState& Saved;
    vtkOITStatistics& Statistics;
  };
  enum class Into
  {
    Framebuffer,
    Beside,
    Layer
  };

  void Draw(const Task& task, bool keepsLayer);
  static bool DrawUnsorted(
    const vtkOITGroup& group, vtkOITGeometry& geometry, const vtkOITSavedState& saved);
  bool Reuse(const vtkOITFrame& frame, vtkOITStatistics& statistics);
  Into ChooseTarget(const Task& task, bool& keepsLayer, vtkOITTarget& target);
  bool MakeRoom(std::int64_t needed, std::int64_t forSorting, std::int64_t limit);
  bool DrawBatches(const Task& task, const vtkOITTarget& target, Into into);
  vtkOITFailure Blend(const Task& task, const vtkOITBlendSteps& blend, const vtkOITTarget& target,
    Into into, bool& isBlended);
  void Sort(const Task& task, const vtkOITFrame& frame);
  bool CompositeLayer(const Task& task, bool keepsLayer);

  vtkOITSorters Sorters;
  vtkOITBlendingEngine Blending;
  vtkOITLayerTarget Layer;
  vtkOITDepthCheck DepthCheck;
  bool HasLayer = false;            // of the last frame, kept
  vtkOITStatistics LayerStatistics; // of that frame
  std::int64_t SortedFragments = 0; // of the last frame
};

#endif
