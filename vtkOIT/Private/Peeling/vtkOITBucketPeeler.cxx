// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITBucketPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/GL/vtkOITOverBlending.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITBucketEqualizeFS.h"
#include "vtkOITBucketFindFS.h"
#include "vtkOITBucketGatherFS.h"
#include "vtkOITBucketHistogramFS.h"
#include "vtkOITBucketResolveFS.h"
#include "vtkOITBucketSlotsFS.h"
#include "vtkOITBucketWriteFS.h"
#include "vtkOITFragmentFS.h"
#include "vtkOITFullScreenVS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
constexpr int Buffers = OIT_BUCKET_BUFFERS; // draw buffers, as in the paper
constexpr int PassesPerPeel = 2;            // of colours, four slots of 6 channels each

/// Clears all layers of an array that is bound.
void Clear(float red, float green, float blue, float alpha)
{
  const float values[4] = { red, green, blue, alpha };
  for (int i = 0; i < Buffers; ++i)
  {
    glClearBufferfv(GL_COLOR, i, values);
  }
}
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
  this->UsedDivision = settings.BucketMode == 1 ? Division::Pairs
    : settings.BucketMode == 2                  ? Division::Adaptive
                                                : Division::Uniform;
  this->HasExactRange = settings.HasExactDepthRange;
  this->LastOnTop = settings.LastOnTop;
  this->IsSingleShot = settings.MaximumNumberOfPeels == 1;
  this->Interval = vtkOITEyeDepthInterval::Find(frame);
  this->IsHistogram = false;
  const bool inPlace = vtkOITPeelState::CanWorkInPlace(frame);
  this->HistogramGather.SetStage(this->MakeGather(vtkOITBucketHistogramFS).Define("OIT_HISTOGRAM"));
  vtkOITShaderText text = this->MakeGather(vtkOITBucketGatherFS);
  text.Define("OIT_CLAMP_COLOR", frame.Target.ClampsColor);
  if (this->Gather.SetStage(text) || this->InPlace != inPlace)
  {
    this->Release();
    this->InPlace = inPlace;
  }
}

//------------------------------------------------------------------------------
vtkOITShaderText vtkOITBucketPeeler::MakeGather(const char* file) const
{
  vtkOITShaderText text({ vtkOITFragmentFS, vtkOITBucketFindFS, file });
  this->AddDivision(text);
  return text;
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::AddDivision(vtkOITShaderText& text) const
{
  text.Require({ "GL_ARB_explicit_attrib_location" });
  text.Define("OIT_LAST_ON_TOP", this->LastOnTop);
  text.Define("OIT_PAIRS", this->UsedDivision == Division::Pairs);
  text.Define("OIT_ADAPTIVE", this->UsedDivision == Division::Adaptive);
  text.Define("OIT_BUCKETS", this->UsedDivision == Division::Pairs ? 16 : 32);
}

//------------------------------------------------------------------------------
vtkOITPeelState::Layout vtkOITBucketPeeler::GetLayout(const vtkOITFrame&) const
{
  return {};
}

//------------------------------------------------------------------------------
int vtkOITBucketPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  const int arrays = this->UsedDivision == Division::Adaptive ? 5 : 3;
  return arrays * Buffers * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITBucketPeeler::GetSizeInBytes() const
{
  return this->Depths.GetSizeInBytes() + this->Slots.GetSizeInBytes() +
    this->Sums.GetSizeInBytes() + this->Histogram.GetSizeInBytes() +
    this->BucketBounds.GetSizeInBytes();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketPeeler::Begin(const vtkOITPeelContext& context)
{
  const bool isAdaptive = this->UsedDivision == Division::Adaptive;
  vtkOITFailure failure;
  const auto reserve = [&](vtkOITTextureArray& array, GLenum format)
  {
    if (!failure)
    {
      failure = array.Reserve(
        context.Frame.Window, context.State.GetWidth(), context.State.GetHeight(), Buffers, format);
    }
  };
  reserve(this->Depths, GL_RGBA32F);
  reserve(this->Slots, GL_RGBA32F);
  reserve(this->Sums, GL_RGBA32F);
  if (isAdaptive)
  {
    reserve(this->Histogram, GL_RGBA32UI);
    reserve(this->BucketBounds, GL_RGBA32F);
  }
  return failure;
}

//------------------------------------------------------------------------------
// A screen stage that writes all buffers of one array from another.
vtkOITFailure vtkOITBucketPeeler::DrawLayers(const vtkOITPeelContext& context,
  vtkOITTextureArray& layers, vtkOITScreenStage& stage, const char* file, const char* sampler,
  const vtkOITTextureArray& source)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  if (vtkOITFailure failure =
        this->ScreenFramebuffer.Bind(context.Frame.Window, layers.GetAllLayers()))
  {
    return failure;
  }
  vtkOpenGLState::ScopedglEnableDisable cull(gl, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable depth(gl, GL_DEPTH_TEST);
  gl->vtkglDisable(GL_CULL_FACE);
  gl->vtkglDisable(GL_DEPTH_TEST);
  gl->vtkglDisable(GL_BLEND);
  return stage.Render(
    context.Frame.Window, vtkOITFullScreenVS,
    [this, file]
    {
      vtkOITShaderText text({ file });
      this->AddDivision(text);
      return text.Insert("Write", vtkOITBucketWriteFS).GetText();
    },
    [&](vtkShaderProgram* program)
    {
      source.Bind(gl, OIT_UNIT_GATHERED);
      program->SetUniformi(sampler, OIT_UNIT_GATHERED);
    });
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketPeeler::GatherHistogram(const vtkOITPeelContext& context)
{
  vtkOITFailure failure =
    context.State.BindForGather(this->GatherFramebuffer, this->Histogram.GetAllLayers(),
      []
      {
        const GLuint nothing[4] = { 0, 0, 0, 0 };
        for (int i = 0; i < Buffers; ++i)
        {
          glClearBufferuiv(GL_COLOR, i, nothing);
        }
      });
  if (failure)
  {
    return failure;
  }
  context.Frame.GLState->vtkglDisable(GL_BLEND);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_OR);
  this->IsHistogram = true;
  failure = context.RenderGeometry();
  this->IsHistogram = false;
  glDisable(GL_COLOR_LOGIC_OP);
  return failure ? failure
                 : this->DrawLayers(context, this->BucketBounds, this->EqualizeStage,
                     vtkOITBucketEqualizeFS, "oitHistogram", this->Histogram);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketPeeler::GatherDepths(const vtkOITPeelContext& context)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  this->IsColorStage = false;
  if (vtkOITFailure failure = context.State.BindForGather(this->GatherFramebuffer,
        this->Depths.GetAllLayers(), [] { Clear(-2.0f, -2.0f, -2.0f, -2.0f); }))
  {
    return failure;
  }
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendEquationSeparate(GL_MAX, GL_MAX);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  vtkOITFailure failure = context.RenderGeometry();
  return failure ? failure
                 : this->DrawLayers(context, this->Slots, this->SlotsStage, vtkOITBucketSlotsFS,
                     "oitDepths", this->Depths);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketPeeler::GatherColors(
  const vtkOITPeelContext& context, int slotLayer, bool isLast)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  this->IsColorStage = true;
  this->SlotLayer = slotLayer;
  const bool lastOnTop = this->LastOnTop;
  if (vtkOITFailure failure =
        context.State.BindForGather(this->GatherFramebuffer, this->Sums.GetAllLayers(),
          [lastOnTop]
          {
            Clear(0.0f, 0.0f, 0.0f, lastOnTop ? 0.0f : -2.0f);
            const float noDepths[4] = { -2.0f, -2.0f, 0.0f, 0.0f };
            if (lastOnTop)
            {
              glClearBufferfv(GL_COLOR, OIT_BUCKET_DEPTHS, noDepths);
            }
          }))
  {
    return failure;
  }
  vtkOITFailure failure;
  if (lastOnTop)
  {
    const vtkOITOverBlending blending(gl, OIT_BUCKET_DEPTHS);
    failure = context.RenderGeometry();
  }
  else
  {
    gl->vtkglEnable(GL_BLEND);
    gl->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
    gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    failure = context.RenderGeometry();
  }
  if (failure)
  {
    return failure;
  }
  failure = context.State.Resolve(
    this->ResolveStage,
    [this]
    {
      vtkOITShaderText text({ vtkOITBucketResolveFS });
      this->AddDivision(text);
      return text;
    },
    [&](vtkShaderProgram* program)
    {
      this->Sums.Bind(gl, OIT_UNIT_GATHERED);
      this->Slots.Bind(gl, OIT_UNIT_DEPTH);
      program->SetUniformi("oitSums", OIT_UNIT_GATHERED);
      program->SetUniformi("oitSlots", OIT_UNIT_DEPTH);
      program->SetUniformi("oitSlotLayer", slotLayer);
      program->SetUniformi("oitIsLastPass", isLast ? 1 : 0);
      program->SetUniformi("oitIsSingleShot", this->IsSingleShot && !this->IsRest ? 1 : 0);
      program->SetUniformi("oitCountsLost", this->CountsLost ? 1 : 0);
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
    });
  vtkOITTextureArray::Unbind(gl, OIT_UNIT_DEPTH);
  return failure;
}

//------------------------------------------------------------------------------
// Nothing is captured, so a colour pass finds the bounds of all that is left, or sums it all up.
vtkOITFailure vtkOITBucketPeeler::GatherColorsOfAll(const vtkOITPeelContext& context)
{
  vtkOITFailure failure = this->EmptySlots(context);
  this->LastSlotLayer = Buffers - 1;
  return failure ? failure : this->GatherColors(context, 0, true);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketPeeler::EmptySlots(const vtkOITPeelContext& context)
{
  if (vtkOITFailure failure =
        this->ScreenFramebuffer.Bind(context.Frame.Window, this->Slots.GetAllLayers()))
  {
    return failure;
  }
  Clear(4.0f, 4.0f, 4.0f, 4.0f);
  if (vtkOITFailure failure =
        this->ScreenFramebuffer.Bind(context.Frame.Window, this->Depths.GetAllLayers()))
  {
    return failure;
  }
  Clear(-2.0f, -2.0f, -2.0f, -2.0f);
  return {};
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  vtkOITFailure failure;
  if (number < this->GetNumberOfSetUpPeels())
  {
    const bool isSingleShot = this->IsSingleShot;
    this->IsSingleShot = false;
    failure = this->GatherColorsOfAll(context);
    this->IsSingleShot = isSingleShot;
    return failure;
  }
  if (this->UsedDivision == Division::Adaptive)
  {
    failure = this->GatherHistogram(context);
  }
  const int passes = this->IsSingleShot ? Buffers : PassesPerPeel;
  this->LastSlotLayer = passes - 1;
  if (!failure)
  {
    failure = this->GatherDepths(context);
  }
  for (int pass = 0; pass < passes && !failure; ++pass)
  {
    failure = this->GatherColors(context, pass, pass == passes - 1);
  }
  if (this->IsSingleShot && !failure)
  {
    this->CountsLost = true;
    failure = this->GatherColors(context, 0, true);
    this->CountsLost = false;
  }
  return failure;
}

//------------------------------------------------------------------------------
// After a single shot what is left is lost, and counted.
vtkOITFailure vtkOITBucketPeeler::PeelRest(const vtkOITPeelContext& context)
{
  if (this->IsSingleShot)
  {
    return {};
  }
  this->IsRest = true;
  vtkOITFailure failure = this->GatherColorsOfAll(context);
  this->IsRest = false;
  return failure;
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::SetUniforms(
  vtkShaderProgram* program, vtkProp*, const vtkOITPeelContext& context)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  context.State.BindFor(program);
  this->Interval.SetUniforms(program);
  if (this->IsHistogram)
  {
    return;
  }
  const vtkOITTextureArray& bounds =
    this->UsedDivision == Division::Adaptive ? this->BucketBounds : this->Slots;
  if (this->UsedDivision == Division::Adaptive)
  {
    bounds.Bind(gl, OIT_UNIT_BUCKET_BOUNDS);
    program->SetUniformi("oitBucketBounds", OIT_UNIT_BUCKET_BOUNDS);
  }
  // While depths are drawn into, slots stand in for them: no texture is read and drawn into at
  // once.
  (this->IsColorStage ? this->Depths : this->Slots).Bind(gl, OIT_UNIT_GATHERED);
  this->Slots.Bind(gl, OIT_UNIT_DEPTH);
  program->SetUniformi("oitDepths", OIT_UNIT_GATHERED);
  program->SetUniformi("oitSlots", OIT_UNIT_DEPTH);
  program->SetUniformi("oitIsColorStage", this->IsColorStage ? 1 : 0);
  program->SetUniformi("oitSlotLayer", this->SlotLayer);
  program->SetUniformi("oitLastSlotLayer", this->LastSlotLayer);
  program->SetUniformi("oitCountsLost", this->CountsLost ? 1 : 0);
  program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::Release()
{
  for (vtkOITTextureArray* array :
    { &this->Depths, &this->Slots, &this->Sums, &this->Histogram, &this->BucketBounds })
  {
    array->Release();
  }
  this->GatherFramebuffer.Release();
  this->ScreenFramebuffer.Release();
  this->EqualizeStage.Release();
  this->SlotsStage.Release();
  this->ResolveStage.Release();
}
