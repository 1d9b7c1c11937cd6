// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBlendPlan_h
#define vtkOITBlendPlan_h

#include "Private/Auto/vtkOITMeshShapes.h"
#include "Private/Blending/vtkOITBlendSteps.h"
#include "Private/Frame/vtkOITFrame.h"

/**
 * Which props of a frame need no sorting of fragments, and in which order they are blended.
 *
 * Props are divided into islands, whose screen rectangles do not touch each other. An island is
 * blended when each of its props is flat or convex (vtkOITMeshShape), so its own order is known,
 * and any two of them that share pixels have a known order (vtkOITRelation). Far ones come first;
 * of closed convex props the far faces before the near ones, and what they enclose between.
 * Everything else is to be sorted.
 */
class vtkOITBlendPlan
{
public:
  vtkOITBlendPlan(const vtkOITFrame& frame, vtkOITMeshShapes& shapes);

  vtkOITBlendSteps Blended;
  /// The props to be sorted, and where they are.
  vtkOITFrame Sorted;
};

#endif
