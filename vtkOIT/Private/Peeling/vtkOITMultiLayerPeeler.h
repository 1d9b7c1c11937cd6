// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITMultiLayerPeeler_h
#define vtkOITMultiLayerPeeler_h

#include "Private/Peeling/vtkOITPeeler.h"

#include <map>
#include <utility>
#include <vector>

/**
 * Several layers a peel, by insertion sort in the fragment shader (Liu, Wei and Xu 2006). How the
 * shader may read and write the slots of its pixel is one of three ways.
 */
class vtkOITMultiLayerPeeler : public vtkOITPeeler
{
public:
  enum class Access
  {
    Fetch,     // the slots are colour buffers that the shader reads
    Interlock, // images, in a section that fragments of a pixel enter one by one
    Barrier    // colour buffers that the shader reads as a texture, again and again
  };

  std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  bool UsesStorage(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  void Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings) override;
  vtkOITPeelState::Layout GetLayout(const vtkOITFrame& frame) const override;
  int GetBytesPerPixel(const vtkOITFrame& frame) const override;
  std::int64_t GetSizeInBytes() const override { return this->Slots.GetSizeInBytes(); }
  bool CanCullProps() const override { return this->UsedAccess != Access::Barrier; }

  vtkOITFailure Begin(const vtkOITPeelContext& context) override;
  vtkOITFailure Peel(const vtkOITPeelContext& context, int number) override;

  vtkOITGather& GetGather() override { return this->Gather; }
  void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) override;
  void Release() override;

private:
  /// Two layers share a buffer.
  bool HasPairs() const { return this->NumberOfLayers > 8; }
  int GetNumberOfSlots() const;
  void AddVariant(vtkOITShaderText& text) const;
  vtkOITFailure RenderGeometry(const vtkOITPeelContext& context);
  vtkOITFailure GatherUnordered(const vtkOITPeelContext& context);

  int NumberOfLayers = 8; // a peel: 4, 8 or 16
  Access UsedAccess = Access::Fetch;
  bool LastOnTop = false;
  bool InPlace = false; // of ResolveStage's program
  vtkOITGather Gather;

  vtkOITTextureArray Slots;
  vtkOITFramebuffer GatherFramebuffer;
  vtkOITFramebuffer ImageFramebuffer; // without colours, for the interlock
  vtkOITScreenStage ResolveStage;
  vtkOITOcclusionQueries Changes;

  // The number of a draw, the same in each peel of a frame: by prop and how often it was drawn.
  std::map<std::pair<vtkProp*, int>, int> DrawNumbers;
  std::map<vtkProp*, int> Draws; // in this geometry pass
};

#endif
