// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITPropOrder.h"

#include "Private/Frame/vtkOITScreenExtents.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace
{
/// Window depths nearer to each other may be equal in float32, which makes fragments coincident.
constexpr double SmallestDepthGap = 4.0 / (1 << 24);
/// The same for positions, in diagonals of the bounds.
constexpr double SmallestGap = 1e-4;

/// Rays start at the camera's place, or go along its direction; depth grows along them; and nothing
/// is mirrored, neither by the view nor by the projection: a mirrored matrix has another sign of its
/// determinant.
bool IsPlain(vtkCamera* camera, const glm::dmat4& matrix)
{
  glm::dvec3 position;
  glm::dvec3 direction;
  double near = 0.0;
  double far = 0.0;
  camera->GetPosition(position.x, position.y, position.z);
  camera->GetDirectionOfProjection(direction.x, direction.y, direction.z);
  camera->GetClippingRange(near, far);
  const glm::dvec4 first = matrix * glm::dvec4(position + near * direction, 1.0);
  const glm::dvec4 last = matrix * glm::dvec4(position + far * direction, 1.0);
  const bool hasDepth = first.w > 0.0 && last.w > 0.0 && first.z / first.w < last.z / last.w;
  // Where all rays meet, or what they go along, is drawn nowhere: x, y and w are 0.
  const glm::dvec4 origin =
    camera->GetParallelProjection() ? glm::dvec4(direction, 0.0) : glm::dvec4(position, 1.0);
  const glm::dvec4 image = matrix * origin;
  double scale = 0.0; // of the products that x, y and w are sums of
  for (int column = 0; column < 4; ++column)
  {
    for (const int row : { 0, 1, 3 })
    {
      scale = std::max(scale, std::abs(matrix[column][row] * origin[column]));
    }
  }
  const double largest = std::max({ std::abs(image.x), std::abs(image.y), std::abs(image.w) });
  return hasDepth && largest <= 1e-9 * scale && glm::determinant(matrix) < 0.0;
}
}

//------------------------------------------------------------------------------
vtkOITView::vtkOITView(vtkRenderer* renderer)
  : IsParallel(renderer->GetActiveCamera()->GetParallelProjection() != 0)
  , IsPlain(::IsPlain(renderer->GetActiveCamera(), vtkOITFindProjection(renderer)))
{
  vtkCamera* camera = renderer->GetActiveCamera();
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
