// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Plan/vtkOITGroups.h"

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITPropInput.h"

#include "vtkBoundingBox.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
constexpr double InFrontOfAll = std::numeric_limits<double>::lowest();
constexpr double BehindAll = std::numeric_limits<double>::max();

/// Window depth of the centre of a prop's bounds, up to scale and shift; this other value without
/// bounds. A centre behind the camera is in front of all that is seen.
double FindDepth(vtkProp* prop, const glm::dmat4& projection, double withoutBounds)
{
  auto* prop3D = vtkProp3D::SafeDownCast(prop);
  double bounds[6];
  if ((prop3D && !vtkOITIsInWorldCoordinates(prop3D)) || !vtkOITGetBounds(prop, bounds) ||
    !vtkBoundingBox::IsValid(bounds))
  {
    return withoutBounds;
  }
  const glm::dvec4 clip = projection *
    glm::dvec4(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
      0.5 * (bounds[4] + bounds[5]), 1.0);
  const double depth = clip.w > 0.0 ? clip.z / clip.w : InFrontOfAll;
  return std::isfinite(depth) ? depth : withoutBounds;
}

struct PlacedProp
{
  vtkProp* Prop;
  double Depth;
};
}

//------------------------------------------------------------------------------
std::vector<vtkOITGroup> vtkOITFindGroups(
  const vtkOITFrame& frame, const std::vector<vtkProp*>& unsorted)
{
  if (unsorted.empty() || frame.Volumes)
  {
    std::vector<vtkOITGroup> whole(1);
    whole.front().Frame = frame;
    whole.front().Unsorted = unsorted;
    return whole;
  }
  const glm::dmat4 projection = vtkOITFindProjection(frame.Renderer);
  std::vector<PlacedProp> placed;
  placed.reserve(unsorted.size());
  for (vtkProp* prop : unsorted)
  {
    placed.push_back({ prop, FindDepth(prop, projection, InFrontOfAll) });
  }
  std::stable_sort(placed.begin(), placed.end(),
    [](const PlacedProp& first, const PlacedProp& second) { return first.Depth > second.Depth; });

  // Group i has the sorted props that are in front of the first i of the placed ones.
  std::vector<vtkOITGroup> groups(placed.size() + 1);
  for (vtkOITGroup& group : groups)
  {
    group.Frame = frame;
    group.Frame.Props.clear();
    group.Frame.Extents.clear();
  }
  for (std::size_t i = 0; i < frame.Props.size(); ++i)
  {
    const double depth = FindDepth(frame.Props[i], projection, BehindAll);
    const auto behind = std::count_if(
      placed.begin(), placed.end(), [depth](const PlacedProp& prop) { return prop.Depth > depth; });
    vtkOITFrame& part = groups[behind].Frame;
    part.Props.push_back(frame.Props[i]);
    part.Extents.push_back(frame.Extents[i]);
  }
  std::vector<vtkOITGroup> found;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    vtkOITFrame& part = groups[i].Frame;
    part.Rectangle = vtkOITFindScreenRectangle(part.Extents).Intersect(frame.Rectangle);
    if (found.empty() || !part.Props.empty())
    {
      found.push_back(std::move(groups[i]));
    }
    if (i < placed.size())
    {
      found.back().Unsorted.push_back(placed[i].Prop);
    }
  }
  return found;
}
