// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITMinMaxPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/GL/vtkOITOverBlending.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITFragmentFS.h"
#include "vtkOITMinMaxGatherFS.h"
#include "vtkOITMinMaxResolveFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
constexpr int DepthsBuffer = 1; // where coincident fragments are blended
}

//------------------------------------------------------------------------------
std::string vtkOITMinMaxPeeler::FindMissing(
  const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const
{
  const std::string missing = vtkOITPeeler::FindMissing(capabilities, settings);
  return missing.empty() && !vtkOITPeelState::CanWorkInPlace(capabilities)
    ? FindMissingToBlend(capabilities, settings)
    : missing;
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  this->LastOnTop = settings.LastOnTop;
  this->InPlace = vtkOITPeelState::CanWorkInPlace(frame);
  vtkOITShaderText text({ vtkOITFragmentFS, vtkOITMinMaxGatherFS });
  text.Require({ "GL_ARB_explicit_attrib_location" });
  text.Define("OIT_DUAL", this->IsDual).Define("OIT_IN_PLACE", this->InPlace);
  text.Define("OIT_LAST_ON_TOP", this->LastOnTop);
  text.Define("OIT_CLAMP_COLOR", frame.Target.ClampsColor);
  if (this->InPlace)
  {
    text.Require({ "GL_EXT_shader_framebuffer_fetch", "GL_ARB_shader_image_load_store" });
    text.TestDepthEarly(); // reading the framebuffer would end it
  }
  if (this->Gather.SetStage(text))
  {
    this->Release();
  }
}

//------------------------------------------------------------------------------
vtkOITPeelState::Layout vtkOITMinMaxPeeler::GetLayout(const vtkOITFrame& frame) const
{
  vtkOITPeelState::Layout layout;
  layout.Layers = this->IsDual ? 4 : vtkOITPeelState::CanWorkInPlace(frame) ? 5 : 3;
  layout.HasBack = this->IsDual;
  return layout;
}

//------------------------------------------------------------------------------
int vtkOITMinMaxPeeler::GetBytesPerPixel(const vtkOITFrame& frame) const
{
  return this->GetNumberOfSums(vtkOITPeelState::CanWorkInPlace(frame)) *
    vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F);
}

//------------------------------------------------------------------------------
int vtkOITMinMaxPeeler::GetNumberOfSums(bool inPlace) const
{
  return this->IsDual ? (this->LastOnTop ? 3 : 4) : inPlace ? 0 : 2;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITMinMaxPeeler::Begin(const vtkOITPeelContext& context)
{
  const vtkOITPeelState& state = context.State;
  const int sums = this->GetNumberOfSums(this->InPlace);
  return sums > 0 ? this->Sums.Reserve(
                      context.Frame.Window, state.GetWidth(), state.GetHeight(), sums, GL_RGBA32F)
                  : vtkOITFailure();
}

//------------------------------------------------------------------------------
// What Gather reads are layers of the state; Resolve has emptied them.
vtkOITFailure vtkOITMinMaxPeeler::GatherInPlace(const vtkOITPeelContext& context, bool isSetUp)
{
  const vtkOITTextureArray& state = context.State.GetArray();
  if (vtkOITFailure failure = context.State.BindForGather(this->GatherFramebuffer,
        { state.GetLayer(OIT_STATE_BOUNDS), state.GetLayer(3), state.GetLayer(4) }, [] {}))
  {
    return failure;
  }
  if (isSetUp)
  {
    vtkOITFramebuffer::DrawInto(1); // depths only: no colours yet
  }
  context.Frame.GLState->vtkglDisable(GL_BLEND);
  return context.RenderGeometry();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITMinMaxPeeler::GatherByBlending(const vtkOITPeelContext& context, bool isSetUp)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  const int sums = this->Sums.GetNumberOfLayers();
  vtkOITFailure failure =
    context.State.BindForGather(this->GatherFramebuffer, this->Sums.GetAllLayers(),
      [this, sums]
      {
        const float nothing[4] = { 0.0f, 0.0f, 0.0f, this->LastOnTop ? 0.0f : -2.0f };
        for (int i = 0; i < sums; ++i)
        {
          glClearBufferfv(GL_COLOR, i, nothing);
        }
        const float noDepths[4] = { -2.0f, -2.0f, 0.0f, 0.0f };
        if (this->LastOnTop)
        {
          glClearBufferfv(GL_COLOR, DepthsBuffer, noDepths);
        }
      });
  if (failure)
  {
    return failure;
  }
  if (isSetUp)
  {
    vtkOITFramebuffer::DrawInto(2); // depths only: no colours yet
  }
  if (this->LastOnTop)
  {
    const vtkOITOverBlending blending(gl, DepthsBuffer);
    return context.RenderGeometry();
  }
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  return context.RenderGeometry();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITMinMaxPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  const bool isSetUp = number == 0;
  vtkOITFailure failure = this->InPlace ? this->GatherInPlace(context, isSetUp)
                                        : this->GatherByBlending(context, isSetUp);
  if (failure)
  {
    return failure;
  }
  return context.State.Resolve(
    this->ResolveStage,
    [this]
    {
      return vtkOITShaderText({ vtkOITMinMaxResolveFS })
        .Define("OIT_DUAL", this->IsDual)
        .Define("OIT_LAST_ON_TOP", this->LastOnTop);
    },
    [&](vtkShaderProgram* program)
    {
      if (program->IsUniformUsed("oitSums"))
      {
        this->Sums.Bind(context.Frame.GLState, OIT_UNIT_GATHERED);
        program->SetUniformi("oitSums", OIT_UNIT_GATHERED);
      }
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
    });
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::SetUniforms(
  vtkShaderProgram* program, vtkProp*, const vtkOITPeelContext& context)
{
  if (program->IsUniformUsed("oitState"))
  {
    context.State.BindFor(program);
  }
  program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Release()
{
  this->Sums.Release();
  this->GatherFramebuffer.Release();
  this->ResolveStage.Release();
}
