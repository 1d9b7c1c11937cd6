// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITGroups_h
#define vtkOITGroups_h

#include "Private/Frame/vtkOITFrame.h"

#include <vector>

class vtkProp;

/// Props that are drawn together, over what was drawn before.
struct vtkOITGroup
{
  /// Sorted among themselves; may have none.
  vtkOITFrame Frame;
  /// Blended over them as VTK draws them, in this order.
  std::vector<vtkProp*> Unsorted;
};

/**
 * Divides a frame by props that cannot be sorted, so that each of these is blended in its place: over
 * what is behind it, and under what is in front. In front is what has the nearer centre of its
 * bounding box, in window depth; boxes that lie apart in depth are always in their order. Props
 * without bounds are drawn where they would be if nobody knew of depths: the unsorted ones over all others.
 *
 * Returns the groups, farthest first. Without unsorted props that is one group, the frame as it is. With
 * volumes between the props it is one, too: they lie among all of them, and the unsorted ones over all.
 */
std::vector<vtkOITGroup> vtkOITFindGroups(
  const vtkOITFrame& frame, const std::vector<vtkProp*>& unsorted);

#endif
