// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Plan/vtkOITPlanRunner.h"

#include "Private/Engine/vtkOITGeometry.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/GL/vtkOITOutput.h"
#include "Private/GL/vtkOITSavedState.h"
#include "Private/Plan/vtkOITGroups.h"
#include "Private/Plan/vtkOITPlan.h"

#include "vtkProp.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace
{
constexpr std::int64_t SmallestLimit = INT64_C(1) << 20; // that engines take
constexpr std::int64_t BytesPerFragment = 16;            // of an A-buffer

/// Each layer that is blended with another buffer beside costs more than into the float32 layer
/// alone; with more layers than this, more than the stage that composites it.
constexpr int MostLayersBeside = 3;
}

//------------------------------------------------------------------------------
void vtkOITPlanRunner::Run(const vtkOITPlan& plan, const vtkOITSettings& settings,
  vtkOITGeometry& geometry, vtkOITSavedState& saved, vtkOITStatistics& statistics)
{
  statistics.Summary = plan.Summary;
  const std::vector<vtkOITGroup> groups = vtkOITFindGroups(plan.Frame, plan.Unsorted);
  // A layer is kept of a whole frame only.
  const bool isStill = plan.IsStill &&
    std::count_if(groups.begin(), groups.end(),
      [](const vtkOITGroup& group) { return !group.Frame.Props.empty(); }) == 1;
  vtkProp* unsorted = nullptr;
  for (const vtkOITGroup& group : groups)
  {
    vtkOITStatistics ofGroup;
    if (!group.Frame.Props.empty() && !group.Frame.Rectangle.IsEmpty() &&
      !(isStill && this->Reuse(group.Frame, ofGroup)))
    {
      vtkOITOrder order;
      if (plan.FindOrder)
      {
        order = plan.FindOrder(group.Frame);
      }
      else
      {
        order.Batches.push_back({ {}, group.Frame });
      }
      this->Draw({ group.Frame, order, settings, geometry, saved, ofGroup }, isStill);
    }
    statistics.Add(ofGroup);
    if (DrawUnsorted(group, geometry, saved) && !unsorted)
    {
      unsorted = group.Unsorted.front();
    }
  }
  if (unsorted)
  {
    statistics.NoteUnsorted(unsorted->GetClassName());
  }
}

//------------------------------------------------------------------------------
bool vtkOITPlanRunner::DrawUnsorted(
  const vtkOITGroup& group, vtkOITGeometry& geometry, const vtkOITSavedState& saved)
{
  if (group.Unsorted.empty())
  {
    return false;
  }
  saved.SetAgain();
  const bool hasDrawn = geometry.DrawUnsorted(group.Unsorted);
  saved.SetNeutral();
  return hasDrawn;
}

//------------------------------------------------------------------------------
void vtkOITPlanRunner::Draw(const Task& task, bool keepsLayer)
{
  this->HasLayer = false;
  vtkOITTarget target = task.Frame.Target;
  const Into into = this->ChooseTarget(task, keepsLayer, target);
  const bool isWhole = this->DrawBatches(task, target, into) &&
    (into != Into::Layer || this->CompositeLayer(task, keepsLayer));
  if (!isWhole)
  {
    this->Sort(task, task.Frame); // the layer is dropped, with what is in it
  }
}

//------------------------------------------------------------------------------
// False, and nothing is drawn but into the layer, when all is to be sorted.
bool vtkOITPlanRunner::DrawBatches(const Task& task, const vtkOITTarget& target, Into into)
{
  const vtkOITOrder& order = task.Order;
  const int blended = order.CountBlended();
  if (blended > 0 && order.NeedsLayer() && into == Into::Framebuffer)
  {
    return false;
  }
  for (const vtkOITBatch& batch : order.Batches)
  {
    bool isBlended = false;
    const vtkOITFailure failure = this->Blend(task, batch.Blend, target, into, isBlended);
    if ((failure && into == Into::Layer) || (!isBlended && batch.Blend.NumberOfProps > 0))
    {
      return false;
    }
    this->Sort(task, into == Into::Layer ? batch.Sort.On(target) : batch.Sort);
  }
  if (blended > 0)
  {
    vtkOITStatistics& statistics = task.Statistics;
    statistics.AddToSummary(std::to_string(blended) + " of " +
      std::to_string(task.Frame.Props.size()) + " props blended: their order is known");
    if (!order.HasSorted())
    {
      statistics.Algorithm = this->Blending.GetAlgorithmName(task.Settings);
      statistics.Reason = "the order of all props is known";
    }
    statistics.NumberOfFragments = -1;
    statistics.MaximumDepthComplexity = -1;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITPlanRunner::Reuse(const vtkOITFrame& frame, vtkOITStatistics& statistics)
{
  if (!this->HasLayer || !this->DepthCheck.IsUnchanged(frame) || this->Layer.Composite(frame))
  {
    return false;
  }
  statistics = this->LayerStatistics;
  statistics.NumberOfGeometryPasses = 0;
  statistics.Summary = "whole frame reused";
  statistics.Reason = "nothing has changed since the last frame";
  return true;
}

//------------------------------------------------------------------------------
// Releases what is left over from other frames until `needed` bytes more than what stays for
// sorting, `forSorting`, are free. False when that cannot be.
bool vtkOITPlanRunner::MakeRoom(std::int64_t needed, std::int64_t forSorting, std::int64_t limit)
{
  if (this->Layer.GetSizeInBytes() + this->DepthCheck.GetSizeInBytes() > limit - forSorting)
  {
    this->Layer.Release();
    this->DepthCheck.Release();
  }
  const bool isFree = needed <= limit - forSorting;
  if (isFree && forSorting == 0 && needed + this->Sorters.GetSizeInBytes() > limit)
  {
    this->Sorters.Release();
  }
  return isFree;
}

//------------------------------------------------------------------------------
vtkOITPlanRunner::Into vtkOITPlanRunner::ChooseTarget(
  const Task& task, bool& keepsLayer, vtkOITTarget& target)
{
  const vtkOITFrame& frame = task.Frame;
  const vtkOITOrder& order = task.Order;
  const bool needsLayer = order.NeedsLayer();
  const std::int64_t limit = task.Settings.BufferLimit;
  if (limit == 0)
  {
    return Into::Framebuffer; // a plan with layers comes with a limit
  }
  const std::int64_t forSorting = order.HasSorted() ? std::max(limit / 2, SmallestLimit) : 0;
  const std::int64_t forLayer = vtkOITLayerTarget::GetBytes(frame, frame.Rectangle);
  const std::int64_t forDepth = vtkOITDepthCheck::GetBytes(frame);
  keepsLayer = keepsLayer && forLayer + forDepth <= limit - forSorting;
  const std::int64_t needed =
    (needsLayer || keepsLayer ? forLayer : 0) + (keepsLayer ? forDepth : 0);
  const bool canHave = this->MakeRoom(needed, forSorting, limit) && needed > 0 &&
    frame.Target.Samples == 0 && frame.Target.DepthBits > 0;
  if (!canHave)
  {
    if (needsLayer)
    {
      this->MakeRoom(0, SmallestLimit, limit);
    }
    return Into::Framebuffer;
  }
  if (keepsLayer && this->DepthCheck.Keep(frame))
  {
    keepsLayer = false;
  }
  const vtkOITBlendSteps& blend = order.Batches.front().Blend;
  if (!keepsLayer && needsLayer && order.Batches.size() == 1 && vtkOITWritesByFetch(frame) &&
    blend.MaximumLayers <= MostLayersBeside &&
    !this->Layer.BeginBeside(frame, blend.Rectangle.Intersect(frame.Rectangle), target))
  {
    return Into::Beside;
  }
  if (this->Layer.Begin(frame, frame.Rectangle, target))
  {
    target = frame.Target;
    return Into::Framebuffer;
  }
  return Into::Layer;
}

//------------------------------------------------------------------------------
// Not blended, with nothing to blend, or when that fails before anything is drawn. What has failed
// later is a fault of the picture, unless it is only in the layer.
vtkOITFailure vtkOITPlanRunner::Blend(const Task& task, const vtkOITBlendSteps& blend,
  const vtkOITTarget& target, Into into, bool& isBlended)
{
  isBlended = false;
  if (blend.Steps.empty())
  {
    return {};
  }
  this->Blending.SetSteps(&blend);
  this->Blending.SetLayerBeside(into == Into::Beside ? &this->Layer : nullptr);
  vtkOITFailure failure =
    this->Blending.Draw(task.Frame.On(target), task.Settings, task.Geometry, task.Statistics);
  if (failure && (into == Into::Layer || !failure.Undrawn.empty()))
  {
    return failure;
  }
  isBlended = true;
  if (failure)
  {
    task.Statistics.NoteFault("Some props are left out: " + failure.GetReason());
  }
  return failure;
}

//------------------------------------------------------------------------------
void vtkOITPlanRunner::Sort(const Task& task, const vtkOITFrame& frame)
{
  if (frame.Props.empty() || frame.Rectangle.IsEmpty())
  {
    return;
  }
  vtkOITSettings settings = task.Settings;
  if (settings.BufferLimit > 0)
  {
    settings.BufferLimit = std::max(SmallestLimit,
      settings.BufferLimit - this->Layer.GetSizeInBytes() - this->DepthCheck.GetSizeInBytes());
  }
  const bool fits = this->SortedFragments * BytesPerFragment <= settings.BufferLimit;
  // Whether that pays is found out from frame to frame, of the same props.
  settings.SkipHiddenFragments = settings.SkipHiddenFragments && task.Order.Batches.size() == 1;
  task.Statistics.NumberOfFragments = 0;
  task.Statistics.MaximumDepthComplexity = 0;
  const double before = std::exchange(task.Statistics.ErrorBound, 0.0);
  this->Sorters.Draw(frame, settings, task.Geometry, task.Saved, task.Statistics);
  task.Statistics.AddError(before);
  this->SortedFragments = std::max<std::int64_t>(0, task.Statistics.NumberOfFragments);
  if (task.Statistics.Reason.empty())
  {
    task.Statistics.Reason =
      fits ? "its fragments fit into memory" : "in bands, as its fragments do not fit into memory";
  }
  if (task.Statistics.SkippedHiddenFragments)
  {
    task.Statistics.AddToSummary("fragments behind those of opacity 1 left out");
  }
}

//------------------------------------------------------------------------------
bool vtkOITPlanRunner::CompositeLayer(const Task& task, bool keepsLayer)
{
  if (this->Layer.Composite(task.Frame))
  {
    return false;
  }
  // The next frame tries again what has failed in this one.
  this->HasLayer = keepsLayer && task.Statistics.Fault.empty() && task.Statistics.Warning.empty();
  this->LayerStatistics = task.Statistics;
  return true;
}

//------------------------------------------------------------------------------
std::int64_t vtkOITPlanRunner::GetSizeInBytes() const
{
  return this->Layer.GetSizeInBytes() + this->DepthCheck.GetSizeInBytes() +
    this->Sorters.GetSizeInBytes();
}

//------------------------------------------------------------------------------
void vtkOITPlanRunner::Release()
{
  this->Layer.Release();
  this->DepthCheck.Release();
  this->Sorters.Release();
  this->HasLayer = false;
}
