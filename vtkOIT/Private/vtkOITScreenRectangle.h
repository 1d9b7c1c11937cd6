// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITScreenRectangle_h
#define vtkOITScreenRectangle_h

#include "vtkOITRectangle.h"

#include <vector>

class vtkProp;
class vtkRenderer;

/**
 * The part of `viewport` that the props can touch: their bounding boxes projected by the active
 * camera, plus what points, lines and rounding add. Never too small: a prop whose bounds do not
 * limit its picture (glyph and impostor mappers, shader replacements, assemblies, boxes that
 * reach behind the camera) makes it the whole viewport.
 */
vtkOITRectangle vtkOITFindScreenRectangle(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props, const vtkOITRectangle& viewport);

#endif
