// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITDualPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITDualCompositeFS.h"
#include "vtkOITDualGatherFS.h"
#include "vtkOITDualLayersFS.h"
#include "vtkOITDualResolveFS.h"
#include "vtkOITFragmentFS.h"
#include "vtkOITHalfFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Frames in a row that need fewer layers a side, before there are fewer.
constexpr int FramesToAgree = 3;
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  this->FloatColor = settings.FloatColor;
  this->LayersPerSide = this->FloatColor ? 1 : this->WantedLayersPerSide;
  const int layers = this->GetNumberOfLayers();
  vtkOITShaderText text({ vtkOITFragmentFS, "//VTK::OIT::Layers\n", vtkOITDualGatherFS });
  text.Require({ "GL_ARB_explicit_attrib_location", "GL_EXT_shader_framebuffer_fetch",
    "GL_ARB_shader_image_load_store" });
  text.TestDepthEarly(); // reading the framebuffer would end it
  text.Define("OIT_CLAMP_COLOR", frame.Target.ClampsColor);
  text.Define("OIT_LAST_ON_TOP", settings.LastOnTop);
  this->AddLayers(text);
  text.InsertRepeated("LayerBuffers", "OIT_LAYER_BUFFER", layers);
  text.InsertRepeated("StoreLayers", "OIT_STORE_LAYER", layers);
  if (this->Gathering.SetStage(text))
  {
    this->Release();
  }
}

//------------------------------------------------------------------------------
bool vtkOITDualPeeler::Note(const vtkOITStatistics& statistics)
{
  if (this->FloatColor)
  {
    return false;
  }
  const int wanted =
    std::min((std::max(statistics.MaximumDepthComplexity, 1) + 1) / 2, MostLayersPerSide);
  this->FramesWithFewer = wanted < this->LayersPerSide ? this->FramesWithFewer + 1 : 0;
  if (wanted <= this->LayersPerSide && this->FramesWithFewer < FramesToAgree)
  {
    return false;
  }
  this->WantedLayersPerSide = wanted;
  this->FramesWithFewer = 0;
  return true;
}

//------------------------------------------------------------------------------
vtkOITPeelState::Layout vtkOITDualPeeler::GetLayout(const vtkOITFrame&) const
{
  vtkOITPeelState::Layout layout;
  layout.Layers = 4;
  layout.HasBack = true;
  layout.StartsInResolve = true;
  return layout;
}

//------------------------------------------------------------------------------
int vtkOITDualPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  return this->GetNumberOfBuffers() * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32UI);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDualPeeler::Begin(const vtkOITPeelContext& context)
{
  this->FirstHasAll = false;
  return this->Layers.Reserve(context.Frame.Window, context.State.GetWidth(),
    context.State.GetHeight(), this->GetNumberOfBuffers(), GL_RGBA32UI);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDualPeeler::Gather(const vtkOITPeelContext& context)
{
  std::vector<vtkOITAttachment> colors = this->Layers.GetAllLayers();
  colors.push_back(
    context.State.GetArray().GetLayer(this->IsFirst ? OIT_STATE_STATISTICS : OIT_STATE_BOUNDS));
  vtkOITFailure failure = context.State.BindForGather(this->GatherFramebuffer, colors,
    [this]
    {
      const GLuint noNear[4] = { OIT_NO_NEAR, 0, 0, 0 };
      const GLuint noFar[4] = { OIT_NO_FAR, 0, 0, 0 };
      for (int i = 0; i < this->GetNumberOfLayers(); ++i)
      {
        // What those of float colours hold is used only where there is a key.
        glClearBufferuiv(GL_COLOR, i, i < this->LayersPerSide ? noNear : noFar);
      }
    });
  if (failure)
  {
    return failure;
  }
  context.Frame.GLState->vtkglDisable(GL_BLEND);
  if (this->IsFirst)
  {
    return context.RenderGeometry();
  }
  // Bounds are only read. VTK compares the mask of the first buffer with what it knows.
  const auto bounds = static_cast<GLuint>(this->GetNumberOfBuffers());
  glColorMaski(bounds, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  failure = context.RenderGeometry();
  glColorMaski(bounds, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return failure;
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::AddLayers(vtkOITShaderText& text) const
{
  text.Require({ "GL_ARB_shader_bit_encoding" });
  text.Define("OIT_SIDE", this->LayersPerSide).Define("OIT_BUFFERS", this->GetNumberOfBuffers());
  text.Define("OIT_FLOAT_COLOR", this->FloatColor);
  text.Insert("Layers", std::string(vtkOITHalfFS) + vtkOITDualLayersFS);
  text.InsertRepeated("LoadLayers", "OIT_LOAD_LAYER", this->GetNumberOfLayers());
}

//------------------------------------------------------------------------------
// A stage on the screen that reads the layers.
vtkOITShaderText vtkOITDualPeeler::MakeReader(const char* file) const
{
  vtkOITShaderText text({ file });
  this->AddLayers(text);
  return text.Define("OIT_READ_LAYERS");
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::BindLayers(vtkShaderProgram* program, const vtkOITPeelContext& context) const
{
  this->Layers.Bind(context.Frame.GLState, OIT_UNIT_GATHERED);
  program->SetUniformi("oitLayers", OIT_UNIT_GATHERED);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDualPeeler::Resolve(const vtkOITPeelContext& context)
{
  return context.State.Resolve(
    this->ResolveStage, [this] { return this->MakeReader(vtkOITDualResolveFS); },
    [&](vtkShaderProgram* program)
    {
      this->BindLayers(program, context);
      program->SetUniformi("oitFirst", this->IsFirst ? 1 : 0);
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
    });
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDualPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  this->IsFirst = number == 0;
  vtkOITFailure failure = this->Gather(context);
  this->FirstHasAll = false;
  if (!failure && this->IsFirst && context.ExpectsAll)
  {
    failure = context.State.IsFirstPeelComplete(this->FirstHasAll);
  }
  return failure || this->FirstHasAll ? failure : this->Resolve(context);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDualPeeler::Composite(const vtkOITPeelContext& context)
{
  return context.State.Composite(
    this->CompositeStage, [this] { return this->MakeReader(vtkOITDualCompositeFS); },
    [&](vtkShaderProgram* program) { this->BindLayers(program, context); });
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::SetUniforms(vtkShaderProgram* program, vtkProp*, const vtkOITPeelContext&)
{
  program->SetUniformi("oitFirst", this->IsFirst ? 1 : 0);
  program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::Release()
{
  this->Layers.Release();
  this->GatherFramebuffer.Release();
  this->ResolveStage.Release();
  this->CompositeStage.Release();
}
