// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITPlanner.h"

#include "Private/Auto/vtkOITBlendPlan.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITSettings.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkProperty.h"

namespace
{
/// Nothing of it is seen wherever it is. Selected cells have an opacity of their own, and edges from
/// VTK 9.3 on.
bool HasNoOpacity(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && actor->GetProperty()->GetOpacity() <= 0.0 && vtkOITFindPlainActor(prop) &&
    !actor->GetProperty()->GetEdgeVisibility() && !vtkOITDrawsSelection(actor->GetMapper(), 0) &&
    (!actor->GetBackfaceProperty() || actor->GetBackfaceProperty()->GetOpacity() <= 0.0);
}

/// The frame without the props that leave no trace; extents are limited to the frame's rectangle.
vtkOITFrame DropInvisibleProps(const vtkOITFrame& frame)
{
  vtkOITFrame visible = frame;
  visible.Props.clear();
  visible.Extents.clear();
  for (std::size_t i = 0; i < frame.Props.size(); ++i)
  {
    vtkOITScreenExtent extent = frame.Extents[i];
    extent.Rectangle = extent.Rectangle.Intersect(frame.Rectangle);
    if (!extent.Rectangle.IsEmpty() && !HasNoOpacity(frame.Props[i]))
    {
      visible.Props.push_back(frame.Props[i]);
      visible.Extents.push_back(extent);
    }
  }
  visible.Rectangle = vtkOITFindScreenRectangle(visible.Extents).Intersect(frame.Rectangle);
  return visible;
}
}

//------------------------------------------------------------------------------
vtkOITPlan vtkOITPlanner::MakePlan(
  const vtkOITFrame& frame, const vtkOITSettings& settings, bool isKnown)
{
  vtkOITPlan plan;
  // Between volumes all is sorted, and pixels without props belong to the frame.
  const bool hasVolumes = frame.Volumes != nullptr;
  plan.Frame = settings.SkipInvisibleProps && !hasVolumes ? DropInvisibleProps(frame) : frame;
  const std::size_t dropped = frame.Props.size() - plan.Frame.Props.size();
  if (dropped > 0)
  {
    plan.Summary = std::to_string(dropped) + " of " + std::to_string(frame.Props.size()) +
      " props left out: invisible";
  }
  const vtkOITFrameSignature signature = isKnown && settings.ReuseFrames
    ? vtkOITFrameSignature(plan.Frame, settings.Time)
    : vtkOITFrameSignature();
  plan.IsStill = signature == this->Signature;
  if (!plan.Frame.Props.empty())
  {
    this->Signature = signature;
  }
  if (settings.SkipSorting && !hasVolumes)
  {
    plan.FindOrder = [this](const vtkOITFrame& group)
    { return vtkOITBlendPlan(group, this->Shapes).Order; };
  }
  return plan;
}
