// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITDeferredPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITDeferredLightFS.h"
#include "vtkOITDeferredPeelGatherFS.h"
#include "vtkOITDeferredPeelResolveFS.h"
#include "vtkOITFragmentFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
constexpr int NumberOfSums = 6;
}

//------------------------------------------------------------------------------
void vtkOITDeferredPeeler::Prepare(const vtkOITFrame& frame, const vtkOITSettings&)
{
  this->HasLights = !this->Lights.Update(frame) && this->Lights.GetNumberOfLights() > 0;
  vtkOITShaderText text({ vtkOITFragmentFS, vtkOITDeferredPeelGatherFS });
  text.Require({ "GL_ARB_explicit_attrib_location" });
  text.Define("OIT_CLAMP_COLOR", frame.Target.ClampsColor);
  text.Define("OIT_HAS_LIGHTS", this->HasLights); // for mappers to make their shaders anew
  this->ClampsColor = frame.Target.ClampsColor;
  this->Gather.SetReplacements(this->HasLights ? &this->Text : nullptr);
  if (this->Gather.SetStage(text))
  {
    this->Sums.Release();
    this->GatherFramebuffer.Release();
    for (vtkOITScreenStage& stage : this->ResolveStages)
    {
      stage.Release();
    }
  }
}

//------------------------------------------------------------------------------
int vtkOITDeferredPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  return NumberOfSums * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITDeferredPeeler::GetSizeInBytes() const
{
  return this->Sums.GetSizeInBytes() + this->Lights.GetSizeInBytes();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDeferredPeeler::Begin(const vtkOITPeelContext& context)
{
  return this->Sums.Reserve(context.Frame.Window, context.State.GetWidth(),
    context.State.GetHeight(), NumberOfSums, GL_RGBA32F);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDeferredPeeler::GatherLayer(const vtkOITPeelContext& context)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  vtkOITFailure failure =
    context.State.BindForGather(this->GatherFramebuffer, this->Sums.GetAllLayers(),
      []
      {
        const float nothing[4] = { 0.0f, 0.0f, 0.0f, -2.0f };
        for (int i = 0; i < NumberOfSums; ++i)
        {
          glClearBufferfv(GL_COLOR, i, nothing);
        }
      });
  if (failure)
  {
    return failure;
  }
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->HasSpecular = false;
  return context.RenderGeometry();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDeferredPeeler::Peel(const vtkOITPeelContext& context, int)
{
  if (vtkOITFailure failure = this->GatherLayer(context))
  {
    return failure;
  }
  vtkOpenGLState* gl = context.Frame.GLState;
  const bool hasSpecular = this->HasSpecular;
  vtkOITFailure failure = context.State.Resolve(
    this->ResolveStages[hasSpecular ? 1 : 0],
    [&]
    {
      return vtkOITShaderText({ vtkOITDeferredPeelResolveFS })
        .Define("OIT_HAS_SPECULAR", hasSpecular)
        .Define("OIT_CLAMP_COLOR", this->ClampsColor)
        .Insert("Light", vtkOITDeferredLightFS);
    },
    [&](vtkShaderProgram* program)
    {
      this->Sums.Bind(gl, OIT_UNIT_GATHERED);
      program->SetUniformi("oitSums", OIT_UNIT_GATHERED);
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
      this->Lights.Bind(gl, OIT_UNIT_LIGHTS);
      this->Lights.SetUniforms(
        program, context.Frame, OIT_UNIT_LIGHTS, context.State.GetX(), context.State.GetY());
    });
  this->Lights.Unbind(gl, OIT_UNIT_LIGHTS);
  return failure;
}

//------------------------------------------------------------------------------
void vtkOITDeferredPeeler::SetUniforms(
  vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context)
{
  context.State.BindFor(program);
  program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
  this->HasSpecular = this->HasSpecular || vtkOITDeferredText::IsReflecting(prop);
}

//------------------------------------------------------------------------------
void vtkOITDeferredPeeler::Release()
{
  this->Lights.Release();
  this->Sums.Release();
  this->GatherFramebuffer.Release();
  for (vtkOITScreenStage& stage : this->ResolveStages)
  {
    stage.Release();
  }
}
