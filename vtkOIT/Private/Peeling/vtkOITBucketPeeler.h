// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITBucketPeeler_h
#define vtkOITBucketPeeler_h

#include "Private/Frame/vtkOITEyeDepthInterval.h"
#include "Private/Peeling/vtkOITPeeler.h"

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

  std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  int GetNumberOfSetUpPeels() const override { return this->HasExactRange ? 1 : 0; }
  void Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings) override;
  vtkOITPeelState::Layout GetLayout(const vtkOITFrame& frame) const override;
  int GetBytesPerPixel(const vtkOITFrame& frame) const override;
  std::int64_t GetSizeInBytes() const override;

  vtkOITFailure Begin(const vtkOITPeelContext& context) override;
  vtkOITFailure Peel(const vtkOITPeelContext& context, int number) override;
  vtkOITFailure PeelRest(const vtkOITPeelContext& context) override;

  vtkOITGather& GetGather() override
  {
    return this->IsHistogram ? this->HistogramGather : this->Gather;
  }
  void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) override;
  void Release() override;

private:
  void AddDivision(vtkOITShaderText& text) const;
  vtkOITShaderText MakeGather(const char* file) const;
  vtkOITFailure GatherHistogram(const vtkOITPeelContext& context);
  vtkOITFailure GatherDepths(const vtkOITPeelContext& context);
  vtkOITFailure GatherColors(const vtkOITPeelContext& context, int slotLayer, bool isLast);
  vtkOITFailure GatherColorsOfAll(const vtkOITPeelContext& context);
  vtkOITFailure DrawLayers(const vtkOITPeelContext& context, vtkOITTextureArray& layers,
    vtkOITScreenStage& stage, const char* text, const char* sampler,
    const vtkOITTextureArray& source);
  vtkOITFailure EmptySlots(const vtkOITPeelContext& context);

  Division UsedDivision = Division::Uniform;
  // The first peel starts from the exact depth range of each pixel, found by a geometry pass.
  bool HasExactRange = false;
  bool LastOnTop = false;
  // One peel of all 32 slots; what it does not capture is counted as lost.
  bool IsSingleShot = false;
  bool InPlace = false; // of ResolveStage's program
  // A mapper's shader has either integer outputs or floats.
  vtkOITGather Gather;
  vtkOITGather HistogramGather;
  bool IsHistogram = false; // the one that draws
  vtkOITEyeDepthInterval Interval;

  // Of the geometry pass.
  bool IsColorStage = false;
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
