// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDualPeeler_h
#define vtkOITDualPeeler_h

#include "Private/GL/vtkOITOutput.h"
#include "Private/Peeling/vtkOITPeeler.h"

/**
 * Dual depth peeling (Bavoil and Myers 2008) where shaders can read the framebuffer: a peel keeps
 * the fragments of the nearest and of the farthest layers themselves, by insertion, instead of
 * finding out their depths for the next one. So there is no peel that only prepares, and when the
 * first one has all layers, it is composited without any state from peel to peel.
 *
 * As few layers as take all in one peel, because a layer costs a buffer that each fragment reads
 * and writes; as many as there can be when one peel is not enough. More at once, fewer only when
 * some frames agree: other shaders are looked up for it.
 */
class vtkOITDualPeeler : public vtkOITPeeler
{
public:
  /// Layers from each side that a peel can keep: GL has eight colour buffers.
  static constexpr int MostLayersPerSide = 3;

  void Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings) override;
  vtkOITPeelState::Layout GetLayout(const vtkOITFrame& frame) const override;
  int GetBytesPerPixel(const vtkOITFrame& frame) const override;
  std::int64_t GetSizeInBytes() const override { return this->Layers.GetSizeInBytes(); }

  vtkOITFailure Begin(const vtkOITPeelContext& context) override;
  vtkOITFailure Peel(const vtkOITPeelContext& context, int number) override;
  bool HasAll() const override { return this->FirstHasAll; }
  vtkOITFailure Composite(const vtkOITPeelContext& context) override;
  bool Note(const vtkOITStatistics& statistics) override;

  vtkOITGather& GetGather() override { return this->Gathering; }
  void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) override;
  void Release() override;

private:
  int GetNumberOfLayers() const { return 2 * this->LayersPerSide; }
  int GetNumberOfBuffers() const { return this->GetNumberOfLayers() * (this->FloatColor ? 2 : 1); }
  void AddLayers(vtkOITShaderText& text) const;
  vtkOITShaderText MakeReader(const char* file) const;
  void BindLayers(vtkShaderProgram* program, const vtkOITPeelContext& context) const;
  vtkOITFailure Gather(const vtkOITPeelContext& context);
  vtkOITFailure Resolve(const vtkOITPeelContext& context);

  int WantedLayersPerSide = MostLayersPerSide;
  int FramesWithFewer = 0; // in a row, that had layers for fewer
  int LayersPerSide = 0;   // of the shaders, as all below; 1 with float colours
  bool FloatColor = false;
  vtkOITGather Gathering;

  bool IsFirst = true;
  bool FirstHasAll = false;

  vtkOITTextureArray Layers;
  vtkOITFramebuffer GatherFramebuffer;
  vtkOITScreenStage ResolveStage;
  vtkOITOutputStage CompositeStage;
};

#endif
