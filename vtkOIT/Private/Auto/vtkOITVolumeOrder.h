// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITVolumeOrder_h
#define vtkOITVolumeOrder_h

#include "Private/Frame/vtkOITRectangle.h"

#include <string>
#include <vector>

class vtkProp;
struct vtkOITFrame;

/**
 * When the volumes of a frame are drawn, without touching OpenGL. Those that are proven to lie behind
 * all translucent props and all other volumes, by their boxes, are drawn before them, those in front
 * after them. The others are drawn between them, if their mappers can.
 */
struct vtkOITVolumeOrder
{
  vtkOITVolumeOrder(const vtkOITFrame& frame, const std::vector<vtkProp*>& volumes);

  /// Back to front.
  ///@{
  std::vector<vtkProp*> Before;
  std::vector<vtkProp*> Between;
  std::vector<vtkProp*> After;
  ///@}

  /// The pixels of those between.
  vtkOITRectangle Rectangle;

  /// One line that says why the picture may be wrong, when all are drawn so, or (`isDrawn` false)
  /// all of them over the translucent props; empty when it is right.
  std::string FindDoubt(bool isDrawn) const;

private:
  bool HasUnhooked = false;     // drawn after props that they overlap
  bool HasUnknownOrder = false; // of two volumes between
};

#endif
