// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBucketShotPeeler_h
#define vtkOITBucketShotPeeler_h

#include "Private/Frame/vtkOITEyeDepthInterval.h"
#include "Private/Peeling/vtkOITPeeler.h"
#include "glsl/Common/vtkOITConstants.h"

#include <map>
#include <vector>

/**
 * The single shot of bucket depth peeling (Liu, Huang, Liu and Wu 2009): one geometry pass keeps a
 * packed colour for each bucket; with adaptive buckets one finds depths, and one keeps colours.
 */
class vtkOITBucketShotPeeler : public vtkOITPeeler
{
public:
  /// The one that finds the depth range of each pixel.
  int GetNumberOfSetUpPeels() const override { return this->HasExactRange ? 1 : 0; }
  void Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings) override;
  vtkOITPeelState::Layout GetLayout(const vtkOITFrame&) const override { return {}; }
  int GetBytesPerPixel(const vtkOITFrame& frame) const override;
  std::int64_t GetSizeInBytes() const override;

  vtkOITFailure Begin(const vtkOITPeelContext& context) override;
  vtkOITFailure Peel(const vtkOITPeelContext& context, int number) override;
  /// What was not kept is lost, and counted.
  bool IsDone() const override { return this->Stage != OIT_SHOT_RANGE; }

  vtkOITGather& GetGather() override { return this->Gather; }
  void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) override;
  void Release() override;

private:
  enum class Division
  {
    Uniform, // 24 buckets of equal size, which keep the nearest fragment
    Pairs,   // 12, which keep the nearest and the farthest
    Adaptive // as many as a pixel has fragments, up to 32
  };

  void NumberOpacities(const std::vector<vtkProp*>& props);
  void SetOpacityBits(vtkShaderProgram* program) const;
  void Define(vtkOITShaderText& text) const;
  vtkOITFailure GatherStage(const vtkOITPeelContext& context, int stage);
  vtkOITFailure DivideBuckets(const vtkOITPeelContext& context);
  vtkOITFailure Resolve(const vtkOITPeelContext& context);

  Division UsedDivision = Division::Uniform;
  bool HasExactRange = false;
  bool FloatColor = false;
  bool ClampsColor = false;
  bool InPlace = false;         // of ResolveStage's program
  int Stage = OIT_SHOT_RANGE;   // of the geometry pass
  std::vector<float> Opacities; // of the frame, if each prop has one; otherwise empty
  std::map<vtkProp*, int> OpacityNumbers;
  vtkOITGather Gather;
  vtkOITEyeDepthInterval Interval;

  vtkOITTextureArray Buckets;
  vtkOITTextureArray Table;  // adaptive only: slots of the buckets
  vtkOITTextureArray Colors; // adaptive only: of the slots
  vtkOITFramebuffer GatherFramebuffer;
  vtkOITFramebuffer TableFramebuffer;
  vtkOITScreenStage DivideStage;
  vtkOITScreenStage ResolveStage;
};

#endif
