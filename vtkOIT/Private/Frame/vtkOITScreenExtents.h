// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITScreenExtents_h
#define vtkOITScreenExtents_h

#include "Private/Frame/vtkOITRectangle.h"

#include <glm/mat4x4.hpp>

#include <vector>

class vtkProp;
class vtkRenderer;

/// Where on the screen and in window depth a prop can be.
struct vtkOITScreenExtent
{
  vtkOITRectangle Rectangle; // empty when nothing of it is in the viewport
  double Nearest = 0.0;      // window depths, not clipped to [0, 1]
  double Farthest = 1.0;
  /// False when bounds do not limit the picture of the prop (glyph and impostor mappers, shader
  /// replacements, assemblies, boxes that reach behind the camera): the extent is the viewport.
  bool IsBounded = false;
};

/// World coordinates to clip coordinates, by the active camera.
glm::dmat4 vtkOITFindProjection(vtkRenderer* renderer);

/**
 * The extent of each prop in `viewport`: its bounding box projected by the active camera, plus
 * what points, lines and rounding add. Never too small.
 */
std::vector<vtkOITScreenExtent> vtkOITFindScreenExtents(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props, const vtkOITRectangle& viewport);

/// The smallest rectangle that has all these extents.
vtkOITRectangle vtkOITFindScreenRectangle(const std::vector<vtkOITScreenExtent>& extents);

#endif
