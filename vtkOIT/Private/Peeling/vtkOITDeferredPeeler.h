// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDeferredPeeler_h
#define vtkOITDeferredPeeler_h

#include "Private/Deferred/vtkOITDeferredText.h"
#include "Private/Deferred/vtkOITLights.h"
#include "Private/Peeling/vtkOITPeeler.h"

/**
 * Deferred depth peeling: each geometry pass has the nearest layer that is left as a G-buffer, of
 * materials instead of shaded colours, and finds the bounds of the next one; a stage on pixels lights it
 * and blends it under those in front. Positions are those of depths. Coincident fragments are one
 * material; the order of drawing is not kept.
 *
 * Floats in six buffers, 96 bytes a pixel, as sums of half floats would not be exact.
 */
class vtkOITDeferredPeeler : public vtkOITPeeler
{
public:
  int GetNumberOfSetUpPeels() const override { return 1; }
  void Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings) override;
  vtkOITPeelState::Layout GetLayout(const vtkOITFrame&) const override { return {}; }
  int GetBytesPerPixel(const vtkOITFrame& frame) const override;
  std::int64_t GetSizeInBytes() const override;

  vtkOITFailure Begin(const vtkOITPeelContext& context) override;
  vtkOITFailure Peel(const vtkOITPeelContext& context, int number) override;

  vtkOITGather& GetGather() override { return this->Gather; }
  void SetUniforms(
    vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context) override;

  void Release() override;

private:
  vtkOITFailure GatherLayer(const vtkOITPeelContext& context);

  vtkOITDeferredText Text;
  vtkOITLights Lights;
  bool HasLights = false;   // otherwise mappers light
  bool HasSpecular = false; // a material of this frame reflects lights
  bool ClampsColor = false;
  vtkOITGather Gather;
  vtkOITTextureArray Sums;
  vtkOITFramebuffer GatherFramebuffer;
  std::array<vtkOITScreenStage, 2> ResolveStages; // without and with specular light
};

#endif
