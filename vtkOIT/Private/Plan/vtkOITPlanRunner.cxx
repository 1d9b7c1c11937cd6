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
      const vtkOITOrder order =
        plan.FindOrder ? plan.FindOrder(group.Frame) : vtkOITOrder{ {}, group.Frame };
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
  Into into = this->ChooseTarget(task, keepsLayer, target);
  bool isBlended = false;
  if (this->Blend(task, target, into, isBlended) && into == Into::Layer)
  {
    into = Into::Framebuffer; // the layer is dropped, with what is in it
    isBlended = false;
  }
  const vtkOITFrame& sorted = isBlended ? task.Order.Sort : task.Frame;
  this->Sort(task, into == Into::Layer ? sorted.On(target) : sorted);
  if (isBlended)
  {
    task.Statistics.NumberOfFragments = -1;
    task.Statistics.MaximumDepthComplexity = -1;
  }
  if (into == Into::Layer && !this->CompositeLayer(task, keepsLayer))
  {
    this->Sort(task, task.Frame);
  }
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
  const vtkOITBlendSteps& blend = task.Order.Blend;
  const bool needsLayer = blend.MaximumLayers > 1;
  const std::int64_t limit = task.Settings.BufferLimit;
  if (limit == 0)
  {
    return Into::Framebuffer; // a plan with layers comes with a limit
  }
  const std::int64_t forSorting =
    task.Order.Sort.Props.empty() ? 0 : std::max(limit / 2, SmallestLimit);
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
  if (!keepsLayer && needsLayer && vtkOITWritesByFetch(frame) &&
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
// Not blended, with nothing to blend or nothing to blend it into, or when that fails before anything
// is drawn: then all props are sorted. What has failed later is a fault of the picture, unless it is
// only in the layer.
vtkOITFailure vtkOITPlanRunner::Blend(
  const Task& task, const vtkOITTarget& target, Into into, bool& isBlended)
{
  const vtkOITBlendSteps& blend = task.Order.Blend;
  isBlended = false;
  if (blend.NumberOfProps == 0 || (blend.MaximumLayers > 1 && into == Into::Framebuffer))
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
  task.Statistics.AddToSummary(std::to_string(blend.NumberOfProps) + " of " +
    std::to_string(task.Frame.Props.size()) + " props blended: their order is known");
  task.Statistics.Algorithm = this->Blending.GetAlgorithmName(task.Settings);
  task.Statistics.Reason = "the order of all props is known";
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
  task.Statistics.NumberOfFragments = 0;
  task.Statistics.MaximumDepthComplexity = 0;
  this->Sorters.Draw(frame, settings, task.Geometry, task.Saved, task.Statistics);
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
