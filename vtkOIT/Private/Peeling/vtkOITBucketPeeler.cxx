// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITBucketPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/GL/vtkOITOverBlending.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITBucketDepthFS.h"
#include "vtkOITBucketGatherFS.h"
#include "vtkOITBucketResolveFS.h"
#include "vtkOITFragmentFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
constexpr int LayersOfState = 6;
}

//------------------------------------------------------------------------------
std::string vtkOITBucketPeeler::FindMissing(
  const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const
{
  const std::string missing = vtkOITPeeler::FindMissing(capabilities, settings);
  return missing.empty() ? FindMissingToBlend(capabilities, settings) : missing;
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  const bool isAdaptive = settings.BucketMode == 2;
  const bool inPlace = vtkOITPeelState::CanWorkInPlace(frame);
  const bool isOther = this->InPlace != inPlace || this->IsAdaptive != isAdaptive;
  this->IsAdaptive = isAdaptive;
  this->LastOnTop = settings.LastOnTop;
  this->Interval = vtkOITEyeDepthInterval::Find(frame);
  vtkOITShaderText text({ vtkOITFragmentFS, vtkOITBucketGatherFS });
  text.Require({ "GL_ARB_explicit_attrib_location" });
  text.Define("OIT_LAST_ON_TOP", this->LastOnTop);
  text.Define("OIT_CLAMP_COLOR", frame.Target.ClampsColor);
  if (this->Gather.SetStage(text) || isOther)
  {
    this->Release();
    this->InPlace = inPlace;
  }
}

//------------------------------------------------------------------------------
vtkOITPeelState::Layout vtkOITBucketPeeler::GetLayout(const vtkOITFrame&) const
{
  vtkOITPeelState::Layout layout;
  layout.Layers = LayersOfState;
  layout.HasBack = true;
  layout.MasksBack = false; // most are peeled from the front
  return layout;
}

//------------------------------------------------------------------------------
int vtkOITBucketPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  return this->GetNumberOfSums() * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketPeeler::Begin(const vtkOITPeelContext& context)
{
  return this->Sums.Reserve(context.Frame.Window, context.State.GetWidth(),
    context.State.GetHeight(), this->GetNumberOfSums(), GL_RGBA32F);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketPeeler::GatherSums(const vtkOITPeelContext& context)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  vtkOITFailure failure =
    context.State.BindForGather(this->GatherFramebuffer, this->Sums.GetAllLayers(),
      [this]
      {
        const float nothing[4] = { 0.0f, 0.0f, 0.0f, this->LastOnTop ? 0.0f : -2.0f };
        for (int i = 0; i < this->GetNumberOfSums(); ++i)
        {
          glClearBufferfv(GL_COLOR, i, nothing);
        }
        const float noDepths[4] = { -2.0f, -2.0f, 0.0f, 0.0f };
        if (this->LastOnTop)
        {
          glClearBufferfv(GL_COLOR, OIT_BUCKET_DEPTHS, noDepths);
        }
      });
  if (failure)
  {
    return failure;
  }
  if (this->LastOnTop)
  {
    const vtkOITOverBlending blending(gl, OIT_BUCKET_DEPTHS);
    return context.RenderGeometry();
  }
  if (this->IsFirst)
  {
    vtkOITFramebuffer::DrawInto(2); // one bucket, and no colours yet
  }
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  return context.RenderGeometry();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  this->IsFirst = number == 0;
  if (vtkOITFailure failure = this->GatherSums(context))
  {
    return failure;
  }
  return context.State.Resolve(
    this->ResolveStage,
    [this]
    {
      vtkOITShaderText text({ vtkOITBucketResolveFS });
      text.Define("OIT_LAST_ON_TOP", this->LastOnTop).Define("OIT_ADAPTIVE", this->IsAdaptive);
      return text.Insert("Depth", vtkOITBucketDepthFS);
    },
    [&](vtkShaderProgram* program)
    {
      this->Sums.Bind(context.Frame.GLState, OIT_UNIT_GATHERED);
      program->SetUniformi("oitSums", OIT_UNIT_GATHERED);
      program->SetUniformi("oitIsFirst", this->IsFirst ? 1 : 0);
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
      this->Interval.SetUniforms(program);
    });
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::SetUniforms(
  vtkShaderProgram* program, vtkProp*, const vtkOITPeelContext& context)
{
  context.State.BindFor(program);
  program->SetUniformi("oitIsFirst", this->IsFirst ? 1 : 0);
  program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::Release()
{
  this->Sums.Release();
  this->GatherFramebuffer.Release();
  this->ResolveStage.Release();
}
