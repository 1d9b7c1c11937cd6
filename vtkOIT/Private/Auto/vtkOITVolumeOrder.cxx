// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITVolumeOrder.h"

#include "Private/Auto/vtkOITPartialOrder.h"
#include "Private/Auto/vtkOITPropOrder.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITPropInput.h"
#include "Private/Volume/vtkOITVolumes.h"

#include "vtkProp.h"

#include <algorithm>
#include <iterator>

namespace
{
using Relation = vtkOITRelation;

vtkOITPlacedProp Place(vtkProp* prop, const vtkOITScreenExtent& extent)
{
  vtkOITPlacedProp placed;
  placed.Prop = prop;
  placed.Extent = &extent;
  if (extent.IsBounded)
  {
    vtkOITGetBounds(prop, placed.Bounds.data());
  }
  return placed;
}

Relation Compare(
  const vtkOITPlacedProp& first, const vtkOITPlacedProp& second, const vtkOITView& view)
{
  if (first.Extent->Rectangle.Intersect(second.Extent->Rectangle).IsEmpty())
  {
    return Relation::Apart;
  }
  return view.IsPlain && first.Extent->IsBounded && second.Extent->IsBounded
    ? first.Compare(second, view)
    : Relation::Unknown;
}

/// A volume, and whether all translucent props are behind or in front of it.
struct Volume
{
  vtkOITPlacedProp Place;
  bool IsInFront = true;
  bool IsBehind = true;

  void Note(Relation relation)
  {
    const bool isApart = relation == Relation::Apart;
    this->IsInFront = this->IsInFront && (isApart || relation == Relation::FirstInFront);
    this->IsBehind = this->IsBehind && (isApart || relation == Relation::SecondInFront);
  }
};

/// Takes the first volume that is in front of all others and of the props, or behind them.
vtkProp* TakeOutermost(std::vector<Volume>& volumes, const vtkOITView& view, bool isInFront)
{
  const auto isOutermost = [&](const Volume& volume)
  {
    Volume found = volume;
    for (const Volume& other : volumes)
    {
      if (other.Place.Prop != volume.Place.Prop)
      {
        found.Note(Compare(volume.Place, other.Place, view));
      }
    }
    return isInFront ? found.IsInFront : found.IsBehind;
  };
  const auto it = std::find_if(volumes.begin(), volumes.end(), isOutermost);
  vtkProp* prop = it == volumes.end() ? nullptr : it->Place.Prop;
  if (prop)
  {
    volumes.erase(it);
  }
  return prop;
}

/// Back to front; as they are, where that is not known of all pairs.
std::vector<vtkProp*> Sort(
  const std::vector<Volume>& volumes, const vtkOITView& view, bool& isKnown)
{
  vtkOITPartialOrder order(volumes.size());
  for (std::size_t a = 0; a < volumes.size(); ++a)
  {
    for (std::size_t b = a + 1; b < volumes.size(); ++b)
    {
      const Relation relation = Compare(volumes[a].Place, volumes[b].Place, view);
      isKnown = isKnown && relation != Relation::Unknown;
      if (relation == Relation::FirstInFront)
      {
        order.SetBefore(b, a);
      }
      else if (relation == Relation::SecondInFront)
      {
        order.SetBefore(a, b);
      }
    }
  }
  std::vector<vtkProp*> sorted;
  for (const vtkOITPartialOrder::Numbers& level : order.FindLevels())
  {
    for (const std::size_t i : level)
    {
      sorted.push_back(volumes[i].Place.Prop);
    }
  }
  if (sorted.size() < volumes.size())
  {
    isKnown = false;
    std::transform(volumes.begin(), volumes.end(), std::back_inserter(sorted),
      [](const Volume& volume) { return volume.Place.Prop; });
  }
  return sorted;
}
}

//------------------------------------------------------------------------------
vtkOITVolumeOrder::vtkOITVolumeOrder(const vtkOITFrame& frame, const std::vector<vtkProp*>& volumes)
{
  if (volumes.empty())
  {
    return;
  }
  const vtkOITView view(frame.Renderer);
  const std::vector<vtkOITScreenExtent> extents =
    vtkOITFindScreenExtents(frame.Renderer, volumes, frame.Viewport);
  std::vector<Volume> left;
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    Volume volume{ Place(volumes[i], extents[i]) };
    for (std::size_t p = 0; p < frame.Props.size(); ++p)
    {
      volume.Note(Compare(volume.Place, Place(frame.Props[p], frame.Extents[p]), view));
    }
    left.push_back(volume);
  }
  while (vtkProp* prop = TakeOutermost(left, view, false))
  {
    this->Before.push_back(prop);
  }
  while (vtkProp* prop = TakeOutermost(left, view, true))
  {
    this->After.insert(this->After.begin(), prop);
  }
  std::vector<Volume> between;
  for (const Volume& volume : left)
  {
    if (vtkOITIsHookedVolume(volume.Place.Prop))
    {
      this->Rectangle = this->Rectangle.Unite(volume.Place.Extent->Rectangle);
      between.push_back(volume);
    }
    else
    {
      this->After.push_back(volume.Place.Prop);
      this->HasUnhooked = true;
    }
  }
  bool isKnown = true;
  this->Between = Sort(between, view, isKnown);
  this->HasUnknownOrder = !isKnown;
}

//------------------------------------------------------------------------------
std::string vtkOITVolumeOrder::FindDoubt(bool isDrawn) const
{
  if (!isDrawn)
  {
    return this->Before.empty() && this->Between.empty() && !this->HasUnhooked
      ? ""
      : "A volume is drawn over the translucent props that it overlaps; call "
        "UseDepthPeelingForVolumesOn() of the renderer, or in a chain of passes "
        "SetVolumetricPass() of this one";
  }
  if (this->HasUnhooked)
  {
    return "A volume whose mapper has no shader for rays is drawn over the translucent props that "
           "it overlaps; use a mapper for GPUs, e.g. vtkGPUVolumeRayCastMapper";
  }
  return this->HasUnknownOrder ? "Volumes overlap each other, so their order is not known; use a "
                                 "vtkMultiVolume"
                               : "";
}
