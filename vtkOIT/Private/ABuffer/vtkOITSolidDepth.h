// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITSolidDepth_h
#define vtkOITSolidDepth_h

#include "Private/Engine/vtkOITGather.h"
#include "Private/Frame/vtkOITFailure.h"
#include "Private/GL/vtkOITDepthCopy.h"
#include "Private/GL/vtkOITFramebuffer.h"

#include <cstdint>
#include <vector>

class vtkOITGeometry;
class vtkProp;

/**
 * A copy of the framebuffer's depth in which the fragments of opacity 1 of translucent props are
 * drawn, too: what fails the depth test against it is invisible. Fragments of opacity 1 pass it
 * themselves, by LEQUAL, and so do those that coincide with them.
 *
 * One geometry pass over the given props, without lighting; 4 bytes per pixel. Pixels keep their
 * place in the framebuffer.
 */
class vtkOITSolidDepth
{
public:
  vtkOITSolidDepth();

  /// Makes it for the frame's rectangle of the target, which is bound. Changes framebuffer, colour
  /// mask, depth mask and scissor.
  vtkOITFailure Render(
    const vtkOITFrame& frame, const std::vector<vtkProp*>& props, vtkOITGeometry& geometry);

  /// Binds a framebuffer for drawing that has only this depth.
  vtkOITFailure Bind(const vtkOITFrame& frame);

  std::int64_t GetSizeInBytes() const { return this->Depth.GetSizeInBytes(); }
  static std::int64_t GetBytes(const vtkOITFrame& frame);
  void Release();

private:
  vtkOITDepthCopy Depth;
  vtkOITFramebuffer Framebuffer;
  vtkOITGather Gather;
};

/// The props that can have fragments of opacity 1 although they are translucent: VTK multiplies the
/// opacity of an actor's property with that of scalars and textures, so that must be 1, and a
/// lookup table must have a colour of opacity 1. Props that are not known are left out.
std::vector<vtkProp*> vtkOITFindSolidProps(const std::vector<vtkProp*>& props);

#endif
