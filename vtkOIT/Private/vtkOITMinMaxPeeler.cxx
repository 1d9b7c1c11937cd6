// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITMinMaxPeeler.h"

#include "vtkOITCapabilities.h"
#include "vtkOITFrame.h"
#include "vtkOITShaderText.h"

#include "vtkOITFragmentFS.h"
#include "vtkOITPeelingGatherFS.h"
#include "vtkOITPeelingResolveFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
constexpr int DepthsUnit = vtkOITPeelState::GatheredUnit + 1;
}

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
int vtkOITMinMaxPeeler::GetNumberOfSumLayers(bool isJoint) const
{
  return isJoint ? (this->IsDual ? 4 : 2) : (this->IsDual ? 3 : 2);
}

//------------------------------------------------------------------------------
GLenum vtkOITMinMaxPeeler::GetSumFormat(bool isJoint) const
{
  return isJoint || this->HasFloatColor ? GL_RGBA32F : GL_RGBA32F;
}

//------------------------------------------------------------------------------
int vtkOITMinMaxPeeler::GetBytesPerPixel(const vtkOITFrame& frame) const
{
  const bool isJoint = !frame.Capabilities->SeparateBlending;
  return this->GetNumberOfSumLayers(isJoint) *
    vtkOITTextureArray::GetBytesPerTexel(this->GetSumFormat(isJoint)) +
    (isJoint ? 0 : vtkOITTextureArray::GetBytesPerTexel(GL_RG32F));
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Prepare(const vtkOITFrame& frame, bool hasFloatColor)
{
  this->HasFloatColor = hasFloatColor;
  const bool isJoint = !frame.Capabilities->SeparateBlending;
  if (isJoint != this->IsJoint || this->ShaderTime.GetMTime() == 0)
  {
    this->IsJoint = isJoint;
    this->ShaderTime.Modified();
    this->ResolveStage.Release();
    this->Depths.Release();
  }
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Begin(const vtkOITPeelContext& context)
{
  const vtkOITPeelState& state = context.State;
  const int width = state.GetWidth();
  const int height = state.GetHeight();
  this->Sums.Reserve(context.Frame.Window, width, height, this->GetNumberOfSumLayers(this->IsJoint),
    this->GetSumFormat(this->IsJoint));
  if (!this->IsJoint)
  {
    this->Depths.Reserve(context.Frame.Window, width, height, 1, GL_RG32F);
  }
  if (state.IsInPlace() != this->InPlace)
  {
    this->InPlace = state.IsInPlace();
    this->ResolveStage.Release();
  }
  this->IsRest = false;
}

//------------------------------------------------------------------------------
// Where each buffer may blend in its own way, depths have a buffer of their own, and sums may be
// half floats. Otherwise (GL 3.2) depths are the alpha of the sums.
void vtkOITMinMaxPeeler::BindForGather(const vtkOITPeelContext& context, bool isSetUp)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  std::vector<vtkOITAttachment> colors;
  if (!this->IsJoint)
  {
    colors.push_back(this->Depths.GetLayer(0));
  }
  for (int i = 0; i < this->Sums.GetNumberOfLayers(); ++i)
  {
    colors.push_back(this->Sums.GetLayer(i));
  }
  context.State.BindForGather(this->GatherFramebuffer, colors);
  const float noDepth[4] = { 0.0f, 0.0f, 0.0f, -2.0f };
  const float noDepths[4] = { -2.0f, -2.0f, 0.0f, 0.0f };
  const float noSums[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const float* separate = i == 0 ? noDepths : noSums;
    glClearBufferfv(GL_COLOR, static_cast<GLint>(i), this->IsJoint ? noDepth : separate);
  }
  if (isSetUp) // no colours yet
  {
    vtkOITFramebuffer::DrawInto(this->IsJoint ? 2 : 1);
  }
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  gl->vtkglBlendEquationSeparate(GL_FUNC_ADD, this->IsJoint ? GL_MAX : GL_FUNC_ADD);
  if (!this->IsJoint)
  {
    glBlendEquationi(0, GL_MAX);
  }
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  this->BindForGather(context, number == 0);
  context.RenderGeometry();
  if (!this->IsJoint)
  {
    glBlendEquationi(0, GL_FUNC_ADD); // as VTK's cache of the state has it
  }
  vtkOpenGLState* gl = context.Frame.GLState;
  context.State.Resolve(
    this->ResolveStage,
    [&] { return context.State.AssembleResolve(vtkOITPeelingResolveFS, this->GetDefinitions()); },
    [&](vtkShaderProgram* program)
    {
      this->Sums.Bind(gl, vtkOITPeelState::GatheredUnit);
      program->SetUniformi("oitSums", vtkOITPeelState::GatheredUnit);
      if (!this->IsJoint)
      {
        this->Depths.Bind(gl, DepthsUnit);
        program->SetUniformi("oitDepths", DepthsUnit);
      }
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
    });
  if (!this->IsJoint)
  {
    vtkOITTextureArray::Unbind(gl, DepthsUnit);
  }
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::PeelRest(const vtkOITPeelContext& context)
{
  this->IsRest = true;
  this->Peel(context, -1);
  this->IsRest = false;
}

//------------------------------------------------------------------------------
std::string vtkOITMinMaxPeeler::GetDefinitions() const
{
  return std::string(this->IsDual ? "#define OIT_DUAL\n" : "") +
    (this->IsJoint ? "#define OIT_JOINT_BLENDING\n" : "");
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
std::int64_t vtkOITMinMaxPeeler::GetSizeInBytes() const
{
  return this->Sums.GetSizeInBytes() + this->Depths.GetSizeInBytes();
}

//------------------------------------------------------------------------------
void vtkOITMinMaxPeeler::Release()
{
  this->Sums.Release();
  this->Depths.Release();
  this->GatherFramebuffer.Release();
  this->ResolveStage.Release();
}
