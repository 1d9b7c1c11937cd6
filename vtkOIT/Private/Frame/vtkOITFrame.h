// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITFrame_h
#define vtkOITFrame_h

#include "Private/Frame/vtkOITRectangle.h"
#include "Private/Frame/vtkOITScreenExtents.h"
#include "Private/Frame/vtkOITTarget.h"

#include <vector>

class vtkOITCapabilities;
class vtkOITVolumes;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkProp;
class vtkRenderer;

/**
 * What is drawn, where, and on what: a frame of a pass, or a part of one. It is made once and const
 * from then on; parts of it, and the same on another target, are new ones.
 */
struct vtkOITFrame
{
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkOpenGLState* GLState = nullptr;
  const vtkOITCapabilities* Capabilities = nullptr;
  /// Of GL, in pixels of the framebuffer.
  vtkOITRectangle Viewport;
  /// What is drawn into.
  vtkOITTarget Target;

  /// The translucent props, and the extent of each.
  std::vector<vtkProp*> Props;
  std::vector<vtkOITScreenExtent> Extents;
  /// Some of them may add light, see vtkOITAddsLight().
  bool HasLight = false;
  /// Those that lie between the props; nullptr without.
  vtkOITVolumes* Volumes = nullptr;
  /// The only pixels that may be drawn to.
  vtkOITRectangle Rectangle;

  /// The same inside of a rectangle only.
  vtkOITFrame Inside(const vtkOITRectangle& rectangle) const;
  /// The same on another target.
  vtkOITFrame On(const vtkOITTarget& target) const;

  /// The pixels that textures of a pass cover so that those of the band keep their place in the
  /// framebuffer; in steps, so that a moving camera does not make every frame allocate.
  vtkOITRectangle FindStorage(const vtkOITRectangle& band) const;

  /// Sets the state from which geometry is drawn into the band of the target, as the application
  /// would: the target with all of its buffers, viewport, depth test and culling as they were
  /// found; the scissor is the band; depth is not written.
  void BeginGeometry(const vtkOITRectangle& band) const;

  /// The same for drawing into textures that cover `storage`: viewport and scissor are shifted.
  /// Binds no framebuffer.
  void BeginStorage(const vtkOITRectangle& band, const vtkOITRectangle& storage) const;

  /// Sets the state in which pixels of the band are drawn over the target's first colour buffer:
  /// no depth test, no culling.
  void BeginOutput(const vtkOITRectangle& band) const;
};

#endif
