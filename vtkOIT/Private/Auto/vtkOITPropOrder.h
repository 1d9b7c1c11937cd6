// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPropOrder_h
#define vtkOITPropOrder_h

#include "Private/Auto/vtkOITMeshShapes.h"

#include <array>

class vtkProp;
class vtkRenderer;
struct vtkOITScreenExtent;

/// Where the camera is, and where it looks to.
struct vtkOITView
{
  explicit vtkOITView(vtkRenderer* renderer);

  /// Which side of the plane across an axis is in front: that of lower coordinates?
  bool IsLowerInFront(int axis, double plane) const
  {
    return this->IsParallel ? this->Direction[axis] >= 0.0 : this->Position[axis] <= plane;
  }

  bool IsParallel;
  /// Depths, the camera's place, and which faces of triangles are front faces are what they seem:
  /// proven from the matrix that draws.
  bool IsPlain;
  std::array<double, 3> Position{};
  std::array<double, 3> Direction{};
};

/// Which of two props is in front, at each pixel that they share.
enum class vtkOITRelation
{
  Apart, // no order is needed
  FirstInFront,
  SecondInFront,
  FirstAround, // its far faces are behind, its near ones in front of the second
  SecondAround,
  Unknown
};

/// A prop, and what is known of its place in the scene.
struct vtkOITPlacedProp
{
  vtkProp* Prop = nullptr;
  const vtkOITScreenExtent* Extent = nullptr;
  vtkOITMeshShape Shape = vtkOITMeshShape::Unknown;
  std::array<double, 6> Bounds{};
  vtkOITMeshBalls Balls;

  bool IsClosed() const
  {
    return this->Shape == vtkOITMeshShape::ClosedConvex ||
      this->Shape == vtkOITMeshShape::ClosedConvexInside;
  }

  /// Proven by disjoint intervals of window depth, by a plane across an axis that separates the
  /// bounds, or by one being in a ball inside of the other, which is closed.
  vtkOITRelation Compare(const vtkOITPlacedProp& other, const vtkOITView& view) const;

private:
  bool IsAround(const vtkOITPlacedProp& other, double gap) const;
};

#endif
