// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITPropOrder.h"

#include "Private/Frame/vtkOITScreenExtents.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace
{
/// Window depths nearer to each other may be equal in float32, which makes fragments coincident.
constexpr double SmallestDepthGap = 4.0 / (1 << 24);
/// The same for positions, in diagonals of the bounds.
constexpr double SmallestGap = 1e-4;

/// Depths, the camera's place, and which faces of triangles are front faces are what they seem.
bool IsPlain(vtkCamera* camera)
{
  const double* shear = camera->GetViewShear();
  return camera->GetModelTransformMatrix()->IsIdentity() && !camera->GetUserTransform() &&
    !camera->GetUserViewTransform() && camera->GetUseOffAxisProjection() == 0 && shear[0] == 0.0 &&
    shear[1] == 0.0;
}
}

//------------------------------------------------------------------------------
vtkOITView::vtkOITView(vtkCamera* camera)
  : IsParallel(camera->GetParallelProjection() != 0)
  , IsPlain(::IsPlain(camera))
{
  camera->GetPosition(this->Position.data());
  camera->GetDirectionOfProjection(this->Direction.data());
}

//------------------------------------------------------------------------------
// Whether nothing of the other is outside of the inner ball.
bool vtkOITPlacedProp::IsAround(const vtkOITPlacedProp& other, double gap) const
{
  const glm::dvec3 center(this->Balls.Center[0], this->Balls.Center[1], this->Balls.Center[2]);
  const std::array<double, 3>& c = other.Balls.Center;
  double reach = glm::distance(center, glm::dvec3(c[0], c[1], c[2])) + other.Balls.Outer;
  double toCorner = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 point(other.Bounds[corner & 1], other.Bounds[2 + ((corner >> 1) & 1)],
      other.Bounds[4 + (corner >> 2)]);
    toCorner = std::max(toCorner, glm::distance(center, point));
  }
  return std::min(reach, toCorner) + gap < this->Balls.Inner;
}

//------------------------------------------------------------------------------
vtkOITRelation vtkOITPlacedProp::Compare(
  const vtkOITPlacedProp& other, const vtkOITView& view) const
{
  if (this->Extent->Rectangle.Intersect(other.Extent->Rectangle).IsEmpty())
  {
    return vtkOITRelation::Apart;
  }
  if (this->Extent->Farthest + SmallestDepthGap < other.Extent->Nearest)
  {
    return vtkOITRelation::FirstInFront;
  }
  if (other.Extent->Farthest + SmallestDepthGap < this->Extent->Nearest)
  {
    return vtkOITRelation::SecondInFront;
  }
  vtkBoundingBox both(this->Bounds.data());
  both.AddBounds(other.Bounds.data());
  const double gap = SmallestGap * both.GetDiagonalLength();
  for (int axis = 0; axis < 3; ++axis)
  {
    const int low = 2 * axis;
    const int high = low + 1;
    if (this->Bounds[high] + gap < other.Bounds[low])
    {
      return view.IsLowerInFront(axis, this->Bounds[high]) ? vtkOITRelation::FirstInFront
                                                           : vtkOITRelation::SecondInFront;
    }
    if (other.Bounds[high] + gap < this->Bounds[low])
    {
      return view.IsLowerInFront(axis, other.Bounds[high]) ? vtkOITRelation::SecondInFront
                                                           : vtkOITRelation::FirstInFront;
    }
  }
  return this->IsAround(other, gap) ? vtkOITRelation::FirstAround
    : other.IsAround(*this, gap)    ? vtkOITRelation::SecondAround
                                    : vtkOITRelation::Unknown;
}
