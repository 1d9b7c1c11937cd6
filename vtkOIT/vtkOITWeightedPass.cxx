// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITWeightedPass.h"

#include "Private/Frame/vtkOITBands.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITEyeDepthInterval.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITDepthCopy.h"
#include "Private/GL/vtkOITOutput.h"
#include "Private/GL/vtkOITPixelStatistics.h"
#include "Private/GL/vtkOITSavedState.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOITFragmentFS.h"
#include "vtkOITWeightedCompositeFS.h"
#include "vtkOITWeightedGatherFS.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTimeStamp.h"

#include <algorithm>

namespace
{
// Texture unit; mappers count theirs up from 0 and GL has at least 16.
constexpr int Unit = 13;

int GetBytesPerPixel(const vtkOITFrame& frame)
{
  return 2 * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F) +
    static_cast<int>(vtkOITDepthCopy::GetBytes({ 0, 0, 1, 1 }, frame.Target));
}
}

//------------------------------------------------------------------------------
class vtkOITWeightedPass::Internals
{
public:
  void Prepare(const vtkOITFrame& frame, int mode);
  std::string GetDefinitions() const;
  void Composite(const vtkOITFrame& frame, const vtkOITRectangle& storage);
  void Release();

  int Mode = -1; // of the shaders
  vtkTimeStamp ShaderTime;
  vtkOITBands Bands;
  vtkOITTextureArray Sums;
  vtkOITDepthCopy OpaqueDepth;
  vtkOITFramebuffer Framebuffer;
  vtkOITOutputStage CompositeStage;
  vtkOITPixelStatistics Statistics;
  vtkOITEyeDepthInterval Interval;
  const vtkOITFrame* Frame = nullptr; // during a geometry pass
};

//------------------------------------------------------------------------------
void vtkOITWeightedPass::Internals::Prepare(const vtkOITFrame& frame, int mode)
{
  if (mode != this->Mode)
  {
    this->ShaderTime.Modified();
    this->CompositeStage.Release();
    this->Mode = mode;
  }
  this->Interval = vtkOITEyeDepthInterval::Find(frame);
}

//------------------------------------------------------------------------------
std::string vtkOITWeightedPass::Internals::GetDefinitions() const
{
  return this->Mode == SUM  ? "#define OIT_SUM\n"
    : this->Mode == BLENDED ? "#define OIT_BLENDED\n"
                            : "";
}

//------------------------------------------------------------------------------
void vtkOITWeightedPass::Internals::Composite(
  const vtkOITFrame& frame, const vtkOITRectangle& storage)
{
  this->CompositeStage.Render(
    frame,
    [this]
    {
      std::string text = vtkOITWeightedCompositeFS;
      vtkOITReplace(text, "//VTK::System::Dec", "//VTK::System::Dec\n" + this->GetDefinitions());
      return text;
    },
    [&](vtkShaderProgram* program)
    {
      const int origin[2] = { storage.X, storage.Y };
      this->Sums.Bind(frame.GLState, Unit);
      program->SetUniformi("oitState", Unit);
      program->SetUniform2i("oitOrigin", origin);
    });
}

//------------------------------------------------------------------------------
void vtkOITWeightedPass::Internals::Release()
{
  this->Sums.Release();
  this->OpaqueDepth.Release();
  this->Framebuffer.Release();
  this->CompositeStage.Release();
  this->Statistics.Release();
}

vtkStandardNewMacro(vtkOITWeightedPass);

//------------------------------------------------------------------------------
vtkOITWeightedPass::vtkOITWeightedPass()
  : Impl(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkOITWeightedPass::~vtkOITWeightedPass() = default;

//------------------------------------------------------------------------------
void vtkOITWeightedPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->GetOwnAlgorithmName() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkOITWeightedPass::GetOwnAlgorithmName()
{
  return this->Mode == SUM  ? "weighted sum"
    : this->Mode == BLENDED ? "weighted blended"
                            : "weighted average";
}

//------------------------------------------------------------------------------
std::string vtkOITWeightedPass::FindMissingCapability(const vtkOITCapabilities& capabilities)
{
  return capabilities.GetMissingForPeeling();
}

//------------------------------------------------------------------------------
std::string vtkOITWeightedPass::FindMissingInTarget(const vtkOITFrame& frame)
{
  return frame.Target.Samples > 0
    ? "sums keep one sample a pixel and the framebuffer is multisampled; "
      "call SetMultiSamples(0) of the render window for this method"
    : std::string();
}

//------------------------------------------------------------------------------
void vtkOITWeightedPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->Release();
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkOITWeightedPass::RenderTranslucent(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  impl.Prepare(frame, this->Mode);
  std::int64_t largestBand = frame.Rectangle.GetArea();
  if (this->MaximumBufferSize > 0)
  {
    // A band may get one row more than its share, of which 1 % is for the statistics.
    largestBand =
      this->MaximumBufferSize * 99 / 100 / GetBytesPerPixel(frame) - frame.Rectangle.Width;
    largestBand = std::clamp<std::int64_t>(largestBand, 1, frame.Rectangle.GetArea());
    if (this->BufferSizeInBytes > this->MaximumBufferSize)
    {
      impl.Release(); // from before the limit was set
    }
  }
  impl.Bands.Begin(frame.Rectangle, largestBand);
  vtkOITRectangle band;
  while (impl.Bands.GetNext(band))
  {
    this->RenderBand(frame, band);
    impl.Bands.Accept();
  }
  impl.Bands.Forget();
  this->Exact = this->MaximumDepthComplexity <= 1;
  this->ErrorBound = this->Exact ? 0.0 : 1.0;
  this->BufferSizeInBytes = impl.Sums.GetSizeInBytes() + impl.OpaqueDepth.GetSizeInBytes() +
    impl.Statistics.GetSizeInBytes();
}

//------------------------------------------------------------------------------
void vtkOITWeightedPass::RenderBand(vtkOITFrame& frame, const vtkOITRectangle& band)
{
  Internals& impl = *this->Impl;
  vtkOpenGLState* state = frame.GLState;
  const vtkOITRectangle storage = this->MaximumBufferSize > 0 ? band : frame.FindStorage(band);
  {
    const vtkOITSavedState saved(state, false);
    if (frame.Target.DepthBits > 0)
    {
      impl.OpaqueDepth.Copy(frame, storage, band, Unit);
      impl.OpaqueDepth.Unbind(state, Unit);
    }
    impl.Sums.Reserve(frame.Window, storage.Width, storage.Height, 2, GL_RGBA32F);
    impl.Framebuffer.Bind(frame.Window, impl.Sums.GetAllLayers(),
      frame.Target.DepthBits > 0 ? impl.OpaqueDepth.GetAttachment() : vtkOITAttachment());
    frame.ShiftViewport(band, storage);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDepthMask(GL_FALSE);
    const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_COLOR, 1, nothing);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    impl.Frame = &frame;
    this->RenderGeometry(frame);
    impl.Frame = nullptr;
  }
  const vtkOITSavedState saved(state, false);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(band.X, band.Y, band.Width, band.Height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  frame.DrawToFirstBufferOnly();
  impl.Composite(frame, storage);
  const vtkOITPixelStatistics::Result statistics = impl.Statistics.Reduce(
    frame, impl.Sums, { band.X - storage.X, band.Y - storage.Y, band.Width, band.Height });
  this->NumberOfFragments += statistics.Fragments;
  this->MaximumDepthComplexity = std::max(this->MaximumDepthComplexity, statistics.MostFragments);
}

//------------------------------------------------------------------------------
bool vtkOITWeightedPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  std::string header =
    vtkOITRequireExtensions({ "GL_ARB_explicit_attrib_location" }) + this->Impl->GetDefinitions();
  if (vtkOITWritesDepth(fragmentShader))
  {
    header += "#define OIT_WRITES_DEPTH\n";
  }
  return vtkOITWrapFragmentShader(
    fragmentShader, header, std::string(vtkOITFragmentFS) + vtkOITWeightedGatherFS);
}

//------------------------------------------------------------------------------
bool vtkOITWeightedPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  const Internals& impl = *this->Impl;
  if (impl.Frame)
  {
    // An actor may have been told to write depth; translucent ones must not.
    impl.Frame->GLState->vtkglDepthMask(GL_FALSE);
    impl.Interval.SetUniforms(program);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkOITWeightedPass::GetShaderStageMTime()
{
  return this->Impl->ShaderTime.GetMTime();
}
