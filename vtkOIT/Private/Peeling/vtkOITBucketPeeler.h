// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBucketPeeler_h
#define vtkOITBucketPeeler_h

#include "Private/Frame/vtkOITEyeDepthInterval.h"
#include "Private/Peeling/vtkOITPeeler.h"

/**
 * Bucket depth peeling (Liu, Huang, Liu and Wu 2009) to the end: one geometry pass per peel sums up
 * the colours at four known depths, and finds the nearest and the farthest depth of each of four
 * buckets between them. vtkOITBucketShotPeeler is the paper's single shot.
 */
class vtkOITBucketPeeler : public vtkOITPeeler
{
public:
  std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  /// The first one finds the depth range of each pixel, and counts fragments.
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
  int GetNumberOfSums() const { return this->LastOnTop ? 6 : 8; }
  vtkOITFailure GatherSums(const vtkOITPeelContext& context);

  bool IsAdaptive = false;
  bool LastOnTop = false;
  bool InPlace = false; // of ResolveStage's program
  bool IsFirst = false; // of the peels
  vtkOITGather Gather;
  vtkOITEyeDepthInterval Interval;

  vtkOITTextureArray Sums;
  vtkOITFramebuffer GatherFramebuffer;
  vtkOITScreenStage ResolveStage;
};

#endif
