// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPlanner_h
#define vtkOITPlanner_h

#include "Private/Auto/vtkOITFrameSignature.h"
#include "Private/Auto/vtkOITMeshShapes.h"
#include "Private/Plan/vtkOITPlan.h"

struct vtkOITSettings;

/**
 * Plans a frame of the automatic choice, without touching OpenGL:
 *
 * 1. Props that leave no trace are left out.
 * 2. Whether the frame differs from the last one that was planned.
 * 3. Which props are blended, because their order is proven, and which are sorted.
 */
class vtkOITPlanner
{
public:
  /// `isKnown`: what is drawn are the props and nothing else. The plan must not outlive the planner.
  vtkOITPlan MakePlan(const vtkOITFrame& frame, const vtkOITSettings& settings, bool isKnown);

  /// The next frame differs from all before it.
  void Forget() { this->Signature = {}; }

private:
  vtkOITMeshShapes Shapes;
  vtkOITFrameSignature Signature; // of the last frame
};

#endif
