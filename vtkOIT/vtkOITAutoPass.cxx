// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITAutoPass.h"

#include "Private/Auto/vtkOITBlendPlan.h"
#include "Private/Auto/vtkOITDepthCheck.h"
#include "Private/Auto/vtkOITFrameSignature.h"
#include "Private/Auto/vtkOITMeshShapes.h"
#include "Private/Auto/vtkOITSorterChoice.h"
#include "Private/Blending/vtkOITLayerTarget.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITScreenExtents.h"
#include "Private/GL/vtkOITOutput.h"
#include "Private/GL/vtkOITSavedState.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOITABufferPass.h"
#include "vtkOITBlendBesideFS.h"
#include "vtkOITBlendFS.h"
#include "vtkOITFragmentFS.h"
#include "vtkOITOutputFS.h"
#include "vtkOITPeelingPass.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <memory>

vtkStandardNewMacro(vtkOITAutoPass);

namespace
{
constexpr vtkTypeInt64 LargestDefault = INT64_C(1) << 30; // 1 GiB
constexpr vtkTypeInt64 SmallestLimit = INT64_C(1) << 20;  // that passes take

/// Each layer that is blended with another buffer beside costs more than into the float32 layer
/// alone; with more layers than this, more than the stage that composites it.
constexpr int MostLayersBeside = 3;

/// Nothing of it is seen wherever it is. Edges have an opacity of their own from VTK 9.3 on.
bool HasNoOpacity(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && actor->GetProperty()->GetOpacity() <= 0.0 && vtkOITFindPlainActor(prop) &&
    !actor->GetProperty()->GetEdgeVisibility() &&
    (!actor->GetBackfaceProperty() || actor->GetBackfaceProperty()->GetOpacity() <= 0.0);
}

/// What a frame said about itself, for frames that show its layer again.
struct Statistics
{
  vtkTypeInt64 NumberOfFragments = 0;
  int MaximumDepthComplexity = 0;
  bool Exact = true;
  double ErrorBound = 0.0;
  std::string Algorithm;
};
}

//------------------------------------------------------------------------------
class vtkOITAutoPass::Internals
{
public:
  void AddToSummary(const std::string& what)
  {
    this->Summary += (this->Summary.empty() ? "" : "; ") + what;
  }

  /// Releases what is left over from other frames until `needed` bytes more than what stays for
  /// sorting, `forSorting`, are free. False when that cannot be.
  bool MakeRoom(
    vtkOITFrame& frame, vtkTypeInt64 needed, vtkTypeInt64 forSorting, vtkTypeInt64 limit);

  vtkOITMeshShapes Shapes;
  vtkOITLayerTarget Layer;
  vtkOITDepthCheck DepthCheck;
  vtkOITSorterChoice Sorters;
  vtkOITFrameSignature Signature; // of the last frame
  bool HasLayer = false;          // the layer of a frame with that signature
  Statistics LayerStatistics;
  std::vector<vtkOITScreenExtent> Extents; // of the frame's props

  // While props are blended:
  vtkOITFrame* Frame = nullptr;
  const vtkOITBlendPlan* Plan = nullptr;
  vtkOITBlendPlan::Faces Side = vtkOITBlendPlan::Faces::All;
  bool BlendsByFetch = false;
  bool BlendsBeside = false; // into the framebuffer, with the layer beside it
  bool ShadersBeside = false;
  vtkTimeStamp ShaderTime;

  std::string Summary;
  std::string Choice;
  vtkTypeInt64 Limit = LargestDefault; // that holds for the last frame
};

//------------------------------------------------------------------------------
bool vtkOITAutoPass::Internals::MakeRoom(
  vtkOITFrame& frame, vtkTypeInt64 needed, vtkTypeInt64 forSorting, vtkTypeInt64 limit)
{
  if (this->Layer.GetSizeInBytes() + this->DepthCheck.GetSizeInBytes() > limit - forSorting)
  {
    this->Layer.Release();
    this->DepthCheck.Release();
  }
  const bool isFree = needed <= limit - forSorting;
  if (isFree && forSorting == 0 && needed + this->Sorters.GetSizeInBytes() > limit)
  {
    this->Sorters.Release(frame.Window);
  }
  return isFree;
}

//------------------------------------------------------------------------------
vtkOITAutoPass::vtkOITAutoPass()
  : Impl(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkOITAutoPass::~vtkOITAutoPass() = default;

//------------------------------------------------------------------------------
void vtkOITAutoPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SkipInvisibleProps: " << this->SkipInvisibleProps << "\n"
     << indent << "SkipSorting: " << this->SkipSorting << "\n"
     << indent << "SkipHiddenFragments: " << this->SkipHiddenFragments << "\n"
     << indent << "ReuseFrames: " << this->ReuseFrames << "\n"
     << indent << "TransmittanceThreshold: " << this->TransmittanceThreshold << "\n"
     << indent << "BufferLimit: " << this->GetBufferLimit() << "\n"
     << indent << "Choice: " << this->GetChoice() << "\n"
     << indent << "SkipSummary: " << this->GetSkipSummary() << "\n";
}

//------------------------------------------------------------------------------
std::string vtkOITAutoPass::GetSkipSummary() const
{
  return this->Impl->Summary;
}

//------------------------------------------------------------------------------
std::string vtkOITAutoPass::GetChoice() const
{
  return this->Impl->Choice;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkOITAutoPass::GetBufferLimit() const
{
  return this->MaximumBufferSize > 0 ? this->MaximumBufferSize : this->Impl->Limit;
}

//------------------------------------------------------------------------------
std::string vtkOITAutoPass::FindMissingCapability(const vtkOITCapabilities& capabilities)
{
  return capabilities.HasStorage() ? std::string() : capabilities.GetMissingForPeeling();
}

//------------------------------------------------------------------------------
std::string vtkOITAutoPass::FindMissingInTarget(const vtkOITFrame& frame)
{
  return frame.Target.Samples > 0 ? frame.Capabilities->GetMissingForStorage() : std::string();
}

//------------------------------------------------------------------------------
void vtkOITAutoPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& impl = *this->Impl;
  impl.Layer.Release();
  impl.DepthCheck.Release();
  impl.Sorters.Release(window);
  impl.HasLayer = false;
  impl.Signature = {};
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkOITAutoPass::RenderTranslucent(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  impl.Summary.clear();
  impl.Choice.clear();
  const vtkTypeInt64 memory = frame.Capabilities->Memory; // 0 when not known
  impl.Limit = memory > 0 ? std::min(LargestDefault, memory / 4) : LargestDefault;
  impl.Extents = frame.Extents;
  if (this->SkipInvisibleProps)
  {
    this->DropInvisibleProps(frame);
  }
  // It is not known what other delegates draw.
  const bool isKnown =
    this->ReuseFrames && this->TranslucentPass->GetClassName() == std::string("vtkTranslucentPass");
  const vtkOITFrameSignature signature =
    isKnown ? vtkOITFrameSignature(frame, this->GetMTime()) : vtkOITFrameSignature();
  const bool isStill = signature == impl.Signature;
  if (!frame.GetProps().empty() && !(isStill && this->ReuseFrame(frame)))
  {
    impl.Signature = signature;
    impl.HasLayer = false;
    this->DrawProps(frame, isStill);
  }
  this->BufferSizeInBytes =
    impl.Layer.GetSizeInBytes() + impl.DepthCheck.GetSizeInBytes() + impl.Sorters.GetSizeInBytes();
}

//------------------------------------------------------------------------------
void vtkOITAutoPass::DropInvisibleProps(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  std::vector<vtkProp*> props;
  std::vector<vtkOITScreenExtent> extents;
  for (std::size_t i = 0; i < impl.Extents.size(); ++i)
  {
    vtkOITScreenExtent& extent = impl.Extents[i];
    extent.Rectangle = extent.Rectangle.Intersect(frame.Rectangle);
    if (!extent.Rectangle.IsEmpty() && !HasNoOpacity(frame.GetProps()[i]))
    {
      props.push_back(frame.GetProps()[i]);
      extents.push_back(extent);
    }
  }
  if (props.size() < impl.Extents.size())
  {
    impl.AddToSummary(std::to_string(impl.Extents.size() - props.size()) + " of " +
      std::to_string(impl.Extents.size()) + " props left out: invisible");
  }
  impl.Extents.swap(extents);
  frame.Rectangle = vtkOITFindScreenRectangle(impl.Extents).Intersect(frame.Rectangle);
  frame.DrawOnly(std::move(props));
}

//------------------------------------------------------------------------------
bool vtkOITAutoPass::ReuseFrame(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  if (!impl.HasLayer || !impl.DepthCheck.IsUnchanged(frame))
  {
    return false;
  }
  impl.Layer.Composite(frame);
  const Statistics& kept = impl.LayerStatistics;
  this->NumberOfFragments = kept.NumberOfFragments;
  this->MaximumDepthComplexity = kept.MaximumDepthComplexity;
  this->Exact = kept.Exact;
  this->ErrorBound = kept.ErrorBound;
  this->SetAlgorithmName(kept.Algorithm.c_str());
  impl.Choice = "nothing has changed since the last frame";
  impl.AddToSummary("whole frame reused");
  return true;
}

//------------------------------------------------------------------------------
// Into the framebuffer, or all into a layer that is composited: when the layer is to be kept, and
// when blending several layers in 8 bits would round each. The layer gives the same picture to the
// last bit in float framebuffers, so it is taken there, too. Few layers are blended into the
// framebuffer with the layer beside it where that can be.
void vtkOITAutoPass::DrawProps(vtkOITFrame& frame, bool keepsLayer)
{
  Internals& impl = *this->Impl;
  std::unique_ptr<vtkOITBlendPlan> plan;
  if (this->SkipSorting)
  {
    plan = std::make_unique<vtkOITBlendPlan>(frame, impl.Extents, impl.Shapes);
  }
  const bool needsLayer = plan && plan->GetMaximumLayers() > 1;
  const vtkTypeInt64 limit = this->GetBufferLimit();
  const bool sorts = !plan || !plan->GetSortedProps().empty();
  const vtkTypeInt64 forSorting = sorts ? std::max(limit / 2, SmallestLimit) : 0;
  const vtkTypeInt64 forLayer = vtkOITLayerTarget::GetBytes(frame, frame.Rectangle);
  const vtkTypeInt64 forDepth = vtkOITDepthCheck::GetBytes(frame);
  keepsLayer = keepsLayer && forLayer + forDepth <= limit - forSorting;
  const vtkTypeInt64 needed =
    (needsLayer || keepsLayer ? forLayer : 0) + (keepsLayer ? forDepth : 0);
  impl.BlendsBeside = false;
  bool hasLayer = impl.MakeRoom(frame, needed, forSorting, limit) && needed > 0 &&
    frame.Target.Samples == 0 && frame.Target.DepthBits > 0;
  if (hasLayer)
  {
    if (keepsLayer)
    {
      impl.DepthCheck.Keep(frame);
    }
    impl.BlendsBeside = !keepsLayer && vtkOITWritesByFetch(frame) &&
      plan->GetMaximumLayers() <= MostLayersBeside &&
      impl.Layer.BeginBeside(frame, plan->GetBlendRectangle().Intersect(frame.Rectangle));
    hasLayer = impl.BlendsBeside || impl.Layer.Begin(frame, frame.Rectangle);
  }
  if (needsLayer && !hasLayer)
  {
    impl.MakeRoom(frame, 0, SmallestLimit, limit);
    plan.reset();
  }
  const vtkOITRectangle whole = frame.Rectangle;
  if (plan)
  {
    if (plan->GetNumberOfBlendedProps() > 0)
    {
      impl.AddToSummary(std::to_string(plan->GetNumberOfBlendedProps()) + " of " +
        std::to_string(frame.GetProps().size()) + " props blended: their order is known");
      this->BlendProps(frame, *plan);
    }
    if (impl.BlendsBeside)
    {
      impl.Layer.End(frame);
      hasLayer = false;
    }
    frame.DrawOnly(plan->GetSortedProps());
    frame.Rectangle = plan->GetSortedRectangle().Intersect(whole);
  }
  if (!frame.GetProps().empty() && !frame.Rectangle.IsEmpty())
  {
    this->SortProps(frame);
  }
  if (plan && plan->GetNumberOfBlendedProps() > 0)
  {
    this->NumberOfFragments = -1;
    this->MaximumDepthComplexity = -1;
  }
  if (hasLayer)
  {
    impl.Layer.End(frame);
    impl.Layer.Composite(frame);
    impl.HasLayer = keepsLayer;
    impl.LayerStatistics = { this->NumberOfFragments, this->MaximumDepthComplexity, this->Exact,
      this->ErrorBound, this->GetAlgorithmName() };
  }
}

//------------------------------------------------------------------------------
void vtkOITAutoPass::BlendProps(vtkOITFrame& frame, const vtkOITBlendPlan& plan)
{
  Internals& impl = *this->Impl;
  vtkOpenGLState* state = frame.GLState;
  const vtkOITSavedState saved(state, false);
  const bool byFetch = vtkOITWritesByFetch(frame);
  if (byFetch != impl.BlendsByFetch || impl.BlendsBeside != impl.ShadersBeside ||
    impl.ShaderTime.GetMTime() == 0)
  {
    impl.BlendsByFetch = byFetch;
    impl.ShadersBeside = impl.BlendsBeside;
    impl.ShaderTime.Modified();
  }
  const vtkOITRectangle r = plan.GetBlendRectangle().Intersect(frame.Rectangle);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(r.X, r.Y, r.Width, r.Height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (!impl.BlendsBeside)
  {
    frame.DrawToFirstBufferOnly();
  }
  vtkOITSetOutputBlending(state, byFetch);
  impl.Frame = &frame;
  impl.Plan = &plan;
  for (const vtkOITBlendPlan::Step& step : plan.GetSteps())
  {
    impl.Side = step.Side;
    frame.DrawOnly(step.Props);
    const bool isTop =
      impl.BlendsBeside && plan.EndsWithTopLayers() && &step == &plan.GetSteps().back();
    if (isTop)
    {
      vtkOITLayerTarget::WriteBeside(false);
    }
    this->RenderGeometry(frame);
    if (isTop)
    {
      vtkOITLayerTarget::WriteBeside(true);
    }
  }
  impl.Plan = nullptr;
  impl.Frame = nullptr;
  impl.Choice = "the order of all props is known";
  this->SetAlgorithmName("ordered blending");
}

//------------------------------------------------------------------------------
void vtkOITAutoPass::SortProps(vtkOITFrame& frame)
{
  Internals& impl = *this->Impl;
  const vtkTypeInt64 limit =
    this->GetBufferLimit() - impl.Layer.GetSizeInBytes() - impl.DepthCheck.GetSizeInBytes();
  const auto findMissing = [this, &frame](vtkOITPass& candidate)
  {
    return this->FragmentPrecision == FLOAT && candidate.IsA("vtkOITMultiLayerPeelingPass")
      ? std::string("it keeps half floats")
      : FindMissing(candidate, frame);
  };
  vtkOITPass& pass = impl.Sorters.Choose(limit, findMissing);
  impl.Sorters.ReleaseUnused(frame.Window);
  if (auto* peeling = vtkOITPeelingPass::SafeDownCast(&pass))
  {
    peeling->SetTransmittanceThreshold(this->TransmittanceThreshold);
    peeling->SetMaximumNumberOfPeels(this->MaximumNumberOfPeels);
    peeling->SetOcclusionRatio(this->OcclusionRatio);
  }
  auto* abuffer = vtkOITABufferPass::SafeDownCast(&pass);
  if (abuffer)
  {
    abuffer->SetSkipHiddenFragments(this->SkipHiddenFragments);
    abuffer->SetTransmittanceThreshold(this->TransmittanceThreshold);
  }
  this->RenderBy(pass, frame);
  if (abuffer && abuffer->GetSkippedHiddenFragments())
  {
    impl.AddToSummary("fragments behind those of opacity 1 left out");
  }
  impl.Sorters.Note(pass);
  impl.Choice = impl.Sorters.GetReason();
}

//------------------------------------------------------------------------------
bool vtkOITAutoPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  std::string stage = std::string(vtkOITFragmentFS) + vtkOITBlendFS;
  const Internals& impl = *this->Impl;
  vtkOITReplace(
    stage, "//VTK::OIT::Output", impl.ShadersBeside ? vtkOITBlendBesideFS : vtkOITOutputFS);
  std::string header = vtkOITGetOutputHeader(impl.BlendsByFetch);
  if (impl.ShadersBeside)
  {
    header = vtkOITLayerTarget::GetHeaderBeside() + header;
  }
  if (vtkOITWritesDepth(fragmentShader))
  {
    header += "#define OIT_WRITES_DEPTH\n";
  }
  return vtkOITWrapFragmentShader(fragmentShader, header, stage);
}

//------------------------------------------------------------------------------
bool vtkOITAutoPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  const Internals& impl = *this->Impl;
  if (!impl.Frame)
  {
    return true;
  }
  if (impl.ShadersBeside)
  {
    impl.Layer.SetUniformsBeside(program);
  }
  vtkOpenGLState* state = impl.Frame->GLState;
  // An actor may have been told to write depth; translucent ones must not.
  state->vtkglDepthMask(GL_FALSE);
  if (impl.Side != vtkOITBlendPlan::Faces::All)
  {
    const bool cullsFront =
      (impl.Side == vtkOITBlendPlan::Faces::Far) != impl.Plan->IsInsideOut(prop);
    state->vtkglEnable(GL_CULL_FACE);
    state->vtkglCullFace(cullsFront ? GL_FRONT : GL_BACK);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkOITAutoPass::GetShaderStageMTime()
{
  return this->Impl->ShaderTime.GetMTime();
}
