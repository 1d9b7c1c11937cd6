// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITPixelStatistics_h
#define vtkOITPixelStatistics_h

#include "Private/Frame/vtkOITRectangle.h"
#include "Private/GL/vtkOITFramebuffer.h"
#include "Private/GL/vtkOITScreenStage.h"
#include "Private/GL/vtkOITTextureArray.h"

#include <cstdint>

struct vtkOITFrame;

/**
 * Sums up what a pass counts in each pixel, in layer 1 of a texture array: fragments; unused; error
 * bound; fragments that were lost. A screen pass sums up blocks, the rest is done here: the texels
 * read back are one for 256 pixels.
 */
class vtkOITPixelStatistics
{
public:
  struct Result
  {
    std::int64_t Fragments = 0;
    int MostFragments = 0;   // of a pixel
    double ErrorBound = 0.0; // largest of a pixel
    std::int64_t Lost = 0;
  };

  /// Of a region of texels. Waits for the GPU; changes framebuffers, viewport, scissor, blending,
  /// depth test and culling.
  vtkOITFailure Reduce(const vtkOITFrame& frame, const vtkOITTextureArray& array,
    const vtkOITRectangle& region, Result& result);

  std::int64_t GetSizeInBytes() const { return this->Sums.GetSizeInBytes(); }
  void Release();

private:
  vtkOITTextureArray Sums;
  vtkOITFramebuffer Framebuffer;
  vtkOITScreenStage Stage;
};

#endif
