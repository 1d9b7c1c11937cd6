// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDepthCheck_h
#define vtkOITDepthCheck_h

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITDepthCopy.h"
#include "Private/GL/vtkOITOcclusionQueries.h"
#include "Private/GL/vtkOITScreenStage.h"

/**
 * Whether the opaque geometry of a frame is where it was in an earlier one: its depth is kept, and
 * compared pixel by pixel. That sees every change, whoever drew what.
 *
 * 8 bytes per pixel.
 */
class vtkOITDepthCheck
{
public:
  /// Keeps the depth of the frame's rectangle. Changes the framebuffers bound.
  vtkOITFailure Keep(const vtkOITFrame& frame);

  /// Compares with what was kept for the same rectangle. Waits for the opaque geometry to be drawn.
  /// False when it cannot tell.
  bool IsUnchanged(const vtkOITFrame& frame);

  std::int64_t GetSizeInBytes() const
  {
    return this->Kept.GetSizeInBytes() + this->Now.GetSizeInBytes();
  }
  /// That it takes for the frame's rectangle.
  static std::int64_t GetBytes(const vtkOITFrame& frame)
  {
    return 2 * vtkOITDepthCopy::GetBytes(frame.FindStorage(frame.Rectangle), frame.Target);
  }
  void Release();

private:
  vtkOITDepthCopy Kept;
  vtkOITDepthCopy Now;
  vtkOITOcclusionQueries Query;
  vtkOITScreenStage Stage;
};

#endif
