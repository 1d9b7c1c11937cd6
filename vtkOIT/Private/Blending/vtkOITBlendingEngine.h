// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBlendingEngine_h
#define vtkOITBlendingEngine_h

#include "Private/Blending/vtkOITBlendSteps.h"
#include "Private/Engine/vtkOITEngine.h"
#include "Private/Engine/vtkOITGather.h"

class vtkOITLayerTarget;

/**
 * Ordered blending: props whose order is known are drawn back to front, of closed ones the far
 * faces first.
 *
 * Into the frame's target, by framebuffer fetch in float32 where that is more accurate; or into the
 * target with a float32 layer beside it, which has the same without rounding.
 */
class vtkOITBlendingEngine : public vtkOITEngine
{
public:
  /// What the next Draw() draws.
  void SetSteps(const vtkOITBlendSteps* steps) { this->Steps = steps; }
  /// The layer that the target of the next Draw() has beside its own buffer; nullptr for none.
  void SetLayerBeside(const vtkOITLayerTarget* layer) { this->LayerBeside = layer; }

  std::string GetAlgorithmName(const vtkOITSettings&) const override { return "ordered blending"; }
  std::string FindMissing(const vtkOITCapabilities&, const vtkOITSettings&) const override
  {
    return {};
  }
  vtkOITFailure Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
    vtkOITGeometry& geometry, vtkOITStatistics& statistics) override;
  std::int64_t GetSizeInBytes() const override { return 0; }
  void Release() override {}

private:
  void SetStage(const vtkOITFrame& frame);

  const vtkOITBlendSteps* Steps = nullptr;
  const vtkOITLayerTarget* LayerBeside = nullptr;
  vtkOITGather Gather;
};

#endif
