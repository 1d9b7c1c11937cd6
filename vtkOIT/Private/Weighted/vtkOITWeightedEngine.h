// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITWeightedEngine_h
#define vtkOITWeightedEngine_h

#include "Private/Engine/vtkOITEngine.h"
#include "Private/Engine/vtkOITGather.h"
#include "Private/Frame/vtkOITBands.h"
#include "Private/Frame/vtkOITEyeDepthInterval.h"
#include "Private/GL/vtkOITDepthCopy.h"
#include "Private/GL/vtkOITFramebuffer.h"
#include "Private/GL/vtkOITOutput.h"
#include "Private/GL/vtkOITPixelStatistics.h"
#include "Private/GL/vtkOITTextureArray.h"

/// Weighted sums over the fragments of a pixel: see vtkOITWeightedPass.
class vtkOITWeightedEngine : public vtkOITEngine
{
public:
  std::string GetAlgorithmName(const vtkOITSettings& settings) const override;
  std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  std::string FindMissingIn(const vtkOITFrame& frame) const override;
  bool IsPreview() const override { return true; }
  vtkOITFailure Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
    vtkOITGeometry& geometry, vtkOITStatistics& statistics) override;
  std::int64_t GetSizeInBytes() const override;
  void Release() override;

private:
  void AddWeight(vtkOITShaderText& text) const;
  vtkOITFailure DrawBand(const vtkOITFrame& frame, const vtkOITRectangle& band, bool isPart,
    vtkOITGeometry& geometry, vtkOITStatistics& statistics);
  vtkOITFailure AddUp(const vtkOITFrame& frame, const vtkOITRectangle& band,
    const vtkOITRectangle& storage, vtkOITGeometry& geometry);
  vtkOITFailure Composite(const vtkOITFrame& frame, const vtkOITRectangle& storage);

  int Mode = 0; // of the frame
  vtkOITGather Gather;
  vtkOITBands Bands;
  vtkOITTextureArray Sums;
  vtkOITDepthCopy OpaqueDepth;
  vtkOITFramebuffer Framebuffer;
  vtkOITOutputStage CompositeStage;
  vtkOITPixelStatistics PixelStatistics;
  vtkOITEyeDepthInterval Interval;
};

#endif
