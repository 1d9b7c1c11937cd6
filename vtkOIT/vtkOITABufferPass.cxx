// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITABufferPass.h"

#include "Private/vtkOITABufferShaders.h"
#include "Private/vtkOITBands.h"
#include "Private/vtkOITCapabilities.h"
#include "Private/vtkOITCompatibility.h"
#include "Private/vtkOITDepthCopy.h"
#include "Private/vtkOITFragmentStore.h"
#include "Private/vtkOITFrame.h"
#include "Private/vtkOITSavedState.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTimeStamp.h"

#include <algorithm>

vtkStandardNewMacro(vtkOITABufferPass);

namespace
{
// The texture unit of the depth copy. Mappers count theirs up from 0 and GL has at least 16.
constexpr int DepthUnit = 15;

// Fragments per pixel that the first frame has room for.
constexpr std::int64_t FirstGuess = 4;
}

/// What lives from frame to frame, and the band that is being rendered.
class vtkOITABufferPass::Internals
{
public:
  void ChooseShaders(const vtkOITFrame& frame, bool floatColor);
  void Begin(const vtkOITFrame& frame);
  void Resolve(const vtkOITFrame& frame);
  void RenderQuad(std::unique_ptr<vtkOpenGLQuadHelper>& quad, const std::string& fragmentShader,
    vtkOpenGLRenderWindow* window);
  std::int64_t GetNodeLimit(const vtkOITFrame& frame, std::int64_t maximumBytes) const;

  vtkOITFragmentStore Store;
  vtkOITDepthCopy DepthCopy;
  vtkOITABufferShaders Shaders;
  vtkTimeStamp ShaderTime;
  std::unique_ptr<vtkOpenGLQuadHelper> ResolveQuad;
  std::unique_ptr<vtkOpenGLQuadHelper> PresortQuad;
  vtkOITBands Bands;

  vtkOITRectangle Band;
  const vtkOITFrame* Frame = nullptr;
  bool HasDepthCopy = false;
};

//------------------------------------------------------------------------------
vtkOITABufferPass::vtkOITABufferPass()
  : Impl(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkOITABufferPass::~vtkOITABufferPass() = default;

//------------------------------------------------------------------------------
void vtkOITABufferPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FragmentPrecision: " << (this->FragmentPrecision == HALF ? "half" : "float")
     << "\n";
}

//------------------------------------------------------------------------------
std::string vtkOITABufferPass::FindMissingCapability(const vtkOITCapabilities& capabilities)
{
  return capabilities.GetMissingForStorage();
}

//------------------------------------------------------------------------------
void vtkOITABufferPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& impl = *this->Impl;
  impl.Store.Release();
  impl.DepthCopy.Release();
  impl.ResolveQuad.reset();
  impl.PresortQuad.reset();
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkOITABufferPass::Internals::ChooseShaders(const vtkOITFrame& frame, bool floatColor)
{
  vtkOITABufferShaders shaders;
  shaders.Samples = frame.Target.Samples;
  shaders.FloatColor = floatColor;
  shaders.NodesInImage = this->Store.GetNodesInImage();
  shaders.FramebufferFetch = frame.Capabilities->FramebufferFetch && frame.Target.CoarseColor &&
    frame.Target.Samples == 0;
  shaders.PostDepthCoverage = frame.Capabilities->PostDepthCoverage;
  if (shaders != this->Shaders || this->ShaderTime.GetMTime() == 0)
  {
    this->Shaders = shaders;
    this->ShaderTime.Modified();
    this->ResolveQuad.reset();
    this->PresortQuad.reset();
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkOITABufferPass::Internals::GetNodeLimit(
  const vtkOITFrame& frame, std::int64_t maximumBytes) const
{
  std::int64_t bytes = vtkOITFragmentStore::GetLargestPool(*frame.Capabilities);
  // A single pixel cannot be divided: exactness goes before the limit then.
  if (maximumBytes > 0 && this->Band.GetArea() > 1)
  {
    bytes = std::min(bytes, maximumBytes - 4 * this->Band.GetArea());
  }
  return bytes / this->Shaders.GetBytesPerNode();
}

//------------------------------------------------------------------------------
void vtkOITABufferPass::RenderTranslucent(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  impl.Frame = &frame;
  frame.GLState->vtkglEnable(GL_SCISSOR_TEST);
  // List heads take at most half of the memory that is allowed.
  impl.Bands.Begin(frame.Rectangle,
    this->MaximumBufferSize > 0 ? this->MaximumBufferSize / 8 : frame.Rectangle.GetArea());
  while (impl.Bands.GetNext(impl.Band))
  {
    const std::int64_t needed = this->RenderBand(frame);
    const std::int64_t capacity = impl.Store.GetCapacity();
    if (needed <= capacity || !impl.Bands.Split((needed + capacity - 1) / capacity))
    {
      impl.Bands.Accept();
    }
  }
  if (this->NumberOfFragments < impl.Store.GetCapacity() / 2)
  {
    impl.Bands.Forget();
  }
  this->BufferSizeInBytes = impl.Store.GetSizeInBytes() + impl.DepthCopy.GetSizeInBytes();
  impl.Frame = nullptr;
}

//------------------------------------------------------------------------------
// Renders the band once or, when the pool is too small and may grow, twice. Returns the number of
// nodes that the band needs: when that is more than the pool has now, nothing was drawn.
vtkTypeInt64 vtkOITABufferPass::RenderBand(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  std::int64_t wanted = std::max(FirstGuess * impl.Band.GetArea(), impl.Store.GetCapacity());
  std::int64_t needed = 0;
  for (std::int64_t before = -1;;)
  {
    impl.ChooseShaders(frame, this->FragmentPrecision == FLOAT);
    const std::int64_t limit = impl.GetNodeLimit(frame, this->MaximumBufferSize);
    impl.Store.Reserve(frame.Window, *frame.Capabilities, impl.Band, std::min(wanted, limit),
      impl.Shaders.GetBytesPerNode());
    impl.ChooseShaders(frame, this->FragmentPrecision == FLOAT); // as the pool is now
    impl.Begin(frame);
    this->RenderGeometry(frame);
    impl.Resolve(frame);

    const vtkOITFragmentStore::Counters counters = impl.Store.ReadCounters();
    const std::int64_t capacity = impl.Store.GetCapacity();
    if (!counters.Overflow)
    {
      this->NumberOfFragments += counters.FragmentCount;
      this->MaximumDepthComplexity = std::max(
        this->MaximumDepthComplexity, static_cast<int>(counters.MaximumDepthComplexity));
      return counters.FragmentCount;
    }
    // A count that is not beyond the capacity has wrapped around 2^32.
    needed = counters.FragmentCount > capacity ? counters.FragmentCount : INT64_C(1) << 32;
    if (capacity >= limit || capacity <= before)
    {
      break;
    }
    before = capacity;
    wanted = needed + needed / 8; // so that a moving camera does not make every frame grow
  }
  if (impl.Band.GetArea() == 1)
  {
    vtkErrorMacro("One pixel has " << needed << " fragments, more than the context has memory for; "
                                      "it is left without them. Make the scene simpler");
    this->Exact = false;
    this->ErrorBound = 1.0;
  }
  return needed;
}

//------------------------------------------------------------------------------
void vtkOITABufferPass::Internals::Begin(const vtkOITFrame& frame)
{
  this->HasDepthCopy = false;
  this->Store.Begin(this->Band);
  vtkOpenGLState* state = frame.GLState;
  state->vtkglScissor(this->Band.X, this->Band.Y, this->Band.Width, this->Band.Height);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDepthMask(GL_FALSE);
}

//------------------------------------------------------------------------------
void vtkOITABufferPass::Internals::Resolve(const vtkOITFrame& frame)
{
  if (this->HasDepthCopy)
  {
    this->DepthCopy.Unbind(frame.GLState, DepthUnit);
  }
  constexpr GLbitfield barriers =
    GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
  glMemoryBarrier(barriers);

  const vtkOITSavedState saved(frame.GLState, false); // the next band starts from it
  vtkOpenGLState* state = frame.GLState;
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  if (frame.Target.Samples > 0)
  {
    this->RenderQuad(this->PresortQuad, this->Shaders.GetPresort(), frame.Window);
    glMemoryBarrier(barriers);
  }
  frame.DrawToFirstBufferOnly();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (this->Shaders.FramebufferFetch)
  {
    state->vtkglDisable(GL_BLEND);
  }
  else
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  this->RenderQuad(this->ResolveQuad, this->Shaders.GetResolve(), frame.Window);
}

//------------------------------------------------------------------------------
void vtkOITABufferPass::Internals::RenderQuad(std::unique_ptr<vtkOpenGLQuadHelper>& quad,
  const std::string& fragmentShader, vtkOpenGLRenderWindow* window)
{
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragmentShader.c_str(), nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  }
  if (!quad->Program)
  {
    return; // the shader cache has reported the compiler's message
  }
  this->Store.SetUniforms(quad->Program, this->Band);
  quad->Program->SetUniformi("oitOnce", 1);
  quad->Render();
}

//------------------------------------------------------------------------------
bool vtkOITABufferPass::PostReplaceShaderValues(std::string&, std::string&,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  return this->Impl->Shaders.WrapGather(fragmentShader);
}

//------------------------------------------------------------------------------
bool vtkOITABufferPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  Internals& impl = *this->Impl;
  if (!impl.Frame)
  {
    return true;
  }
  // An actor may have been told to write depth; translucent ones must not.
  impl.Frame->GLState->vtkglDepthMask(GL_FALSE);
  impl.Store.SetUniforms(program, impl.Band);
  if (program->IsUniformUsed("oitOpaqueDepth"))
  {
    if (!impl.HasDepthCopy)
    {
      impl.DepthCopy.Copy(*impl.Frame, DepthUnit);
      impl.HasDepthCopy = true;
    }
    const vtkOITTarget& target = impl.Frame->Target;
    program->SetUniformi("oitOpaqueDepth", DepthUnit);
    program->SetUniformi(
      "oitDepthBits", !target.FloatDepth && target.DepthBits <= 24 ? target.DepthBits : 0);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkOITABufferPass::GetShaderStageMTime()
{
  return this->Impl->ShaderTime.GetMTime();
}
