// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITMinMaxPeeler_h
#define vtkOITMinMaxPeeler_h

#include "Private/Peeling/vtkOITPeeler.h"

/**
 * Depth peeling with a sliding window: while the fragments at the bounds of a pixel are blended,
 * the bounds of the next peel are found among those inside. One-sided it peels the nearest layer
 * (Everitt 2001), two-sided the nearest and the farthest (Bavoil and Myers 2008), where shaders
 * cannot read the framebuffer; where they can, vtkOITDualPeeler does it better.
 *
 * Coincident fragments are blended as a group, also in the order of drawing. Where shaders can read
 * the framebuffer, they sum up in place. Otherwise sums are added by blending, depths are kept as
 * the maximum, one way of blending for colours, another for alpha, so no GL beyond 3.2 is needed but
 * for that order. Floats throughout: half floats for the sums were not faster on llvmpipe, separate
 * buffers for depths neither.
 */
class vtkOITMinMaxPeeler : public vtkOITPeeler
{
public:
  explicit vtkOITMinMaxPeeler(bool isDual)
    : IsDual(isDual)
  {
  }

  std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  int GetNumberOfSetUpPeels() const override { return 1; }
  void Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings) override;
  vtkOITPeelState::Layout GetLayout(const vtkOITFrame& frame) const override;
  int GetBytesPerPixel(const vtkOITFrame& frame) const override;
  std::int64_t GetSizeInBytes() const override { return this->Sums.GetSizeInBytes(); }

  vtkOITFailure Begin(const vtkOITPeelContext& context) override;
  vtkOITFailure Peel(const vtkOITPeelContext& context, int number) override;

  vtkOITGather& GetGather() override { return this->Gather; }
  void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) override;

  void Release() override;

private:
  vtkOITFailure GatherInPlace(const vtkOITPeelContext& context, bool isSetUp);
  vtkOITFailure GatherByBlending(const vtkOITPeelContext& context, bool isSetUp);
  int GetNumberOfSums(bool inPlace) const;

  bool IsDual;
  bool InPlace = false;   // of the shaders
  bool LastOnTop = false; // of the shaders
  vtkOITGather Gather;
  vtkOITTextureArray Sums;
  vtkOITFramebuffer GatherFramebuffer;
  vtkOITScreenStage ResolveStage;
};

#endif
