// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBucketPeeler_h
#define vtkOITBucketPeeler_h

#include "Private/Frame/vtkOITEyeDepthInterval.h"
#include "Private/Peeling/vtkOITPeeler.h"
#include "vtkTimeStamp.h"

/**
 * Bucket depth peeling (Liu, Huang, Liu and Wu 2009): a geometry pass captures the depths of up to
 * 32 buckets, further ones sum up the colours of four captured depths each.
 */
class vtkOITBucketPeeler : public vtkOITPeeler
{
public:
  enum class Division
  {
    Uniform, // 32 buckets of equal size, which keep the nearest depth
    Pairs,   // 16, which keep the nearest and the farthest
    Adaptive // up to 32, one for each of 1024 bins that has a fragment
  };

  void SetDivision(Division division) { this->WantedDivision = division; }
  /// The first peel starts from the exact depth range of each pixel, found by a geometry pass.
  void SetHasExactRange(bool hasExactRange) { this->HasExactRange = hasExactRange; }
  /// One peel of all 32 slots; what it does not capture is counted as lost.
  void SetIsSingleShot(bool isSingleShot) { this->IsSingleShot = isSingleShot; }

  int GetNumberOfSetUpPeels() const override { return this->HasExactRange ? 1 : 0; }
  void Prepare(const vtkOITFrame& frame, bool hasFloatColor) override;
  vtkOITPeelState::Layout GetLayout(const vtkOITFrame& frame) const override;
  int GetBytesPerPixel(const vtkOITFrame& frame) const override;
  std::int64_t GetSizeInBytes() const override;

  void Begin(const vtkOITPeelContext& context) override;
  void Peel(const vtkOITPeelContext& context, int number) override;
  void PeelRest(const vtkOITPeelContext& context) override;

  bool WrapGather(std::string& fragmentShader) const override;
  void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) override;
  vtkMTimeType GetShaderMTime() const override { return this->ShaderTime.GetMTime(); }

  void Release() override;

private:
  std::string GetDefinitions() const;
  void ChooseHistogramShader(bool isHistogram);
  void GatherHistogram(const vtkOITPeelContext& context);
  void GatherDepths(const vtkOITPeelContext& context);
  void GatherColors(const vtkOITPeelContext& context, int slotLayer, bool isLast);
  void DrawLayers(const vtkOITPeelContext& context, vtkOITTextureArray& layers,
    vtkOITScreenStage& stage, const char* text, const char* sampler,
    const vtkOITTextureArray& source);
  void EmptySlots(const vtkOITPeelContext& context);

  Division WantedDivision = Division::Uniform;
  Division UsedDivision = Division::Uniform;
  bool HasExactRange = false;
  bool IsSingleShot = false;
  bool InPlace = false; // of ResolveStage's program
  bool IsHistogram = false;
  vtkTimeStamp ShaderTime;
  vtkOITEyeDepthInterval Interval;

  // Of the geometry pass.
  bool IsColorStage = false;
  bool IsRest = false;
  bool CountsLost = false;
  int SlotLayer = 0;
  int LastSlotLayer = 0;

  vtkOITTextureArray Depths;    // of the buckets
  vtkOITTextureArray Slots;     // the same, sorted
  vtkOITTextureArray Sums;      // of four slots
  vtkOITTextureArray Histogram; // adaptive only
  vtkOITTextureArray BucketBounds;
  vtkOITFramebuffer GatherFramebuffer;
  vtkOITFramebuffer ScreenFramebuffer;
  vtkOITScreenStage EqualizeStage;
  vtkOITScreenStage SlotsStage;
  vtkOITScreenStage ResolveStage;
};

#endif
