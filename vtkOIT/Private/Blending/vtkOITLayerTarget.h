// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITLayerTarget_h
#define vtkOITLayerTarget_h

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITScreenStage.h"
#include "Private/GL/vtkOITTextureArray.h"

#include <cstdint>
#include <string>

class vtkOITShaderText;
class vtkShaderProgram;

/**
 * One float32 layer of all translucent props, premultiplied: drawn into in place of the
 * framebuffer, under its depth test, and composited over it. So many props can be blended one after
 * another without the rounding of an 8-bit framebuffer, and the layer can be kept for later frames.
 *
 * Or drawn into beside the framebuffer, where both can be read by framebuffer fetch: then the
 * picture needs no compositing, which costs more than the drawing does when pixels have few layers.
 *
 * 16 bytes per pixel.
 */
class vtkOITLayerTarget
{
public:
  /// Empties the layer: `target` is a framebuffer that draws into it. Fails where the framebuffer
  /// has no depth buffer that can be shared, or there is no memory.
  vtkOITFailure Begin(
    const vtkOITFrame& frame, const vtkOITRectangle& rectangle, vtkOITTarget& target);

  /// `target` is a framebuffer that draws into what the frame's target draws into, and into the
  /// layer as a second colour buffer beside it, for shaders with vtkOITBlendBesideFS.glsl. For
  /// targets of fixed-point colour and contexts with framebuffer fetch. Fails where the driver does
  /// not take the two together, or there is no memory.
  vtkOITFailure BeginBeside(
    const vtkOITFrame& frame, const vtkOITRectangle& rectangle, vtkOITTarget& target);

  /// The output of these shaders, and their uniform.
  ///@{
  static void AddOutputBeside(vtkOITShaderText& text);
  void SetUniformsBeside(vtkShaderProgram* program) const;
  ///@}

  /// Whether the layer beside is written, under a colour mask that is all on: not needed for what
  /// nothing is drawn over. To be turned on again afterwards.
  static void WriteBeside(bool writes);

  /// The layer over the frame's target, inside the rectangle of Begin(). Changes framebuffer,
  /// blending, depth test, culling, scissor, colour mask and draw buffers.
  vtkOITFailure Composite(const vtkOITFrame& frame);

  std::int64_t GetSizeInBytes() const { return this->Layer.GetSizeInBytes(); }
  static std::int64_t GetBytes(const vtkOITFrame& frame, const vtkOITRectangle& rectangle);
  void Release();

private:
  vtkOITFailure Reserve(const vtkOITFrame& frame, const vtkOITRectangle& rectangle);
  void ClearAll(const vtkOITFrame& frame);
  vtkOITFailure BindBeside(const vtkOITFrame& frame);
  std::string GetCompositeShader() const;

  vtkOITTextureArray Layer;
  vtkOITFramebuffer Framebuffer;
  vtkOITFramebuffer FramebufferBeside;
  vtkOITScreenStage CompositeStage;
  vtkOITRectangle Rectangle;
  bool ByFetch = false;     // how CompositeStage
  bool ReadsBeside = false; // was compiled
  bool BesideWorks = true;
  int Stamp = 0; // of the last frame drawn beside the framebuffer; 0: the layer holds other things
};

#endif
