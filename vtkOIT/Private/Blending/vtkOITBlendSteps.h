// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBlendSteps_h
#define vtkOITBlendSteps_h

#include "Private/Frame/vtkOITRectangle.h"

#include <algorithm>
#include <vector>

class vtkProp;

/// The order in which props are blended, proven to be that of their depths at each pixel.
struct vtkOITBlendSteps
{
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

  /// Back to front. Props of a step that share pixels are in order.
  std::vector<Step> Steps;
  /// The closed convex props that are drawn with their faces pointing inwards.
  std::vector<vtkProp*> InsideOut;
  int NumberOfProps = 0;
  /// The most layers that the steps can have at a pixel.
  int MaximumLayers = 0;
  vtkOITRectangle Rectangle;

  bool IsInsideOut(vtkProp* prop) const
  {
    return std::find(this->InsideOut.begin(), this->InsideOut.end(), prop) != this->InsideOut.end();
  }
  /// Whether nothing of the last step is drawn over by another part of it.
  bool EndsWithTopLayers() const
  {
    return !this->Steps.empty() && this->Steps.back().Side == Faces::Near;
  }
};

#endif
