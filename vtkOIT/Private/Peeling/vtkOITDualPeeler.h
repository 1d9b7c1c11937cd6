// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDualPeeler_h
#define vtkOITDualPeeler_h

#include "Private/GL/vtkOITOutput.h"
#include "Private/Peeling/vtkOITPeeler.h"
#include "vtkTimeStamp.h"

/**
 * Dual depth peeling (Bavoil and Myers 2008) where shaders can read the framebuffer: a peel keeps
 * the fragments of the nearest and of the farthest layers themselves, by insertion, instead of
 * finding out their depths for the next one. So there is no peel that only prepares, and when the
 * first one has all layers, it is composited without any state from peel to peel.
 */
class vtkOITDualPeeler : public vtkOITPeeler
{
public:
  /// Layers from each side that a peel can keep: GL has eight colour buffers.
  static constexpr int MostLayersPerSide = 3;

  /// At least 1; with float colours it is 1.
  void SetLayersPerSide(int layers) { this->WantedLayersPerSide = layers; }

  void Prepare(const vtkOITFrame& frame, bool hasFloatColor) override;
  vtkOITPeelState::Layout GetLayout(const vtkOITFrame& frame) const override;
  int GetBytesPerPixel(const vtkOITFrame& frame) const override;
  std::int64_t GetSizeInBytes() const override { return this->Layers.GetSizeInBytes(); }

  void Begin(const vtkOITPeelContext& context) override;
  void Peel(const vtkOITPeelContext& context, int number) override;
  void PeelRest(const vtkOITPeelContext& context) override;
  bool HasAll() const override { return this->FirstHasAll; }
  void Composite(const vtkOITPeelContext& context) override;

  bool WrapGather(std::string& fragmentShader) const override;
  void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) override;
  vtkMTimeType GetShaderMTime() const override { return this->ShaderTime.GetMTime(); }

  void Release() override;

private:
  int GetNumberOfLayers() const { return 2 * this->LayersPerSide; }
  int GetNumberOfBuffers() const { return this->GetNumberOfLayers() * (this->FloatColor ? 2 : 1); }
  std::string GetDefinitions() const;
  void AddLayers(std::string& stage) const;
  void Gather(const vtkOITPeelContext& context);
  void Resolve(const vtkOITPeelContext& context);

  int WantedLayersPerSide = MostLayersPerSide;
  int LayersPerSide = 0; // of the shaders, as all below
  bool FloatColor = false;
  vtkTimeStamp ShaderTime;

  bool IsFirst = true;
  bool IsRest = false;
  bool FirstHasAll = false;

  vtkOITTextureArray Layers;
  vtkOITFramebuffer GatherFramebuffer;
  vtkOITScreenStage ResolveStage;
  vtkOITOutputStage CompositeStage;
};

#endif
