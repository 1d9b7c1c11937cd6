// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITABufferEngine.h"

#include "Private/ABuffer/vtkOITFragmentReadback.h"
#include "Private/Engine/vtkOITGeometry.h"
#include "Private/Engine/vtkOITPropParts.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "Private/GL/vtkOITOutput.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Fragments per pixel that the first frame has room for, and how many it has at most where it guesses.
constexpr std::int64_t FirstGuess = 4;
constexpr std::int64_t LargestGuess = 8 << 20;

/// Room for a frame of which nothing is known. A closed convex prop covers three quarters of its
/// rectangle twice; pixels leave half of a page of nodes empty. Too little costs a second geometry pass,
/// too much only memory.
std::int64_t GuessFragments(const vtkOITFrame& frame, const vtkOITRectangle& band)
{
  std::int64_t fragments = 2 * band.GetArea();
  for (const vtkOITScreenExtent& extent : frame.Extents)
  {
    fragments += extent.Rectangle.Intersect(band).GetArea() * 3 / 2;
  }
  return std::max(FirstGuess * band.GetArea(), std::min(fragments, LargestGuess));
}

/// List heads that are read by framebuffer fetch lie where the pixels lie in the framebuffer.
std::int64_t GetBytesOfHeadsInTarget(const vtkOITFrame& frame)
{
  const vtkOITRectangle& r = frame.Rectangle;
  return INT64_C(4) * (r.X + r.Width) * (r.Y + r.Height);
}

/// Behind which transmittance layers may be left out. What adds light adds up to any colour, so it is
/// not bounded by the transmittance in front of it.
float FindThreshold(const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  return frame.HasLight ? 0.0f : static_cast<float>(settings.TransmittanceThreshold);
}

/// A depth buffer that tests of a framebuffer of our own can go against.
bool HasOwnDepth(const vtkOITTarget& target)
{
  return target.Samples == 0 && target.Framebuffer != 0 && target.DepthBits > 0;
}
}

//------------------------------------------------------------------------------
std::string vtkOITABufferEngine::GetAlgorithmName(const vtkOITSettings& settings) const
{
  const bool defers =
    this->HasDrawn ? this->Defers : settings.DeferShading == vtkOITSettings::Deferral::Always;
  return defers ? "deferred A-buffer" : "A-buffer";
}

//------------------------------------------------------------------------------
std::string vtkOITABufferEngine::FindMissing(
  const vtkOITCapabilities& capabilities, const vtkOITSettings&) const
{
  return capabilities.GetMissingForStorage();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferEngine::FindMissingIn(const vtkOITFrame& frame) const
{
  return frame.Target.Samples > 0 && !frame.Capabilities->SampleShading
    ? "the framebuffer is multisampled and this context lacks GL_ARB_sample_shading; "
      "call SetMultiSamples(0) of the render window"
    : std::string();
}

//------------------------------------------------------------------------------
void vtkOITABufferEngine::Release()
{
  this->Store.Release();
  this->Regions.Clear();
  this->DepthCopy.Release();
  this->SolidDepth.Release();
  this->Trial.Reset();
  this->Resolver.Release();
  this->Lights.Release();
  this->NumberOfFragments = 0;
}

//------------------------------------------------------------------------------
std::int64_t vtkOITABufferEngine::GetSizeInBytes() const
{
  return this->Store.GetSizeInBytes() + this->DepthCopy.GetSizeInBytes() +
    this->SolidDepth.GetSizeInBytes() + this->Lights.GetSizeInBytes();
}

//------------------------------------------------------------------------------
// Framebuffer fetch saves an atomic a fragment, and leaves all depth tests to the hardware. Its
// heads cover the framebuffer, so it is not for memory that is limited to little more.
void vtkOITABufferEngine::ChooseCapture(const Task& task)
{
  const std::int64_t limit = task.Settings.BufferLimit;
  this->HeadInTarget = this->HeadInTargetWorks && task.Frame.Capabilities->FramebufferFetch &&
    HasOwnDepth(task.Frame.Target) &&
    (limit == 0 || GetBytesOfHeadsInTarget(task.Frame) <= limit / 4);
  this->Store.SetWholeFramebuffer(this->HeadInTarget);
}

//------------------------------------------------------------------------------
void vtkOITABufferEngine::ChooseShaders(const Task& task)
{
  vtkOITABufferShaders& shaders = this->Shaders;
  shaders.Samples = task.Frame.Target.Samples;
  shaders.FloatColor = task.Settings.FloatColor;
  shaders.NodesInImage = this->Store.GetNodesInImage();
  shaders.NodesInTexture = this->Store.GetNodesInTexture();
  shaders.FramebufferFetch = vtkOITWritesByFetch(task.Frame);
  shaders.PostDepthCoverage = task.Frame.Capabilities->PostDepthCoverage;
  shaders.FineDerivatives = task.Frame.Capabilities->FineDerivatives;
  shaders.HeadInTarget = this->HeadInTarget;
  shaders.ClampColor = task.Frame.Target.ClampsColor;
  shaders.LastOnTop = task.Settings.LastOnTop;
  shaders.Interlock =
    shaders.LastOnTop && !this->HeadInTarget && task.Frame.Capabilities->FragmentInterlock;
  shaders.HasLight = task.Frame.HasLight;
  shaders.Volumes = task.Frame.Volumes != nullptr;
  shaders.Deferred = this->Defers;
  shaders.Specular = this->Defers && this->HasSpecular;
  shaders.Physical = this->Defers && this->HasPhysical;
  this->DeferredText.SetTakesPhysical(true);
  this->Gather.SetReplacements(this->Defers ? &this->DeferredText : nullptr);
  this->Gather.SetStage(shaders.GetGather());
  if (shaders.Volumes)
  {
    this->Volumes.SetShaders(shaders);
  }
  this->Resolver.SetShaders(shaders);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITABufferEngine::GetLargestPool(const Task& task) const
{
  const std::int64_t bytes = vtkOITFragmentStore::GetLargestPool(*task.Frame.Capabilities);
  // A single pixel cannot be divided: exactness goes before the limit then.
  if (task.Settings.BufferLimit == 0 || this->Band.GetArea() == 1)
  {
    return bytes;
  }
  // Other bands may be one row higher, and lie otherwise on the tiles.
  vtkOITRectangle highest = this->Band;
  ++highest.Height;
  const std::int64_t heads = this->HeadInTarget ? GetBytesOfHeadsInTarget(task.Frame) : 0;
  const std::int64_t depth =
    this->HeadInTarget ? 0 : vtkOITDepthCopy::GetBytes(highest, task.Frame.Target);
  return std::min(bytes,
    task.Settings.BufferLimit - heads - vtkOITFragmentStore::GetFixedBytes(highest) - depth -
      this->SolidDepth.GetSizeInBytes());
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferEngine::Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
  vtkOITGeometry& geometry, vtkOITStatistics& statistics)
{
  const Task task{ frame, settings, geometry, statistics };
  const std::int64_t limit = settings.BufferLimit;
  std::int64_t largestBand = frame.Rectangle.GetArea();
  if (limit > 0)
  {
    // Three quarters and more of what is allowed are for fragments.
    largestBand = limit / (16 * (1 + std::max(1, frame.Target.Samples)));
    if (this->GetSizeInBytes() > limit)
    {
      this->Store.Release(); // from before the limit was set
      this->DepthCopy.Release();
    }
  }
  this->NumberOfFragments = 0;
  this->Resolver.SetThreshold(FindThreshold(frame, settings));
  this->Gather.SetPassUniforms(
    [this](vtkShaderProgram* program) { this->Store.SetUniforms(program); });
  this->Gather.SetUniforms([this, &task](vtkShaderProgram* program, vtkProp* prop)
    { this->SetUniforms(task, program, prop); });
  this->ChooseCapture(task);
  this->ChooseShading(task);
  this->DrawSolidDepth(task);
  this->Bands.Begin(frame.Rectangle, largestBand);
  vtkOITFailure failure = this->DrawBands(task);
  this->Gather.SetUniforms({});
  this->Gather.SetPassUniforms({});
  if (this->NumberOfFragments < this->Store.GetCapacity() / 2)
  {
    this->Bands.Forget();
  }
  this->Trial.Note(this->NumberOfFragments);
  statistics.SkippedHiddenFragments = this->HasSolidDepth && this->NumberOfFragments > 0;
  this->IsWhole = !failure && this->Band == frame.Rectangle;
  return failure;
}

//------------------------------------------------------------------------------
// A band for which there is no memory is divided like one whose fragments do not fit.
vtkOITFailure vtkOITABufferEngine::DrawBands(const Task& task)
{
  while (this->Bands.GetNext(this->Band))
  {
    std::int64_t needed = 0;
    vtkOITFailure failure = this->DrawBand(task, needed);
    if (failure && failure.IsOfMemory() && this->Bands.Split(2, 1))
    {
      this->Release();
      this->HeadInTarget = false; // its heads cover the framebuffer, not the band
      this->Store.SetWholeFramebuffer(false);
      continue;
    }
    if (failure)
    {
      failure.Undrawn = this->Bands.GetUndrawn();
      this->Release();
      return failure;
    }
    const std::int64_t capacity = this->Store.GetCapacity();
    if (needed <= capacity || !this->Bands.Split(needed, capacity))
    {
      this->Bands.Accept();
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// Where it cannot be made, hidden fragments are not left out of this frame.
void vtkOITABufferEngine::DrawSolidDepth(const Task& task)
{
  this->HasSolidDepth = false;
  const std::int64_t limit = task.Settings.BufferLimit;
  const std::int64_t bytes = vtkOITSolidDepth::GetBytes(task.Frame);
  const std::int64_t held = this->Store.GetSizeInBytes() + this->DepthCopy.GetSizeInBytes();
  const bool hasRoom = limit == 0 || (bytes <= limit / 8 && held + bytes <= limit);
  std::vector<vtkProp*> props;
  // Fragments of opacity 1 pass the test against themselves.
  const vtkOITTarget& target = task.Frame.Target;
  const bool passesItself = target.TestsDepth && target.DepthFunction == GL_LEQUAL;
  if (task.Settings.SkipHiddenFragments && hasRoom && HasOwnDepth(target) && passesItself)
  {
    props = vtkOITFindSolidProps(task.Frame.Props);
  }
  if (!this->Trial.Choose(static_cast<std::int64_t>(props.size())))
  {
    this->SolidDepth.Release();
    return;
  }
  task.Frame.BeginGeometry(task.Frame.Rectangle);
  this->HasSolidDepth = !this->SolidDepth.Render(task.Frame, props, task.Geometry);
}

//------------------------------------------------------------------------------
// Renders the band once or, when the pool is too small and may grow, twice. `needed` are the nodes
// that the band needs: when that is more than the pool has now, nothing was drawn.
vtkOITFailure vtkOITABufferEngine::DrawBand(const Task& task, std::int64_t& needed)
{
  std::int64_t wanted = this->Store.GetCapacity() > 0
    ? std::max(FirstGuess * this->Band.GetArea(), this->Store.GetCapacity())
    : GuessFragments(task.Frame, this->Band);
  wanted = std::max(wanted, this->FindNodesOfRegions(task));
  for (std::int64_t before = -1;;)
  {
    this->ChooseShaders(task);
    if (this->Shaders.HasDrawOrder() && !vtkOITDrawsInOrder(task.Frame.Props))
    {
      return vtkOITFailure(
        "CoincidentLayers LAST_ON_TOP with mappers that draw parts of a prop apart, "
        "for composite data and glyphs, needs GL_EXT_shader_framebuffer_fetch "
        "without multisampling, or GL_ARB_fragment_shader_interlock");
    }
    const std::int64_t largestPool = this->GetLargestPool(task);
    vtkOITFailure failure = this->Store.Reserve(task.Frame.Window, *task.Frame.Capabilities,
      this->Band, wanted, this->Shaders.GetBytesPerNode(), largestPool);
    if (!failure)
    {
      this->ChooseShaders(task); // as the pool is now
      this->ChooseRegions(task);
      failure = this->Capture(task);
    }
    vtkOITFragmentStore::Counters counters;
    if (!failure)
    {
      failure = this->Resolve(task, counters);
    }
    if (failure)
    {
      return failure;
    }
    const std::int64_t capacity = this->Store.GetCapacity();
    if (counters.Overflow && this->Store.GetRegions())
    {
      this->Regions.NoteExceeded(); // so the next turn has none
      needed = counters.NodeCount + OIT_PAGE_SIZE;
      wanted = std::max(wanted, needed + needed / 8);
      continue;
    }
    if (!counters.Overflow)
    {
      this->AddStatistics(task, counters);
      needed = std::min<std::int64_t>(counters.NodeCount, capacity);
      return {};
    }
    // A count that is not beyond the capacity has wrapped around 2^32.
    needed = counters.NodeCount + OIT_PAGE_SIZE;
    needed = needed > capacity ? needed : INT64_C(1) << 32;
    if (this->Store.GetPoolBytes() >= largestPool || capacity <= before)
    {
      break;
    }
    before = capacity;
    wanted = needed + needed / 8; // so that a moving camera does not make every frame grow
  }
  if (this->Band.GetArea() == 1)
  {
    task.Statistics.NoteFault("One pixel has " + std::to_string(needed) +
      " fragments, more than the context has memory for; it is left without them. Make the scene "
      "simpler");
  }
  return {};
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferEngine::Resolve(
  const Task& task, vtkOITFragmentStore::Counters& counters)
{
  task.Frame.BeginOutput(this->Band);
  this->ChooseShaders(task); // with what is known of materials now
  this->Resolver.SetLights(this->Defers ? &this->Lights : nullptr);
  std::string fault;
  bool areDrawn = false;
  std::function<void()> drawVolumes;
  if (task.Frame.Volumes)
  {
    drawVolumes = [&]
    {
      areDrawn = true;
      this->Volumes.Draw(task.Frame, this->Store, FindThreshold(task.Frame, task.Settings));
    };
  }
  vtkOITFailure failure =
    this->Resolver.Resolve(task.Frame, this->Store, counters, fault, drawVolumes);
  if (!fault.empty())
  {
    task.Statistics.NoteFault("Fragments are left out: " + fault);
  }
  if (areDrawn)
  {
    this->Volumes.DrawFailed(task.Frame, this->Store, task.Statistics);
  }
  return failure;
}

//------------------------------------------------------------------------------
void vtkOITABufferEngine::AddStatistics(
  const Task& task, const vtkOITFragmentStore::Counters& counters)
{
  const std::int64_t fragments = this->HeadInTarget ? counters.FragmentCount : counters.NodeCount;
  const auto depthComplexity =
    static_cast<int>(*std::max_element(counters.Tiles.begin(), counters.Tiles.end()));
  this->NumberOfFragments += fragments;
  task.Statistics.SharedAllocations += counters.SharedAllocations;
  if (this->HeadInTarget && this->Band == task.Frame.Rectangle)
  {
    this->Regions.Update(this->Store.GetTileGrid(), counters.TileFragments);
  }
  task.Statistics.NoteFragments(fragments, depthComplexity);
  task.Statistics.NoteError(counters.Skipped);
  if (depthComplexity > vtkOITABufferResolver::LongestList)
  {
    task.Statistics.NoteFault("One pixel has " + std::to_string(depthComplexity) +
      " fragments, more than the " + std::to_string(vtkOITABufferResolver::LongestList) +
      " that can be sorted; its colour is wrong. Make the scene simpler");
  }
}

//------------------------------------------------------------------------------
std::string vtkOITABufferEngine::ReadFragments(vtkFloatArray* fragments) const
{
  const vtkOITFragmentReadback readback(this->Store, this->Shaders);
  return this->NumberOfFragments > 0
    ? readback.Read(this->IsWhole, this->NumberOfFragments, fragments)
    : readback.Refuse(fragments);
}
