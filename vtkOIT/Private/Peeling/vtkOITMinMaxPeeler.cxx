// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITMinMaxPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOITFragmentFS.h"
#include "vtkOITMinMaxGatherFS.h"
#include "vtkOITMinMaxResolveFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Prepare(const vtkOITFrame& frame, bool)
{
  const bool inPlace = vtkOITPeelState::CanWorkInPlace(frame);
  if (inPlace != this->InPlace || this->ShaderTime.GetMTime() == 0)
  {
    this->InPlace = inPlace;
    this->ShaderTime.Modified();
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
  return this->IsDual ? 4 : inPlace ? 0 : 2;
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Begin(const vtkOITPeelContext& context)
{
  const vtkOITPeelState& state = context.State;
  const int sums = this->GetNumberOfSums(this->InPlace);
  if (sums > 0)
  {
    this->Sums.Reserve(context.Frame.Window, state.GetWidth(), state.GetHeight(), sums, GL_RGBA32F);
  }
  this->IsRest = false;
}

//------------------------------------------------------------------------------
// What Gather reads are layers of the state; Resolve has emptied them.
void vtkOITMinMaxPeeler::GatherInPlace(const vtkOITPeelContext& context, bool isSetUp)
{
  const vtkOITTextureArray& state = context.State.GetArray();
  context.State.BindForGather(
    this->GatherFramebuffer, { state.GetLayer(2), state.GetLayer(3), state.GetLayer(4) }, [] {});
  if (isSetUp)
  {
    vtkOITFramebuffer::DrawInto(1); // depths only: no colours yet
  }
  context.Frame.GLState->vtkglDisable(GL_BLEND);
  context.RenderGeometry();
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::GatherByBlending(const vtkOITPeelContext& context, bool isSetUp)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  const int sums = this->Sums.GetNumberOfLayers();
  context.State.BindForGather(this->GatherFramebuffer, this->Sums.GetAllLayers(),
    [sums]
    {
      const float nothing[4] = { 0.0f, 0.0f, 0.0f, -2.0f };
      for (int i = 0; i < sums; ++i)
      {
        glClearBufferfv(GL_COLOR, i, nothing);
      }
    });
  if (isSetUp)
  {
    vtkOITFramebuffer::DrawInto(2); // depths only: no colours yet
  }
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  context.RenderGeometry();
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  const bool isSetUp = number == 0;
  if (this->InPlace)
  {
    this->GatherInPlace(context, isSetUp);
  }
  else
  {
    this->GatherByBlending(context, isSetUp);
  }
  context.State.Resolve(
    this->ResolveStage,
    [&] { return context.State.AssembleResolve(vtkOITMinMaxResolveFS, this->GetDefinitions()); },
    [&](vtkShaderProgram* program)
    {
      if (program->IsUniformUsed("oitSums"))
      {
        this->Sums.Bind(context.Frame.GLState, vtkOITPeelState::GatheredUnit);
        program->SetUniformi("oitSums", vtkOITPeelState::GatheredUnit);
      }
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
  if (this->InPlace)
  {
    header = vtkOITRequireExtensions(
               { "GL_EXT_shader_framebuffer_fetch", "GL_ARB_shader_image_load_store" }) +
      header + "#define OIT_IN_PLACE\n";
  }
  if (vtkOITWritesDepth(fragmentShader))
  {
    header += "#define OIT_WRITES_DEPTH\n";
  }
  else if (this->InPlace)
  {
    header += "layout(early_fragment_tests) in;\n"; // reading the framebuffer would end it
  }
  return vtkOITWrapFragmentShader(
    fragmentShader, header, std::string(vtkOITFragmentFS) + vtkOITMinMaxGatherFS);
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
