// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITLayerTarget_h
#define vtkOITLayerTarget_h

#include "vtkOITFrame.h"
#include "vtkOITScreenStage.h"
#include "vtkOITTextureArray.h"

#include <cstdint>

/**
 * One float32 layer of all translucent props, premultiplied: drawn into in place of the
 * framebuffer, under its depth test, and composited over it. So many props can be blended one after
 * another without the rounding of an 8-bit framebuffer, and the layer can be kept for later frames.
 *
 * 16 bytes per pixel.
 */
class vtkOITLayerTarget
{
public:
  /// Draws into the empty layer from now on: the frame's target is the layer. False, and nothing
  /// changes, where the framebuffer has no depth buffer that can be shared.
  bool Begin(vtkOITFrame& frame, const vtkOITRectangle& rectangle);

  /// Draws into the framebuffer again. After Begin().
  void End(vtkOITFrame& frame);

  /// The layer over the framebuffer bound for drawing, inside the rectangle of Begin(). Changes
  /// blending, depth test, culling, scissor, colour mask and draw buffers.
  void Composite(const vtkOITFrame& frame);

  std::int64_t GetSizeInBytes() const { return this->Layer.GetSizeInBytes(); }
  static std::int64_t GetBytes(const vtkOITFrame& frame, const vtkOITRectangle& rectangle);
  void Release();

private:
  vtkOITTextureArray Layer;
  vtkOITFramebuffer Framebuffer;
  vtkOITScreenStage CompositeStage;
  vtkOITRectangle Rectangle;
  vtkOITTarget TargetBefore;
  bool ByFetch = false;
};

#endif
