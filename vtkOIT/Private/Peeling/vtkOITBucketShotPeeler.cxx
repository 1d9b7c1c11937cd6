// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITBucketShotPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"

#include "vtkOITBucketColorsFS.h"
#include "vtkOITBucketDepthFS.h"
#include "vtkOITBucketDivideFS.h"
#include "vtkOITBucketLostFS.h"
#include "vtkOITBucketShotGatherFS.h"
#include "vtkOITBucketShotResolveFS.h"
#include "vtkOITBucketSlotsFS.h"
#include "vtkOITBucketWordsFS.h"
#include "vtkOITFragmentFS.h"
#include "vtkOITFullScreenVS.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <string>

namespace
{
constexpr int Buffers = 8; // draw buffers, as in the paper
constexpr int LayersOfTable = 4;

constexpr std::size_t MostOpacities = 16; // that have numbers

bool HasScalars(vtkMapper* mapper)
{
  int cellFlag = 0;
  return mapper->GetScalarVisibility() && mapper->GetInput() &&
    vtkAbstractMapper::GetAbstractScalars(mapper->GetInput(), mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
}

/// Whether all fragments of an actor have the opacity of its property: nothing else is known to say so, as
/// arrays, textures, blocks, splats and shaders of the user's may have others.
bool HasOneOpacity(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  return mapper && mapper->GetClassName() == std::string("vtkOpenGLPolyDataMapper") &&
    !HasScalars(mapper) && !actor->GetTexture() && !actor->GetBackfaceProperty() &&
    actor->GetProperty()->GetAllTextures().empty() &&
    !actor->GetShaderProperty()->HasFragmentShaderCode() &&
    actor->GetShaderProperty()->GetNumberOfShaderReplacements() == 0;
}
}

//------------------------------------------------------------------------------
void vtkOITBucketShotPeeler::Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  const bool inPlace = vtkOITPeelState::CanWorkInPlace(frame);
  const bool isOther = this->InPlace != inPlace || this->FloatColor != settings.FloatColor;
  this->UsedDivision = settings.BucketMode == 1 ? Division::Pairs
    : settings.BucketMode == 2                  ? Division::Adaptive
                                                : Division::Uniform;
  this->HasExactRange = settings.HasExactDepthRange;
  this->FloatColor = settings.FloatColor;
  this->ClampsColor = frame.Target.ClampsColor;
  this->NumberOpacities(frame.Props);
  this->Interval = vtkOITEyeDepthInterval::Find(frame);
  vtkOITShaderText text(
    { vtkOITFragmentFS, vtkOITBucketDepthFS, vtkOITBucketWordsFS, vtkOITBucketShotGatherFS });
  this->Define(text);
  text.Insert("Colors", this->UsedDivision == Division::Adaptive ? vtkOITBucketColorsFS : "");
  if (this->Gather.SetStage(text) || isOther)
  {
    this->Release();
    this->InPlace = inPlace;
  }
}

//------------------------------------------------------------------------------
void vtkOITBucketShotPeeler::NumberOpacities(const std::vector<vtkProp*>& props)
{
  this->Opacities.clear();
  this->OpacityNumbers.clear();
  for (vtkProp* prop : props)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (!actor || !HasOneOpacity(actor))
    {
      this->Opacities.clear();
      return;
    }
    const auto opacity = static_cast<float>(actor->GetProperty()->GetOpacity());
    const auto found = std::find(this->Opacities.begin(), this->Opacities.end(), opacity);
    this->OpacityNumbers[prop] = static_cast<int>(found - this->Opacities.begin());
    if (found == this->Opacities.end())
    {
      this->Opacities.push_back(opacity);
    }
    if (this->Opacities.size() > MostOpacities)
    {
      this->Opacities.clear();
      return;
    }
  }
}

//------------------------------------------------------------------------------
void vtkOITBucketShotPeeler::SetOpacityBits(vtkShaderProgram* program) const
{
  int bits = 0;
  while ((std::size_t(1) << bits) < this->Opacities.size())
  {
    ++bits;
  }
  program->SetUniformi("oitOpacityBits", this->Opacities.empty() ? 4 : bits);
}

//------------------------------------------------------------------------------
void vtkOITBucketShotPeeler::Define(vtkOITShaderText& text) const
{
  text.Require({ "GL_ARB_explicit_attrib_location", "GL_ARB_shader_bit_encoding" });
  text.Define("OIT_PAIRS", this->UsedDivision == Division::Pairs);
  text.Define("OIT_ADAPTIVE", this->UsedDivision == Division::Adaptive);
  text.Define("OIT_BUCKETS", this->UsedDivision == Division::Uniform ? 24 : 12);
  text.Define("OIT_CLAMP_COLOR", this->ClampsColor);
}

//------------------------------------------------------------------------------
int vtkOITBucketShotPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  const int layers =
    this->UsedDivision == Division::Adaptive ? 2 * Buffers + LayersOfTable : Buffers;
  return layers * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITBucketShotPeeler::GetSizeInBytes() const
{
  return this->Buckets.GetSizeInBytes() + this->Table.GetSizeInBytes() +
    this->Colors.GetSizeInBytes();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketShotPeeler::Begin(const vtkOITPeelContext& context)
{
  vtkOITFailure failure;
  const auto reserve = [&](vtkOITTextureArray& array, int layers)
  {
    if (!failure)
    {
      failure = array.Reserve(context.Frame.Window, context.State.GetWidth(),
        context.State.GetHeight(), layers, GL_RGBA32F);
    }
  };
  reserve(this->Buckets, Buffers);
  if (this->UsedDivision == Division::Adaptive)
  {
    reserve(this->Table, LayersOfTable);
    reserve(this->Colors, Buffers);
  }
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketShotPeeler::GatherStage(const vtkOITPeelContext& context, int stage)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  this->Stage = stage;
  const bool isColor = stage == OIT_SHOT_COLORS;
  const vtkOITTextureArray& array = isColor ? this->Colors : this->Buckets;
  const int buffers = stage == OIT_SHOT_RANGE ? 1 : Buffers;
  vtkOITFailure failure = context.State.BindForGather(this->GatherFramebuffer, array.GetAllLayers(),
    [buffers, isColor]
    {
      const float empty = isColor ? 0.0f : -2.0f;
      const float nothing[4] = { empty, empty, empty, 0.0f };
      for (int i = 0; i < buffers; ++i)
      {
        glClearBufferfv(GL_COLOR, i, nothing);
      }
    });
  if (failure)
  {
    return failure;
  }
  if (buffers < Buffers)
  {
    vtkOITFramebuffer::DrawInto(buffers);
  }
  gl->vtkglEnable(GL_BLEND);
  gl->vtkglBlendEquationSeparate(GL_MAX, isColor ? GL_MAX : GL_FUNC_ADD);
  gl->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  return context.RenderGeometry();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketShotPeeler::DivideBuckets(const vtkOITPeelContext& context)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  if (vtkOITFailure failure =
        this->TableFramebuffer.Bind(context.Frame.Window, this->Table.GetAllLayers()))
  {
    return failure;
  }
  vtkOpenGLState::ScopedglEnableDisable cull(gl, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable depth(gl, GL_DEPTH_TEST);
  gl->vtkglDisable(GL_CULL_FACE);
  gl->vtkglDisable(GL_DEPTH_TEST);
  gl->vtkglDisable(GL_BLEND);
  return this->DivideStage.Render(
    context.Frame.Window, vtkOITFullScreenVS,
    [this]
    {
      vtkOITShaderText text({ vtkOITBucketDivideFS });
      this->Define(text);
      return text.GetText();
    },
    [&](vtkShaderProgram* program)
    {
      this->Buckets.Bind(gl, OIT_UNIT_GATHERED);
      program->SetUniformi("oitShot", OIT_UNIT_GATHERED);
    });
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketShotPeeler::Resolve(const vtkOITPeelContext& context)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  const bool isAdaptive = this->UsedDivision == Division::Adaptive;
  vtkOITFailure failure = context.State.Resolve(
    this->ResolveStage,
    [this, isAdaptive]
    {
      vtkOITShaderText text({ isAdaptive ? vtkOITBucketSlotsFS : vtkOITBucketShotResolveFS });
      this->Define(text);
      text.Define("OIT_FLOAT_COLOR", this->FloatColor);
      return text.Insert("Words", vtkOITBucketWordsFS).Insert("Lost", vtkOITBucketLostFS);
    },
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("oitStage", this->Stage);
      this->SetOpacityBits(program);
      program->SetUniformi("oitHasOpacityNumbers", this->Opacities.empty() ? 0 : 1);
      if (!this->Opacities.empty() && program->IsUniformUsed("oitOpacities"))
      {
        program->SetUniform1fv(
          "oitOpacities", static_cast<int>(this->Opacities.size()), this->Opacities.data());
      }
      this->Buckets.Bind(gl, OIT_UNIT_GATHERED);
      program->SetUniformi("oitShot", OIT_UNIT_GATHERED);
      if (isAdaptive)
      {
        this->Table.Bind(gl, OIT_UNIT_BUCKET_TABLE);
        program->SetUniformi("oitTable", OIT_UNIT_BUCKET_TABLE);
        this->Colors.Bind(gl, OIT_UNIT_DEPTH);
        program->SetUniformi("oitColors", OIT_UNIT_DEPTH);
      }
    });
  vtkOITTextureArray::Unbind(gl, OIT_UNIT_DEPTH);
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBucketShotPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  const bool isRange = number < this->GetNumberOfSetUpPeels();
  vtkOITFailure failure = this->GatherStage(context, isRange ? OIT_SHOT_RANGE : OIT_SHOT_BUCKETS);
  if (!failure && !isRange && this->UsedDivision == Division::Adaptive)
  {
    failure = this->DivideBuckets(context);
    if (!failure)
    {
      failure = this->GatherStage(context, OIT_SHOT_COLORS);
    }
  }
  return failure ? failure : this->Resolve(context);
}

//------------------------------------------------------------------------------
void vtkOITBucketShotPeeler::SetUniforms(
  vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context)
{
  context.State.BindFor(program);
  this->Interval.SetUniforms(program);
  program->SetUniformi("oitStage", this->Stage);
  this->SetOpacityBits(program);
  const auto found = this->OpacityNumbers.find(prop);
  const bool hasNumber = !this->Opacities.empty() && found != this->OpacityNumbers.end();
  program->SetUniformi("oitOpacityNumber", hasNumber ? found->second : -1);
  if (this->UsedDivision == Division::Adaptive)
  {
    // What is drawn into is not bound: the table stands in for the buckets while these are.
    const bool isColor = this->Stage == OIT_SHOT_COLORS;
    (isColor ? this->Buckets : this->Table).Bind(context.Frame.GLState, OIT_UNIT_GATHERED);
    this->Table.Bind(context.Frame.GLState, OIT_UNIT_BUCKET_TABLE);
    program->SetUniformi("oitShot", OIT_UNIT_GATHERED);
    program->SetUniformi("oitTable", OIT_UNIT_BUCKET_TABLE);
  }
}

//------------------------------------------------------------------------------
void vtkOITBucketShotPeeler::Release()
{
  this->Buckets.Release();
  this->Table.Release();
  this->Colors.Release();
  this->GatherFramebuffer.Release();
  this->TableFramebuffer.Release();
  this->DivideStage.Release();
  this->ResolveStage.Release();
}
