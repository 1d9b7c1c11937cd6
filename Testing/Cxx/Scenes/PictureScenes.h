// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Scenes for pictures: lit, in perspective, with what users draw. All procedural.
 */

#ifndef PictureScenes_h
#define PictureScenes_h

#include <functional>
#include <string>

class vtkRenderWindow;
class vtkRenderer;

namespace vtkOITTest
{
/// Fills the window with a scene of this name and calls attach for each of its renderers. False
/// for an unknown name. Names: ClippingPlanes, Impostors, Multisampling, NestedIsosurfaces,
/// OverlappingSpheres, Textures, TransparentBackground, Viewports.
bool BuildScene(const std::string& name, vtkRenderWindow* window,
  const std::function<void(vtkRenderer*)>& attach);
}

#endif
