// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITABufferVolumes.h"

#include "Private/ABuffer/vtkOITFragmentStore.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "Private/Volume/vtkOITVolumes.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
/// Mappers copy the opaque depth from the framebuffer that is bound for reading.
void BeginVolumes(const vtkOITFrame& frame, const vtkOITFragmentStore& store)
{
  frame.BeginGeometry(store.GetRectangle());
  frame.GLState->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, frame.Target.Framebuffer);
}
}

//------------------------------------------------------------------------------
void vtkOITABufferVolumes::SetShaders(const vtkOITABufferShaders& shaders)
{
  this->Gather.SetStage([shaders](const std::string& shader) { return shaders.GetVolume(shader); });
}

//------------------------------------------------------------------------------
void vtkOITABufferVolumes::Draw(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store, float threshold)
{
  const bool isAlone = frame.Volumes->IsAlone();
  if (frame.Target.Samples > 0 && !isAlone)
  {
    this->Failure = frame.Volumes->Refuse(
      "the framebuffer is multisampled, and there are several volumes, or one in blocks; call "
      "SetMultiSamples(0) of the render window");
    return;
  }
  this->Gather.SetUniforms(
    [&store, threshold, isAlone](vtkShaderProgram* program)
    {
      store.SetUniforms(program);
      program->SetUniformf("oitThreshold", threshold);
      program->SetUniformi("oitIsAlone", isAlone ? 1 : 0);
    });
  BeginVolumes(frame, store);
  this->Failure = frame.Volumes->Draw(this->Gather);
  this->Gather.SetUniforms({});
}

//------------------------------------------------------------------------------
void vtkOITABufferVolumes::DrawFailed(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store, vtkOITStatistics& statistics) const
{
  if (this->Failure)
  {
    BeginVolumes(frame, store);
    frame.Volumes->DrawPlainly(frame.Volumes->GetFailed());
    statistics.NoteWarning(
      "A volume is drawn over the translucent props that it overlaps: " + this->Failure.GetReason());
  }
}
