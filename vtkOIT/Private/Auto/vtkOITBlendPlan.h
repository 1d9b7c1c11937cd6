// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBlendPlan_h
#define vtkOITBlendPlan_h

#include "Private/Auto/vtkOITMeshShapes.h"
#include "Private/Frame/vtkOITRectangle.h"

#include <vector>

class vtkOITFrame;
class vtkProp;
struct vtkOITScreenExtent;

/**
 * Which props of a frame need no sorting of fragments, and in which order they are blended.
 *
 * Props are divided into islands, whose screen rectangles do not touch each other. An island is
 * blended when each of its props is flat or convex (vtkOITMeshShape), so its own order is known,
 * and any two of them that share pixels have a known order: their intervals of window depth are
 * disjoint, a plane across an axis separates their bounds, or one is in a ball inside of the other,
 * which is closed. Far ones come first; of closed convex props the far faces before the near ones,
 * and what they enclose between. Everything else is to be sorted.
 */
class vtkOITBlendPlan
{
public:
  enum class Faces
  {
    All,
    Far, // of closed convex props
    Near
  };
  struct Step
  {
    std::vector<vtkProp*> Props;
    Faces Side = Faces::All;
  };

  vtkOITBlendPlan(const vtkOITFrame& frame, const std::vector<vtkOITScreenExtent>& extents,
    vtkOITMeshShapes& shapes);

  /// To be blended, back to front. Props of a step that share pixels are in order.
  const std::vector<Step>& GetSteps() const { return this->Steps; }
  const vtkOITRectangle& GetBlendRectangle() const { return this->BlendRectangle; }
  /// The most layers that the steps can have at a pixel.
  int GetMaximumLayers() const { return this->MaximumLayers; }
  /// Whether nothing of the last step is drawn over by another part of it.
  bool EndsWithTopLayers() const
  {
    return !this->Steps.empty() && this->Steps.back().Side == Faces::Near;
  }
  int GetNumberOfBlendedProps() const { return this->NumberOfBlendedProps; }
  /// Whether a closed convex prop is drawn with its faces pointing inwards.
  bool IsInsideOut(vtkProp* prop) const;

  /// To be sorted.
  const std::vector<vtkProp*>& GetSortedProps() const { return this->Sorted; }
  const vtkOITRectangle& GetSortedRectangle() const { return this->SortedRectangle; }

private:
  std::vector<Step> Steps;
  std::vector<vtkProp*> Sorted;
  std::vector<vtkProp*> InsideOut;
  vtkOITRectangle BlendRectangle;
  vtkOITRectangle SortedRectangle;
  int MaximumLayers = 0;
  int NumberOfBlendedProps = 0;
};

#endif
