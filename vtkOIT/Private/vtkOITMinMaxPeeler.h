// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITMinMaxPeeler_h
#define vtkOITMinMaxPeeler_h

#include "vtkOITPeeler.h"
#include "vtkTimeStamp.h"

/**
 * Depth peeling with a sliding window: while the fragments at the bounds of a pixel are blended,
 * the bounds of the next peel are found among those inside. One-sided it peels the nearest layer
 * (Everitt 2001), two-sided the nearest and the farthest (Bavoil and Myers 2008).
 *
 * Coincident fragments are blended as a group: sums are added, depths are kept as the maximum.
 */
class vtkOITMinMaxPeeler : public vtkOITPeeler
{
public:
  explicit vtkOITMinMaxPeeler(bool isDual)
    : IsDual(isDual)
  {
  }

  int GetNumberOfSetUpPeels() const override { return 1; }
  vtkOITPeelState::Layout GetLayout(const vtkOITFrame& frame) const override;
  int GetBytesPerPixel(const vtkOITFrame& frame) const override;
  std::int64_t GetSizeInBytes() const override;

  vtkOITPeelState::MaskSide GetMaskSide(int number) const override;
  void Prepare(const vtkOITFrame& frame, bool hasFloatColor) override;
  void Begin(const vtkOITPeelContext& context) override;
  void Peel(const vtkOITPeelContext& context, int number) override;
  void PeelRest(const vtkOITPeelContext& context) override;

  bool WrapGather(std::string& fragmentShader) const override;
  void SetUniforms(vtkShaderProgram* program, const vtkOITPeelContext& context) override;
  vtkMTimeType GetShaderMTime() const override { return this->ShaderTime.GetMTime(); }

  void Release() override;

private:
  int GetNumberOfSumLayers(bool isJoint) const;
  GLenum GetSumFormat(bool isJoint) const;
  std::string GetDefinitions() const;
  void BindForGather(const vtkOITPeelContext& context, bool isSetUp);

  bool IsDual;
  bool IsJoint = false; // one way of blending for all buffers
  bool HasFloatColor = false;
  vtkTimeStamp ShaderTime;
  bool IsRest = false;
  bool InPlace = false; // of ResolveStage's program
  vtkOITTextureArray Sums;
  vtkOITTextureArray Depths;
  vtkOITFramebuffer GatherFramebuffer;
  vtkOITScreenStage ResolveStage;
};

#endif
