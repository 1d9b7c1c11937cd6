// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITBucketPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOITBucketEqualizeFS.h"
#include "vtkOITBucketFindFS.h"
#include "vtkOITBucketGatherFS.h"
#include "vtkOITBucketHistogramFS.h"
#include "vtkOITBucketResolveFS.h"
#include "vtkOITBucketSlotsFS.h"
#include "vtkOITFragmentFS.h"
#include "vtkOITFullScreenVS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
constexpr int Buffers = 8;       // draw buffers, as in the paper
constexpr int SlotsPerPass = 4;  // 6 channels each
constexpr int PassesPerPeel = 2; // of colours
constexpr int DepthsUnit = vtkOITPeelState::GatheredUnit;
constexpr int SlotsUnit = vtkOITPeelState::GatheredUnit + 1;
constexpr int BoundsUnit = vtkOITPeelState::StateUnit - 1;
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::Prepare(const vtkOITFrame& frame, bool)
{
  const bool inPlace = vtkOITPeelState::CanWorkInPlace(frame);
  if (this->UsedDivision != this->WantedDivision || this->InPlace != inPlace)
  {
    this->Release();
    this->UsedDivision = this->WantedDivision;
    this->InPlace = inPlace;
    this->ShaderTime.Modified();
  }
  this->Interval = vtkOITEyeDepthInterval::Find(frame);
}

//------------------------------------------------------------------------------
vtkOITPeelState::Layout vtkOITBucketPeeler::GetLayout(const vtkOITFrame&) const
{
  return {};
}

//------------------------------------------------------------------------------
int vtkOITBucketPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  const int arrays = this->WantedDivision == Division::Adaptive ? 5 : 3;
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
void vtkOITBucketPeeler::Begin(const vtkOITPeelContext& context)
{
  const auto reserve = [&](vtkOITTextureArray& array, GLenum format)
  {
    array.Reserve(
      context.Frame.Window, context.State.GetWidth(), context.State.GetHeight(), Buffers, format);
  };
  reserve(this->Depths, GL_RGBA32F);
  reserve(this->Slots, GL_RGBA32F);
  reserve(this->Sums, GL_RGBA32F);
  if (this->UsedDivision == Division::Adaptive)
  {
    reserve(this->Histogram, GL_RGBA32UI);
    reserve(this->BucketBounds, GL_RGBA32F);
  }
  this->IsRest = false;
}

//------------------------------------------------------------------------------
// A mapper's shader has either integer outputs or floats, so the props' shaders are exchanged.
void vtkOITBucketPeeler::ChooseHistogramShader(bool isHistogram)
{
  if (isHistogram != this->IsHistogram)
  {
    this->IsHistogram = isHistogram;
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
// A screen stage that writes all buffers of one array from another.
void vtkOITBucketPeeler::DrawLayers(const vtkOITPeelContext& context, vtkOITTextureArray& layers,
  vtkOITScreenStage& stage, const char* text, const char* sampler, const vtkOITTextureArray& source)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  this->ScreenFramebuffer.Bind(context.Frame.Window, layers.GetAllLayers());
  vtkOpenGLState::ScopedglEnableDisable cull(gl, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable depth(gl, GL_DEPTH_TEST);
  gl->vtkglDisable(GL_CULL_FACE);
  gl->vtkglDisable(GL_DEPTH_TEST);
  gl->vtkglDisable(GL_BLEND);
  stage.Render(
    context.Frame.Window, vtkOITFullScreenVS,
    [this, text]
    {
      std::string shader = text;
      vtkOITReplace(shader, "//VTK::System::Dec",
        "//VTK::System::Dec\n" + vtkOITRequireExtensions({ "GL_ARB_explicit_attrib_location" }) +
          this->GetDefinitions());
      return shader;
    },
    [&](vtkShaderProgram* program)
    {
      source.Bind(gl, DepthsUnit);
      program->SetUniformi(sampler, DepthsUnit);
    });
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::GatherHistogram(const vtkOITPeelContext& context)
{
  this->ChooseHistogramShader(true);
  context.State.BindForGather(this->GatherFramebuffer, this->Histogram.GetAllLayers(),
    []
    {
      const GLuint nothing[4] = { 0, 0, 0, 0 };
      for (int i = 0; i < Buffers; ++i)
      {
        glClearBufferuiv(GL_COLOR, i, nothing);
      }
    });
  context.Frame.GLState->vtkglDisable(GL_BLEND);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_OR);
  context.RenderGeometry();
  glDisable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_COPY);
  this->DrawLayers(context, this->BucketBounds, this->EqualizeStage, vtkOITBucketEqualizeFS,
    "oitHistogram", this->Histogram);
  this->ChooseHistogramShader(false);
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::GatherDepths(const vtkOITPeelContext& context)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  this->IsColorStage = false;
  context.State.BindForGather(this->GatherFramebuffer, this->Depths.GetAllLayers(),
    []
    {
      const float nothing[4] = { -2.0f, -2.0f, -2.0f, -2.0f };
      for (int i = 0; i < Buffers; ++i)
      {
        glClearBufferfv(GL_COLOR, i, nothing);
      }
    });
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendEquationSeparate(GL_MAX, GL_MAX);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  context.RenderGeometry();
  this->DrawLayers(
    context, this->Slots, this->SlotsStage, vtkOITBucketSlotsFS, "oitDepths", this->Depths);
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::GatherColors(const vtkOITPeelContext& context, int slotLayer, bool isLast)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  this->IsColorStage = true;
  this->SlotLayer = slotLayer;
  context.State.BindForGather(this->GatherFramebuffer, this->Sums.GetAllLayers(),
    []
    {
      const float nothing[4] = { 0.0f, 0.0f, 0.0f, -2.0f };
      for (int i = 0; i < Buffers; ++i)
      {
        glClearBufferfv(GL_COLOR, i, nothing);
      }
    });
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  context.RenderGeometry();
  context.State.Resolve(
    this->ResolveStage,
    [&] { return context.State.AssembleResolve(vtkOITBucketResolveFS, this->GetDefinitions()); },
    [&](vtkShaderProgram* program)
    {
      this->Sums.Bind(gl, DepthsUnit);
      this->Slots.Bind(gl, SlotsUnit);
      program->SetUniformi("oitSums", DepthsUnit);
      program->SetUniformi("oitSlots", SlotsUnit);
      program->SetUniformi("oitSlotLayer", slotLayer);
      program->SetUniformi("oitIsLastPass", isLast ? 1 : 0);
      program->SetUniformi("oitIsSingleShot", this->IsSingleShot && !this->IsRest ? 1 : 0);
      program->SetUniformi("oitCountsLost", this->CountsLost ? 1 : 0);
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
    });
  vtkOITTextureArray::Unbind(gl, SlotsUnit);
}

//------------------------------------------------------------------------------
// Nothing is captured, so a colour pass finds the bounds of all that is left.
void vtkOITBucketPeeler::EmptySlots(const vtkOITPeelContext& context)
{
  const auto clear = [&](const vtkOITTextureArray& array, float value)
  {
    this->ScreenFramebuffer.Bind(context.Frame.Window, array.GetAllLayers());
    const float values[4] = { value, value, value, value };
    for (int i = 0; i < Buffers; ++i)
    {
      glClearBufferfv(GL_COLOR, i, values);
    }
  };
  clear(this->Slots, 4.0f);
  clear(this->Depths, -2.0f);
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  if (number < this->GetNumberOfSetUpPeels())
  {
    this->EmptySlots(context);
    this->LastSlotLayer = Buffers - 1;
    const bool isSingleShot = this->IsSingleShot;
    this->IsSingleShot = false;
    this->GatherColors(context, 0, true);
    this->IsSingleShot = isSingleShot;
    return;
  }
  if (this->UsedDivision == Division::Adaptive)
  {
    this->GatherHistogram(context);
  }
  const int passes = this->IsSingleShot ? Buffers : PassesPerPeel;
  this->LastSlotLayer = passes - 1;
  this->GatherDepths(context);
  for (int pass = 0; pass < passes; ++pass)
  {
    this->GatherColors(context, pass, pass == passes - 1);
  }
  if (this->IsSingleShot)
  {
    this->CountsLost = true;
    this->GatherColors(context, 0, true);
    this->CountsLost = false;
  }
}

//------------------------------------------------------------------------------
void vtkOITBucketPeeler::PeelRest(const vtkOITPeelContext& context)
{
  if (this->IsSingleShot)
  {
    return; // what is left is lost, and counted
  }
  this->EmptySlots(context);
  this->LastSlotLayer = Buffers - 1;
  this->IsRest = true;
  this->GatherColors(context, 0, true);
  this->IsRest = false;
}

//------------------------------------------------------------------------------
std::string vtkOITBucketPeeler::GetDefinitions() const
{
  switch (this->UsedDivision)
  {
    case Division::Pairs:
      return "#define OIT_PAIRS\n#define OIT_BUCKETS 16\n";
    case Division::Adaptive:
      return "#define OIT_ADAPTIVE\n#define OIT_BUCKETS 32\n";
    default:
      return "#define OIT_BUCKETS 32\n";
  }
}

//------------------------------------------------------------------------------
bool vtkOITBucketPeeler::WrapGather(std::string& fragmentShader) const
{
  std::string header =
    vtkOITRequireExtensions({ "GL_ARB_explicit_attrib_location" }) + this->GetDefinitions();
  if (this->IsHistogram)
  {
    header += "#define OIT_HISTOGRAM\n";
  }
  if (vtkOITWritesDepth(fragmentShader))
  {
    header += "#define OIT_WRITES_DEPTH\n";
  }
  return vtkOITWrapFragmentShader(fragmentShader, header,
    std::string(vtkOITFragmentFS) + vtkOITBucketFindFS +
      (this->IsHistogram ? vtkOITBucketHistogramFS : vtkOITBucketGatherFS));
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
    bounds.Bind(gl, BoundsUnit);
    program->SetUniformi("oitBucketBounds", BoundsUnit);
  }
  // While depths are drawn into, slots stand in for them: no texture is read and drawn into at
  // once.
  (this->IsColorStage ? this->Depths : this->Slots).Bind(gl, DepthsUnit);
  this->Slots.Bind(gl, SlotsUnit);
  program->SetUniformi("oitDepths", DepthsUnit);
  program->SetUniformi("oitSlots", SlotsUnit);
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
