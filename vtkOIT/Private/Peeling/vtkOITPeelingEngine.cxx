// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITPeelingEngine.h"

#include "Private/Engine/vtkOITGeometry.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "Private/GL/vtkOITOcclusionQueries.h"
#include "Private/Peeling/vtkOITPeeler.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <utility>

namespace
{
// Without queries and without a limit; what the sample of Bavoil and Myers starts with.
constexpr int FixedNumberOfPeels = 4;

// More than any scene has layers: whatever a driver counts, peeling ends.
constexpr std::size_t MostPeels = 65536;

/// Of pixels in which a peel takes nothing away, see vtkOITPeelStateFS.glsl.
void NoteStall(vtkOITStatistics& statistics)
{
  statistics.NoteFault(
    "Peeling was ended where it took nothing away: a prop draws past the pass. Take "
    "another method, e.g. vtkOITABufferPass");
}
}

//------------------------------------------------------------------------------
vtkOITPeelingEngine::vtkOITPeelingEngine(
  const char* algorithmName, std::unique_ptr<vtkOITPeeler> peeler)
  : AlgorithmName(algorithmName)
  , Peeler(std::move(peeler))
  , Chosen(this->Peeler.get())
{
}

//------------------------------------------------------------------------------
vtkOITPeelingEngine::~vtkOITPeelingEngine() = default;

//------------------------------------------------------------------------------
std::string vtkOITPeelingEngine::FindMissing(
  const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const
{
  const std::string& missing = capabilities.GetMissingForCounting();
  return settings.UseOcclusionQuery && !missing.empty()
    ? missing
    : this->Peeler->FindMissing(capabilities, settings);
}

//------------------------------------------------------------------------------
std::string vtkOITPeelingEngine::FindMissingIn(const vtkOITFrame& frame) const
{
  if (frame.HasLight)
  {
    return "peeling does not sort what adds light, as emissive Gaussians do";
  }
  return frame.Target.Samples > 0
    ? "peeling keeps one sample a pixel and the framebuffer is multisampled; "
      "call SetMultiSamples(0) of the render window for this method"
    : std::string();
}

//------------------------------------------------------------------------------
bool vtkOITPeelingEngine::UsesStorage(
  const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const
{
  return this->Peeler->UsesStorage(capabilities, settings);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITPeelingEngine::GetSizeInBytes() const
{
  return this->State.GetSizeInBytes() + this->Chosen->GetSizeInBytes();
}

//------------------------------------------------------------------------------
void vtkOITPeelingEngine::Release()
{
  this->State.Release();
  this->Chosen->Release();
  this->Culling.Release();
  this->Ends.clear();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelingEngine::Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
  vtkOITGeometry& geometry, vtkOITStatistics& statistics)
{
  if (settings.UseOcclusionQuery && !vtkOITOcclusionQueries::CanCount())
  {
    return vtkOITFailure("the application counts samples while it renders, and by such counts "
                         "peeling ends; end its occlusion query before Render()");
  }
  vtkOITPeeler& peeler = this->ChoosePeeler(frame, settings);
  if (&peeler != this->Chosen)
  {
    this->Chosen->Release();
    this->Chosen = &peeler;
    this->Ends.clear();
  }
  peeler.Prepare(frame, settings);
  std::int64_t largestBand = frame.Rectangle.GetArea();
  if (settings.BufferLimit > 0)
  {
    const int bytesPerPixel = vtkOITPeelState::GetBytesPerPixel(frame, peeler.GetLayout(frame)) +
      peeler.GetBytesPerPixel(frame);
    // A band may get one row more than its share, of which 1 % is for the statistics.
    largestBand = settings.BufferLimit * 99 / 100 / bytesPerPixel - frame.Rectangle.Width;
    largestBand = std::clamp<std::int64_t>(largestBand, 1, frame.Rectangle.GetArea());
    if (this->GetSizeInBytes() > settings.BufferLimit)
    {
      this->State.Release(); // from before the limit was set
      peeler.Release();
    }
  }
  const Task task{ frame, settings, geometry, statistics };
  this->Bands.Begin(frame.Rectangle, largestBand);
  vtkOITFailure failure = this->Bands.DrawAll(
    [&](const vtkOITRectangle& band)
    {
      const std::size_t number = this->Bands.GetNumberOfBands(); // accepted before
      this->Ends.resize(std::max(this->Ends.size(), number + 1));
      return this->DrawBand(task, band, this->Ends[number]);
    },
    [this] { this->Release(); });
  this->Ends.resize(this->Bands.GetNumberOfBands());
  this->Bands.Forget();
  if (!failure && peeler.Note(statistics))
  {
    this->Ends.clear();
  }
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelingEngine::DrawBand(const Task& task, const vtkOITRectangle& band, End& end)
{
  const vtkOITFrame& frame = task.Frame;
  const vtkOITSettings& settings = task.Settings;
  vtkOITPeeler& peeler = *this->Chosen;
  // Where memory is limited, or was not there for more, textures cover the band only.
  const bool isPart = settings.BufferLimit > 0 || !(band == frame.Rectangle);
  const vtkOITRectangle storage = isPart ? band : frame.FindStorage(band);
  const bool expectsAll = settings.UseOcclusionQuery && end.FirstHadAll;
  vtkOITPeelContext context{ frame, this->State, expectsAll, {} };
  context.RenderGeometry = [this, &task, &context] { return this->DrawGeometry(task, context); };
  this->Culls =
    settings.UseOcclusionQuery && !expectsAll && peeler.CanCullProps() && frame.Props.size() > 1;
  if (this->Culls)
  {
    this->Culling.Begin(frame.Window, frame.Props);
  }
  vtkOITFailure failure = this->State.Begin(frame, band, storage, peeler.GetLayout(frame),
    settings.TransmittanceThreshold, settings.UseOcclusionQuery);
  if (!failure)
  {
    failure = peeler.Begin(context);
  }
  if (!failure)
  {
    failure = this->PeelBand(task, context, end);
  }
  return failure ? failure : this->Composite(task, context, band, end);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelingEngine::Composite(
  const Task& task, const vtkOITPeelContext& context, const vtkOITRectangle& band, End& end)
{
  vtkOITPixelStatistics::Result result;
  vtkOITFailure failure = this->State.Reduce(result);
  if (failure)
  {
    return failure;
  }
  task.Frame.BeginOutput(band);
  failure = this->Chosen->HasAll() ? this->Chosen->Composite(context) : this->State.Composite();
  if (failure)
  {
    return failure;
  }
  end.FirstHadAll = end.FirstHadAll && result.ErrorBound == 0.0;
  task.Statistics.NoteFragments(result.Fragments, result.MostFragments);
  task.Statistics.NumberOfLostFragments += result.Lost;
  if (result.ErrorBound >= OIT_STALLED)
  {
    NoteStall(task.Statistics);
  }
  task.Statistics.NoteError(std::min(result.ErrorBound, 1.0));
  task.Statistics.Exact = task.Statistics.Exact && result.Lost == 0;
  return {};
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelingEngine::DrawGeometry(const Task& task, const vtkOITPeelContext& context)
{
  vtkOITGather& gather = this->Chosen->GetGather();
  gather.SetUniforms(
    [this, &context](vtkShaderProgram* program, vtkProp* prop)
    {
      if (this->Culls)
      {
        this->Culling.Draw(prop);
      }
      // An actor may have been told to write depth; translucent ones must not.
      context.Frame.GLState->vtkglDepthMask(GL_FALSE);
      this->Chosen->SetUniforms(program, prop, context);
    });
  const std::vector<vtkProp*> props = this->Culls ? this->Culling.BeginPass() : task.Frame.Props;
  vtkOITFailure failure;
  if (!props.empty())
  {
    failure = task.Geometry.Draw(props, gather);
  }
  if (this->Culls)
  {
    this->Culling.EndPass();
  }
  gather.SetUniforms({});
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelingEngine::PeelBand(
  const Task& task, const vtkOITPeelContext& context, End& end)
{
  vtkOITPeeler& peeler = *this->Chosen;
  const vtkOITSettings& settings = task.Settings;
  const auto fewestPixels = static_cast<std::int64_t>(
    settings.OcclusionRatio * static_cast<double>(task.Frame.Viewport.GetArea()));
  int limit = settings.MaximumNumberOfPeels;
  if (!settings.UseOcclusionQuery && limit == 0)
  {
    limit = FixedNumberOfPeels;
  }
  const std::size_t setUp = peeler.GetNumberOfSetUpPeels();
  std::size_t peels = 0;
  bool isFinished = false;
  const std::size_t most = std::min(limit == 0 ? MostPeels : setUp + limit, MostPeels);
  while (!isFinished && peels < most)
  {
    vtkOITFailure failure = peeler.Peel(context, static_cast<int>(peels));
    if (!failure && peeler.HasAll())
    {
      ++task.Statistics.NumberOfPeels;
      end = { 1, true };
      return {};
    }
    if (!failure && peeler.IsDone())
    {
      task.Statistics.NumberOfPeels += static_cast<int>(peels) + 1;
      end = {};
      return {};
    }
    if (!failure)
    {
      failure = this->State.Mask(peels);
    }
    if (failure)
    {
      return failure;
    }
    ++peels;
    isFinished = settings.UseOcclusionQuery && this->IsFinished(peels, end.Peels, fewestPixels);
    if (this->State.GetRegion().HasFailed())
    {
      return vtkOITFailure("OpenGL has failed to count samples, and by such counts peeling ends");
    }
  }
  const vtkOITPeelRegion& region = this->State.GetRegion();
  const bool hasRest = !isFinished || (fewestPixels > 0 && region.GetRemaining(peels - 1) > 0);
  task.Statistics.NumberOfPeels += static_cast<int>(peels);
  if (!isFinished && most == MostPeels)
  {
    NoteStall(task.Statistics);
  }
  if (settings.UseOcclusionQuery)
  {
    // Fewer may have done, when the result was not there in time.
    while (isFinished && peels > 1 && region.GetRemaining(peels - 2) <= fewestPixels)
    {
      --peels;
    }
    end.Peels = peels;
  }
  end.FirstHadAll = peels == 1 && !hasRest;
  if (hasRest)
  {
    ++task.Statistics.NumberOfPeels;
    return peeler.PeelRest(context);
  }
  return {};
}

//------------------------------------------------------------------------------
// Waits for the last peel only when it is the one that ended the frame before, or a later one.
bool vtkOITPeelingEngine::IsFinished(
  std::size_t peels, std::size_t expected, std::int64_t fewestPixels)
{
  vtkOITPeelRegion& region = this->State.GetRegion();
  for (std::size_t peel = peels; peel-- > 0;)
  {
    const bool isLast = peel + 1 == peels;
    if ((isLast && peels >= expected) || region.IsAvailable(peel))
    {
      if (region.GetRemaining(peel) <= fewestPixels)
      {
        return true;
      }
      region.ShrinkTo(peel);
      return false;
    }
  }
  return false;
}
