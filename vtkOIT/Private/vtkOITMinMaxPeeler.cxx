// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITMinMaxPeeler.h"

#include "vtkOITFrame.h"
#include "vtkOITShaderText.h"

#include "vtkOITFragmentFS.h"
#include "vtkOITPeelingGatherFS.h"
#include "vtkOITPeelingResolveFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkOITPeelState::Layout vtkOITMinMaxPeeler::GetLayout(const vtkOITFrame&) const
{
  vtkOITPeelState::Layout layout;
  layout.Layers = this->IsDual ? 4 : 3;
  layout.HasBack = this->IsDual;
  return layout;
}

//------------------------------------------------------------------------------
// The sides take turns, so that props which are peeled from the front and props which are peeled
// from the back are both found out.
vtkOITPeelState::MaskSide vtkOITMinMaxPeeler::GetMaskSide(int number) const
{
  return this->IsDual && number % 2 == 0 ? vtkOITPeelState::MaskSide::Back
                                         : vtkOITPeelState::MaskSide::Front;
}

//------------------------------------------------------------------------------
int vtkOITMinMaxPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  return this->GetNumberOfSums() * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F);
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Begin(const vtkOITPeelContext& context)
{
  const vtkOITPeelState& state = context.State;
  this->Sums.Reserve(
    context.Frame.Window, state.GetWidth(), state.GetHeight(), this->GetNumberOfSums(), GL_RGBA32F);
  if (state.IsInPlace() != this->InPlace)
  {
    this->InPlace = state.IsInPlace();
    this->ResolveStage.Release();
  }
  this->IsRest = false;
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  const int sums = this->GetNumberOfSums();
  context.State.BindForGather(this->GatherFramebuffer, this->Sums.GetAllLayers(),
    [sums]
    {
      const float nothing[4] = { 0.0f, 0.0f, 0.0f, -2.0f };
      for (int i = 0; i < sums; ++i)
      {
        glClearBufferfv(GL_COLOR, i, nothing);
      }
    });
  if (number == 0)
  {
    vtkOITFramebuffer::DrawInto(2); // depths only: no colours yet
  }
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  context.RenderGeometry();
  context.State.Resolve(
    this->ResolveStage,
    [&] { return context.State.AssembleResolve(vtkOITPeelingResolveFS, this->GetDefinitions()); },
    [&](vtkShaderProgram* program)
    {
      this->Sums.Bind(gl, vtkOITPeelState::GatheredUnit);
      program->SetUniformi("oitSums", vtkOITPeelState::GatheredUnit);
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
    });
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::PeelRest(const vtkOITPeelContext& context)
{
  this->IsRest = true;
  this->Peel(context, -1);
  this->IsRest = false;
}

//------------------------------------------------------------------------------
bool vtkOITMinMaxPeeler::WrapGather(std::string& fragmentShader) const
{
  std::string header =
    vtkOITRequireExtensions({ "GL_ARB_explicit_attrib_location" }) + this->GetDefinitions();
  if (vtkOITWritesDepth(fragmentShader))
  {
    header += "#define OIT_WRITES_DEPTH\n";
  }
  return vtkOITWrapFragmentShader(
    fragmentShader, header, std::string(vtkOITFragmentFS) + vtkOITPeelingGatherFS);
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::SetUniforms(vtkShaderProgram* program, const vtkOITPeelContext& context)
{
  context.State.BindFor(program);
  program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Release()
{
  this->Sums.Release();
  this->GatherFramebuffer.Release();
  this->ResolveStage.Release();
}
