// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITFrame_h
#define vtkOITFrame_h

#include "Private/Frame/vtkOITRectangle.h"
#include "Private/Frame/vtkOITScreenExtents.h"
#include "vtkRenderState.h"

#include <vector>

class vtkOITCapabilities;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkProp;

/// Facts about the bound framebuffer that decide how a pass captures and composites.
struct vtkOITTarget
{
  /// The framebuffer, 0 the default one, and its first draw buffer.
  unsigned int Framebuffer = 0;
  unsigned int DrawBuffer = 0;
  /// Samples per pixel, 0 without multisampling.
  int Samples = 0;
  /// Fixed-point colour of at most 10 bits, linear: llvmpipe blends such a target in its own bits,
  /// so a shader that reads the destination is more accurate.
  bool CoarseColor = false;
  /// Format of the depth buffer, 0 bits without one.
  int DepthBits = 0;
  int StencilBits = 0;
  bool FloatDepth = false;

  /// Asks GL about the framebuffer bound for drawing.
  static vtkOITTarget Query();
};

/// One frame of a vtkOITPass: what RenderTranslucent() works on.
class vtkOITFrame
{
public:
  vtkOITFrame(const vtkRenderState* state, std::vector<vtkProp*> translucentProps);

  /// Holds only the translucent props of the state that the pass was given.
  const vtkRenderState* GetState() const { return &this->State; }

  /// The props that the state holds, and a change of them.
  ///@{
  const std::vector<vtkProp*>& GetProps() const { return this->Props; }
  void DrawOnly(std::vector<vtkProp*> props);
  ///@}

  /// Of the bound framebuffer's colour buffers, only the first is drawn to from now on.
  void DrawToFirstBufferOnly() const;

  /// The pixels that textures of a pass cover so that those of the band keep their place in the
  /// framebuffer; in steps, so that a moving camera does not make every frame allocate.
  vtkOITRectangle FindStorage(const vtkOITRectangle& band) const;

  /// Viewport and scissor for drawing the band into textures that cover `storage`.
  void ShiftViewport(const vtkOITRectangle& band, const vtkOITRectangle& storage) const;

  vtkOpenGLRenderWindow* Window = nullptr;
  vtkOpenGLState* GLState = nullptr;
  const vtkOITCapabilities* Capabilities = nullptr;
  /// Of GL, in pixels of the framebuffer.
  vtkOITRectangle Viewport;
  /// Of the props that the pass was given, in their order.
  std::vector<vtkOITScreenExtent> Extents;
  /// The only pixels that translucent props can touch.
  vtkOITRectangle Rectangle;
  vtkOITTarget Target;

private:
  std::vector<vtkProp*> Props;
  vtkRenderState State;
};

/// The props of the state that the delegate would draw as translucent.
std::vector<vtkProp*> vtkOITFindTranslucentProps(const vtkRenderState* state);

#endif
