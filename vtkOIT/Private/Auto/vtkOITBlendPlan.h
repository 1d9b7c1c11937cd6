// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBlendPlan_h
#define vtkOITBlendPlan_h

#include "Private/Auto/vtkOITMeshShapes.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Plan/vtkOITPlan.h"

/**
 * Which props of a frame need no sorting of fragments, and in which order they are blended.
 *
 * Props are divided into islands, whose screen rectangles do not touch each other. An island is
 * blended when each of its props is flat or convex (vtkOITMeshShape), so its own order is known,
 * and any two of them that share pixels have a known order (vtkOITRelation). Far ones come first;
 * of closed convex props the far faces before the near ones, and what they enclose between.
 *
 * Where some of this is not known, the others are blended and those are sorted, in turns
 * (vtkOITBatches), if that costs less than sorting all of the island.
 */
class vtkOITBlendPlan
{
public:
  vtkOITBlendPlan(const vtkOITFrame& frame, vtkOITMeshShapes& shapes);

  vtkOITOrder Order;
};

#endif
