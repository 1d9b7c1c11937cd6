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
  // From the back, nothing else rejects what was peeled; from the front alone, the nearer ones.
  layout.Side = this->IsDual ? vtkOITPeelState::MaskSide::Back : vtkOITPeelState::MaskSide::Front;
  return layout;
}

//------------------------------------------------------------------------------
int vtkOITMinMaxPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  return this->GetNumberOfLayers() * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F);
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Begin(const vtkOITPeelContext& context)
{
  const vtkOITPeelState& state = context.State;
  this->Gathered.Reserve(context.Frame.Window, state.GetWidth(), state.GetHeight(),
    this->GetNumberOfLayers(), GL_RGBA32F);
  if (state.IsInPlace() != this->InPlace)
  {
    this->InPlace = state.IsInPlace();
    this->ResolveStage.Release();
  }
  this->IsRest = false;
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Peel(const vtkOITPeelContext& context, int)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  const int layers = this->GetNumberOfLayers();
  context.State.BindForGather(this->GatherFramebuffer, &this->Gathered, 0, layers);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, -2.0f };
  for (int i = 0; i < layers; ++i)
  {
    glClearBufferfv(GL_COLOR, i, nothing);
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
      this->Gathered.Bind(gl, vtkOITPeelState::GatheredUnit);
      program->SetUniformi("oitGathered", vtkOITPeelState::GatheredUnit);
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
  this->Gathered.Release();
  this->GatherFramebuffer.Release();
  this->ResolveStage.Release();
}
