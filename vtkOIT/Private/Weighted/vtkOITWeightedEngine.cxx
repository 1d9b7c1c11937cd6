// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Weighted/vtkOITWeightedEngine.h"

#include "Private/Engine/vtkOITGeometry.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITFragmentFS.h"
#include "vtkOITWeightedCompositeFS.h"
#include "vtkOITWeightedGatherFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Modes as in vtkOITWeightedPass.
constexpr int Sum = 1;
constexpr int Blended = 2;

int GetBytesPerPixel(const vtkOITFrame& frame)
{
  return 2 * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F) +
    static_cast<int>(vtkOITDepthCopy::GetBytes({ 0, 0, 1, 1 }, frame.Target));
}
}

//------------------------------------------------------------------------------
std::string vtkOITWeightedEngine::GetAlgorithmName(const vtkOITSettings& settings) const
{
  return settings.WeightedMode == Sum  ? "weighted sum"
    : settings.WeightedMode == Blended ? "weighted blended"
                                       : "weighted average";
}

//------------------------------------------------------------------------------
std::string vtkOITWeightedEngine::FindMissing(
  const vtkOITCapabilities& capabilities, const vtkOITSettings&) const
{
  return capabilities.GetMissingForPeeling();
}

//------------------------------------------------------------------------------
std::string vtkOITWeightedEngine::FindMissingIn(const vtkOITFrame& frame) const
{
  return frame.Target.Samples > 0
    ? "sums keep one sample a pixel and the framebuffer is multisampled; "
      "call SetMultiSamples(0) of the render window for this method"
    : std::string();
}

//------------------------------------------------------------------------------
void vtkOITWeightedEngine::AddWeight(vtkOITShaderText& text) const
{
  text.Define("OIT_SUM", this->Mode == Sum);
  text.Define("OIT_BLENDED", this->Mode == Blended);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITWeightedEngine::Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
  vtkOITGeometry& geometry, vtkOITStatistics& statistics)
{
  this->Mode = settings.WeightedMode;
  vtkOITShaderText text({ vtkOITFragmentFS, vtkOITWeightedGatherFS });
  text.Require({ "GL_ARB_explicit_attrib_location" });
  text.Define("OIT_CLAMP_COLOR", frame.Target.ClampsColor);
  this->AddWeight(text);
  if (this->Gather.SetStage(text))
  {
    this->CompositeStage.Release();
  }
  this->Interval = vtkOITEyeDepthInterval::Find(frame);
  std::int64_t largestBand = frame.Rectangle.GetArea();
  if (settings.BufferLimit > 0)
  {
    // A band may get one row more than its share, of which 1 % is for the statistics.
    largestBand = settings.BufferLimit * 99 / 100 / GetBytesPerPixel(frame) - frame.Rectangle.Width;
    largestBand = std::clamp<std::int64_t>(largestBand, 1, frame.Rectangle.GetArea());
    if (this->GetSizeInBytes() > settings.BufferLimit)
    {
      this->Release(); // from before the limit was set
    }
  }
  this->Bands.Begin(frame.Rectangle, largestBand);
  vtkOITFailure failure = this->Bands.DrawAll(
    [&](const vtkOITRectangle& band)
    {
      const bool isPart = settings.BufferLimit > 0 || !(band == frame.Rectangle);
      return this->DrawBand(frame, band, isPart, geometry, statistics);
    },
    [this] { this->Release(); });
  this->Bands.Forget();
  if (statistics.MaximumDepthComplexity > 1)
  {
    statistics.NoteError(1.0);
  }
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITWeightedEngine::DrawBand(const vtkOITFrame& frame, const vtkOITRectangle& band,
  bool isPart, vtkOITGeometry& geometry, vtkOITStatistics& statistics)
{
  const vtkOITRectangle storage = isPart ? band : frame.FindStorage(band);
  vtkOITFailure failure = this->AddUp(frame, band, storage, geometry);
  vtkOITPixelStatistics::Result result;
  if (!failure)
  {
    failure = this->PixelStatistics.Reduce(frame, this->Sums,
      { band.X - storage.X, band.Y - storage.Y, band.Width, band.Height }, result);
  }
  if (!failure)
  {
    frame.BeginOutput(band);
    failure = this->Composite(frame, storage);
  }
  if (!failure)
  {
    statistics.NoteFragments(result.Fragments, result.MostFragments);
  }
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITWeightedEngine::AddUp(const vtkOITFrame& frame, const vtkOITRectangle& band,
  const vtkOITRectangle& storage, vtkOITGeometry& geometry)
{
  vtkOpenGLState* state = frame.GLState;
  frame.BeginGeometry(band);
  vtkOITAttachment depth;
  if (frame.Target.DepthBits > 0)
  {
    if (vtkOITFailure failure = this->OpaqueDepth.Copy(frame, storage, band, OIT_UNIT_STATE))
    {
      return failure;
    }
    this->OpaqueDepth.Unbind(state, OIT_UNIT_STATE);
    depth = this->OpaqueDepth.GetAttachment();
  }
  if (vtkOITFailure failure =
        this->Sums.Reserve(frame.Window, storage.Width, storage.Height, 2, GL_RGBA32F))
  {
    return failure;
  }
  if (vtkOITFailure failure =
        this->Framebuffer.Bind(frame.Window, this->Sums.GetAllLayers(), depth))
  {
    return failure;
  }
  frame.BeginStorage(band, storage);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_COLOR, 1, nothing);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->Gather.SetUniforms(
    [this, state](vtkShaderProgram* program, vtkProp*)
    {
      // An actor may have been told to write depth; translucent ones must not.
      state->vtkglDepthMask(GL_FALSE);
      this->Interval.SetUniforms(program);
    });
  vtkOITFailure failure = geometry.Draw(frame.Props, this->Gather);
  this->Gather.SetUniforms({});
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITWeightedEngine::Composite(
  const vtkOITFrame& frame, const vtkOITRectangle& storage)
{
  return this->CompositeStage.Render(
    frame,
    [this]
    {
      vtkOITShaderText text({ vtkOITWeightedCompositeFS });
      this->AddWeight(text);
      return text;
    },
    [&](vtkShaderProgram* program)
    {
      const int origin[2] = { storage.X, storage.Y };
      this->Sums.Bind(frame.GLState, OIT_UNIT_STATE);
      program->SetUniformi("oitState", OIT_UNIT_STATE);
      program->SetUniform2i("oitOrigin", origin);
    });
}

//------------------------------------------------------------------------------
std::int64_t vtkOITWeightedEngine::GetSizeInBytes() const
{
  return this->Sums.GetSizeInBytes() + this->OpaqueDepth.GetSizeInBytes() +
    this->PixelStatistics.GetSizeInBytes();
}

//------------------------------------------------------------------------------
void vtkOITWeightedEngine::Release()
{
  this->Sums.Release();
  this->OpaqueDepth.Release();
  this->Framebuffer.Release();
  this->CompositeStage.Release();
  this->PixelStatistics.Release();
}
