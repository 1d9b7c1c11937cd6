// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITPeelingPass.h"

#include "Private/Frame/vtkOITBands.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITSavedState.h"
#include "Private/Peeling/vtkOITPeeler.h"
#include "Private/Peeling/vtkOITPropCulling.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace
{
// Without queries and without a limit; what the sample of Bavoil and Myers starts with.
constexpr int FixedNumberOfPeels = 4;
}

//------------------------------------------------------------------------------
class vtkOITPeelingPass::Internals
{
public:
  bool IsFinished(std::size_t peels, std::size_t expected, std::int64_t fewestPixels);

  std::unique_ptr<vtkOITPeeler> Peeler;
  vtkOITPeelState State;
  vtkOITBands Bands;
  vtkOITPropCulling Culling;
  bool Culls = false;

  /// How the peeling of a band ended in the last frame.
  struct End
  {
    std::size_t Peels = 0;
    bool FirstHadAll = false; // the first peel, not a limit or a threshold
  };
  std::vector<End> Ends;

  const vtkOITPeelContext* Context = nullptr; // during a frame
};

//------------------------------------------------------------------------------
vtkOITPeelingPass::vtkOITPeelingPass(std::unique_ptr<vtkOITPeeler> peeler)
  : Impl(std::make_unique<Internals>())
{
  this->Impl->Peeler = std::move(peeler);
}

//------------------------------------------------------------------------------
vtkOITPeelingPass::~vtkOITPeelingPass() = default;

//------------------------------------------------------------------------------
void vtkOITPeelingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseOcclusionQuery: " << this->UseOcclusionQuery << "\n"
     << indent << "TransmittanceThreshold: " << this->TransmittanceThreshold << "\n"
     << indent << "NumberOfPeels: " << this->NumberOfPeels << "\n"
     << indent << "NumberOfLostFragments: " << this->NumberOfLostFragments << "\n";
}

//------------------------------------------------------------------------------
vtkOITPeeler& vtkOITPeelingPass::GetPeeler() const
{
  return *this->Impl->Peeler;
}

//------------------------------------------------------------------------------
std::string vtkOITPeelingPass::FindMissingCapability(const vtkOITCapabilities& capabilities)
{
  return capabilities.GetMissingForPeeling();
}

//------------------------------------------------------------------------------
std::string vtkOITPeelingPass::FindMissingInTarget(const vtkOITFrame& frame)
{
  return frame.Target.Samples > 0
    ? "peeling keeps one sample a pixel and the framebuffer is multisampled; "
      "call SetMultiSamples(0) of the render window for this method"
    : std::string();
}

//------------------------------------------------------------------------------
void vtkOITPeelingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& impl = *this->Impl;
  impl.State.Release();
  impl.Peeler->Release();
  impl.Culling.Release();
  impl.Ends.clear();
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkOITPeelingPass::SetPeeler(std::unique_ptr<vtkOITPeeler> peeler)
{
  this->Impl->Peeler->Release();
  this->Impl->Peeler = std::move(peeler);
  this->ForgetNumberOfPeels();
}

//------------------------------------------------------------------------------
void vtkOITPeelingPass::ForgetNumberOfPeels()
{
  this->Impl->Ends.clear();
}

//------------------------------------------------------------------------------
void vtkOITPeelingPass::RenderTranslucent(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  impl.Peeler->Prepare(frame, this->FragmentPrecision == FLOAT);
  this->NumberOfPeels = 0;
  this->NumberOfLostFragments = 0;
  std::int64_t largestBand = frame.Rectangle.GetArea();
  if (this->MaximumBufferSize > 0)
  {
    const int bytesPerPixel =
      vtkOITPeelState::GetBytesPerPixel(frame, impl.Peeler->GetLayout(frame)) +
      impl.Peeler->GetBytesPerPixel(frame);
    // A band may get one row more than its share, of which 1 % is for the statistics.
    largestBand = this->MaximumBufferSize * 99 / 100 / bytesPerPixel - frame.Rectangle.Width;
    largestBand = std::clamp<std::int64_t>(largestBand, 1, frame.Rectangle.GetArea());
    if (this->BufferSizeInBytes > this->MaximumBufferSize)
    {
      impl.State.Release(); // from before the limit was set
      impl.Peeler->Release();
    }
  }
  impl.Bands.Begin(frame.Rectangle, largestBand);
  vtkOITRectangle band;
  for (std::size_t number = 0; impl.Bands.GetNext(band); ++number)
  {
    this->RenderBand(frame, band, number);
    impl.Bands.Accept();
  }
  impl.Ends.resize(impl.Bands.GetNumberOfBands());
  impl.Bands.Forget();
  this->BufferSizeInBytes = impl.State.GetSizeInBytes() + impl.Peeler->GetSizeInBytes();
}

//------------------------------------------------------------------------------
void vtkOITPeelingPass::RenderBand(
  vtkOITFrame& frame, const vtkOITRectangle& band, std::size_t number)
{
  Internals& impl = *this->Impl;
  const vtkOITRectangle storage = this->MaximumBufferSize > 0 ? band : frame.FindStorage(band);
  if (impl.Ends.size() <= number)
  {
    impl.Ends.resize(number + 1);
  }
  Internals::End& end = impl.Ends[number];
  const bool expectsAll = this->UseOcclusionQuery && end.FirstHadAll;
  const vtkOITPeelContext context{ frame, impl.State, expectsAll,
    [this, &frame] { this->RenderRemainingGeometry(frame); } };
  impl.Context = &context;
  impl.Culls = this->UseOcclusionQuery && !expectsAll && impl.Peeler->CanCullProps() &&
    frame.GetProps().size() > 1;
  if (impl.Culls)
  {
    impl.Culling.Begin(frame);
  }
  {
    const vtkOITSavedState saved(frame.GLState, false);
    impl.State.Begin(frame, band, storage, impl.Peeler->GetLayout(frame),
      this->TransmittanceThreshold, this->UseOcclusionQuery);
    impl.Peeler->Begin(context);
    this->PeelBand(frame, number);
  }
  if (impl.Culls)
  {
    impl.Culling.End(frame);
  }
  const vtkOITSavedState saved(frame.GLState, false);
  frame.GLState->vtkglEnable(GL_SCISSOR_TEST);
  frame.GLState->vtkglScissor(band.X, band.Y, band.Width, band.Height);
  frame.GLState->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  frame.DrawToFirstBufferOnly();
  if (impl.Peeler->HasAll())
  {
    impl.Peeler->Composite(context);
  }
  else
  {
    impl.State.Composite();
  }
  impl.Context = nullptr;
  const vtkOITPixelStatistics::Result statistics = impl.State.Reduce();
  end.FirstHadAll = end.FirstHadAll && statistics.ErrorBound == 0.0;
  this->NumberOfFragments += statistics.Fragments;
  this->MaximumDepthComplexity = std::max(this->MaximumDepthComplexity, statistics.MostFragments);
  this->NumberOfLostFragments += statistics.Lost;
  this->ErrorBound = std::max(this->ErrorBound, statistics.ErrorBound);
  this->Exact = this->Exact && statistics.ErrorBound == 0.0 && statistics.Lost == 0;
}

//------------------------------------------------------------------------------
void vtkOITPeelingPass::RenderRemainingGeometry(vtkOITFrame& frame)
{
  vtkOITPropCulling& culling = this->Impl->Culling;
  if (!this->Impl->Culls)
  {
    this->RenderGeometry(frame);
  }
  else if (culling.BeginPass(frame))
  {
    this->RenderGeometry(frame);
    culling.EndPass();
  }
}

//------------------------------------------------------------------------------
void vtkOITPeelingPass::PeelBand(vtkOITFrame& frame, std::size_t number)
{
  Internals& impl = *this->Impl;
  vtkOITPeeler& peeler = *impl.Peeler;
  const auto fewestPixels =
    static_cast<std::int64_t>(this->OcclusionRatio * static_cast<double>(frame.Viewport.GetArea()));
  int limit = this->MaximumNumberOfPeels;
  if (!this->UseOcclusionQuery && limit == 0)
  {
    limit = FixedNumberOfPeels;
  }
  const std::size_t setUp = peeler.GetNumberOfSetUpPeels();
  Internals::End& end = impl.Ends[number];
  std::size_t peels = 0;
  bool isFinished = false;
  while (!isFinished && (limit == 0 || peels < setUp + limit))
  {
    peeler.Peel(*impl.Context, static_cast<int>(peels));
    if (peeler.HasAll())
    {
      ++this->NumberOfPeels;
      end = { 1, true };
      return;
    }
    impl.State.Mask(peels);
    ++peels;
    isFinished = this->UseOcclusionQuery && impl.IsFinished(peels, end.Peels, fewestPixels);
  }
  const vtkOITPeelRegion& region = impl.State.GetRegion();
  const bool hasRest = !isFinished || (fewestPixels > 0 && region.GetRemaining(peels - 1) > 0);
  this->NumberOfPeels += static_cast<int>(peels);
  if (this->UseOcclusionQuery)
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
    peeler.PeelRest(*impl.Context);
    ++this->NumberOfPeels;
  }
}

//------------------------------------------------------------------------------
// Waits for the last peel only when it is the one that ended the frame before, or a later one.
bool vtkOITPeelingPass::Internals::IsFinished(
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

//------------------------------------------------------------------------------
bool vtkOITPeelingPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  return this->Impl->Peeler->WrapGather(fragmentShader);
}

//------------------------------------------------------------------------------
bool vtkOITPeelingPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& impl = *this->Impl;
  if (impl.Context)
  {
    if (impl.Culls)
    {
      impl.Culling.Draw(prop);
    }
    // An actor may have been told to write depth; translucent ones must not.
    impl.Context->Frame.GLState->vtkglDepthMask(GL_FALSE);
    impl.Peeler->SetUniforms(program, prop, *impl.Context);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkOITPeelingPass::GetShaderStageMTime()
{
  return this->Impl->Peeler->GetShaderMTime();
}
