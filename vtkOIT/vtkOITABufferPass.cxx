// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITABufferPass.h"

#include "Private/ABuffer/vtkOITABufferResolver.h"
#include "Private/ABuffer/vtkOITABufferShaders.h"
#include "Private/ABuffer/vtkOITFragmentReadback.h"
#include "Private/ABuffer/vtkOITFragmentStore.h"
#include "Private/ABuffer/vtkOITSolidDepth.h"
#include "Private/ABuffer/vtkOITTrial.h"
#include "Private/Frame/vtkOITBands.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITDepthCopy.h"
#include "Private/GL/vtkOITOutput.h"
#include "Private/GL/vtkOITSavedState.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
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

/// List heads that are read by framebuffer fetch lie where the pixels lie in the framebuffer.
std::int64_t GetBytesOfHeadsInTarget(const vtkOITFrame& frame)
{
  const vtkOITRectangle& r = frame.Rectangle;
  return INT64_C(4) * (r.X + r.Width) * (r.Y + r.Height);
}
}

/// What lives from frame to frame, and the band that is being rendered.
class vtkOITABufferPass::Internals
{
public:
  void ChooseShaders(const vtkOITFrame& frame, bool floatColor);
  void ChooseCapture(const vtkOITFrame& frame, vtkTypeInt64 maximumBytes);
  bool Begin(const vtkOITFrame& frame);
  vtkOITFragmentStore::Counters Resolve(const vtkOITFrame& frame);
  std::int64_t GetLargestPool(const vtkOITFrame& frame, std::int64_t maximumBytes) const;

  vtkOITFragmentStore Store;
  vtkOITDepthCopy DepthCopy;
  vtkOITSolidDepth SolidDepth;
  vtkOITTrial Trial; // of leaving out hidden fragments
  vtkOITABufferShaders Shaders;
  vtkTimeStamp ShaderTime;
  vtkOITABufferResolver Resolver;
  vtkOITBands Bands;

  vtkOITRectangle Band;
  const vtkOITFrame* Frame = nullptr;
  bool HasDepthCopy = false;
  bool HasSolidDepth = false; // Gather tests against it instead of the framebuffer's
  bool HeadInTarget = false;  // list heads by framebuffer fetch instead of image atomics
  bool HeadInTargetWorks = true;
  bool IsWhole = false; // the last frame was drawn in one band, which the store still holds
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
  os << indent << "SkipHiddenFragments: " << this->SkipHiddenFragments << "\n"
     << indent << "TransmittanceThreshold: " << this->TransmittanceThreshold << "\n"
     << indent << "SkippedHiddenFragments: " << this->GetSkippedHiddenFragments() << "\n";
}

//------------------------------------------------------------------------------
bool vtkOITABufferPass::GetSkippedHiddenFragments() const
{
  return this->Impl->HasSolidDepth && this->NumberOfFragments > 0;
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
  impl.SolidDepth.Release();
  impl.Trial.Reset();
  impl.Resolver.Release();
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkOITABufferPass::Internals::ChooseShaders(const vtkOITFrame& frame, bool floatColor)
{
  vtkOITABufferShaders shaders;
  shaders.Samples = frame.Target.Samples;
  shaders.FloatColor = floatColor;
  shaders.NodesInImage = this->Store.GetNodesInImage();
  shaders.FramebufferFetch = vtkOITWritesByFetch(frame);
  shaders.PostDepthCoverage = frame.Capabilities->PostDepthCoverage;
  shaders.HeadInTarget = this->HeadInTarget;
  if (shaders != this->Shaders || this->ShaderTime.GetMTime() == 0)
  {
    this->Shaders = shaders;
    this->ShaderTime.Modified();
    this->Resolver.SetShaders(shaders);
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkOITABufferPass::Internals::GetLargestPool(
  const vtkOITFrame& frame, std::int64_t maximumBytes) const
{
  const std::int64_t bytes = vtkOITFragmentStore::GetLargestPool(*frame.Capabilities);
  // A single pixel cannot be divided: exactness goes before the limit then.
  if (maximumBytes == 0 || this->Band.GetArea() == 1)
  {
    return bytes;
  }
  // Other bands may be one row higher, and lie otherwise on the tiles.
  vtkOITRectangle highest = this->Band;
  ++highest.Height;
  const std::int64_t heads = this->HeadInTarget ? GetBytesOfHeadsInTarget(frame) : 0;
  const std::int64_t depth =
    this->HeadInTarget ? 0 : vtkOITDepthCopy::GetBytes(highest, frame.Target);
  return std::min(bytes,
    maximumBytes - heads - vtkOITFragmentStore::GetFixedBytes(highest) - depth -
      this->SolidDepth.GetSizeInBytes());
}

//------------------------------------------------------------------------------
void vtkOITABufferPass::RenderTranslucent(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  impl.Frame = &frame;
  frame.GLState->vtkglEnable(GL_SCISSOR_TEST);
  std::int64_t largestBand = frame.Rectangle.GetArea();
  if (this->MaximumBufferSize > 0)
  {
    // Three quarters and more of what is allowed are for fragments.
    largestBand = this->MaximumBufferSize / (16 * (1 + std::max(1, frame.Target.Samples)));
    if (this->BufferSizeInBytes > this->MaximumBufferSize)
    {
      impl.Store.Release(); // from before the limit was set
      impl.DepthCopy.Release();
    }
  }
  impl.Resolver.SetThreshold(static_cast<float>(this->TransmittanceThreshold));
  impl.ChooseCapture(frame, this->MaximumBufferSize);
  impl.HasSolidDepth = this->DrawSolidDepth(frame);
  impl.Bands.Begin(frame.Rectangle, largestBand);
  while (impl.Bands.GetNext(impl.Band))
  {
    const std::int64_t needed = this->RenderBand(frame);
    const std::int64_t capacity = impl.Store.GetCapacity();
    if (needed <= capacity || !impl.Bands.Split(needed, capacity))
    {
      impl.Bands.Accept();
    }
  }
  if (this->NumberOfFragments < impl.Store.GetCapacity() / 2)
  {
    impl.Bands.Forget();
  }
  impl.Trial.Note(this->NumberOfFragments);
  this->BufferSizeInBytes = impl.Store.GetSizeInBytes() + impl.DepthCopy.GetSizeInBytes() +
    impl.SolidDepth.GetSizeInBytes();
  impl.IsWhole = impl.Band == frame.Rectangle;
  impl.Frame = nullptr;
}

//------------------------------------------------------------------------------
// False when hidden fragments are not left out of this frame.
bool vtkOITABufferPass::DrawSolidDepth(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  const std::int64_t bytes = vtkOITSolidDepth::GetBytes(frame);
  const std::int64_t held = impl.Store.GetSizeInBytes() + impl.DepthCopy.GetSizeInBytes();
  const bool hasRoom = this->MaximumBufferSize == 0 ||
    (bytes <= this->MaximumBufferSize / 8 && held + bytes <= this->MaximumBufferSize);
  std::vector<vtkProp*> props;
  if (this->SkipHiddenFragments && hasRoom && frame.Target.Samples == 0 &&
    frame.Target.Framebuffer != 0 && frame.Target.DepthBits > 0)
  {
    props = vtkOITFindSolidProps(frame.GetProps());
  }
  if (!impl.Trial.Choose(static_cast<std::int64_t>(props.size())))
  {
    impl.SolidDepth.Release();
    return false;
  }
  ++this->NumberOfGeometryPasses;
  return impl.SolidDepth.Render(frame, this->TranslucentPass, props, DepthUnit);
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
    const std::int64_t largestPool = impl.GetLargestPool(frame, this->MaximumBufferSize);
    impl.Store.Reserve(frame.Window, *frame.Capabilities, impl.Band, wanted,
      impl.Shaders.GetBytesPerNode(), largestPool);
    impl.ChooseShaders(frame, this->FragmentPrecision == FLOAT); // as the pool is now
    if (!impl.Begin(frame))
    {
      impl.ChooseCapture(frame, this->MaximumBufferSize);
      continue;
    }
    this->RenderGeometry(frame);
    const vtkOITFragmentStore::Counters counters = impl.Resolve(frame);
    const std::int64_t capacity = impl.Store.GetCapacity();
    if (!counters.Overflow)
    {
      const std::int64_t nodes = counters.NodeCount;
      this->AddStatistics(impl.HeadInTarget ? counters.FragmentCount : nodes,
        *std::max_element(counters.Tiles.begin(), counters.Tiles.end()), counters.Skipped);
      return std::min(nodes, capacity);
    }
    // A count that is not beyond the capacity has wrapped around 2^32.
    needed = std::int64_t(counters.NodeCount) + vtkOITFragmentStore::PageSize;
    needed = needed > capacity ? needed : INT64_C(1) << 32;
    if (impl.Store.GetPoolBytes() >= largestPool || capacity <= before)
    {
      break;
    }
    before = capacity;
    wanted = needed + needed / 8; // so that a moving camera does not make every frame grow
  }
  if (impl.Band.GetArea() == 1)
  {
    vtkErrorMacro("One pixel has " << needed
                                   << " fragments, more than the context has memory for; "
                                      "it is left without them. Make the scene simpler");
    this->Exact = false;
    this->ErrorBound = 1.0;
  }
  return needed;
}

//------------------------------------------------------------------------------
// Framebuffer fetch saves an atomic a fragment, and leaves all depth tests to the hardware. Its
// heads cover the framebuffer, so it is not for memory that is limited to little more.
void vtkOITABufferPass::Internals::ChooseCapture(
  const vtkOITFrame& frame, vtkTypeInt64 maximumBytes)
{
  this->HeadInTarget = this->HeadInTargetWorks && frame.Capabilities->FramebufferFetch &&
    frame.Target.Samples == 0 && frame.Target.Framebuffer != 0 && frame.Target.DepthBits > 0 &&
    (maximumBytes == 0 || GetBytesOfHeadsInTarget(frame) <= maximumBytes / 4);
  this->Store.SetWholeFramebuffer(this->HeadInTarget);
}

//------------------------------------------------------------------------------
// False when the framebuffer of the list heads cannot be made; then it is not tried again.
bool vtkOITABufferPass::Internals::Begin(const vtkOITFrame& frame)
{
  this->HasDepthCopy = false;
  this->Store.Begin(this->Band);
  vtkOpenGLState* state = frame.GLState;
  state->vtkglScissor(this->Band.X, this->Band.Y, this->Band.Width, this->Band.Height);
  const GLboolean writesHeads = this->HeadInTarget ? GL_TRUE : GL_FALSE;
  state->vtkglColorMask(writesHeads, writesHeads, writesHeads, writesHeads);
  state->vtkglDepthMask(GL_FALSE);
  if (this->HasSolidDepth)
  {
    this->SolidDepth.Bind(frame);
  }
  if (this->HeadInTarget && !this->Store.BindHeadFramebuffer(state))
  {
    this->HeadInTargetWorks = false;
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame.Target.Framebuffer);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
// Draws nothing when the store has overflowed.
vtkOITFragmentStore::Counters vtkOITABufferPass::Internals::Resolve(const vtkOITFrame& frame)
{
  if (this->HasDepthCopy)
  {
    this->DepthCopy.Unbind(frame.GLState, DepthUnit);
  }
  if (this->HeadInTarget || this->HasSolidDepth)
  {
    frame.GLState->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame.Target.Framebuffer);
  }
  const vtkOITSavedState saved(frame.GLState, false); // the next band starts from it
  frame.GLState->vtkglDisable(GL_DEPTH_TEST);
  frame.GLState->vtkglDisable(GL_CULL_FACE);
  return this->Resolver.Resolve(frame, this->Store);
}

//------------------------------------------------------------------------------
void vtkOITABufferPass::AddStatistics(
  vtkTypeInt64 fragments, vtkTypeInt64 depthComplexity, double skipped)
{
  this->Exact = this->Exact && skipped == 0.0;
  this->ErrorBound = std::max(this->ErrorBound, skipped);
  this->NumberOfFragments += fragments;
  this->MaximumDepthComplexity =
    std::max(this->MaximumDepthComplexity, static_cast<int>(depthComplexity));
  if (depthComplexity > vtkOITABufferResolver::LongestList)
  {
    vtkErrorMacro("One pixel has " << depthComplexity << " fragments, more than the "
                                   << vtkOITABufferResolver::LongestList
                                   << " that can be sorted; its colour is wrong. Make the scene "
                                      "simpler");
    this->Exact = false;
    this->ErrorBound = 1.0;
  }
}

//------------------------------------------------------------------------------
bool vtkOITABufferPass::GetFragments(vtkFloatArray* fragments)
{
  const Internals& impl = *this->Impl;
  const bool isMine = std::string(this->GetAlgorithmName()) == this->GetOwnAlgorithmName();
  const vtkOITFragmentReadback readback(impl.Store, impl.Shaders);
  const std::string reason = isMine && this->NumberOfFragments > 0
    ? readback.Read(impl.IsWhole, this->NumberOfFragments, fragments)
    : readback.Refuse(fragments);
  if (!reason.empty())
  {
    vtkErrorMacro(<< reason);
  }
  return reason.empty();
}

//------------------------------------------------------------------------------
bool vtkOITABufferPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
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
  impl.Store.SetUniforms(program);
  if (program->IsUniformUsed("oitOpaqueDepth"))
  {
    if (!impl.HasDepthCopy)
    {
      impl.DepthCopy.Copy(*impl.Frame, impl.Band, impl.Band, DepthUnit);
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
