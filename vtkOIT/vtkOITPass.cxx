// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITPass.h"

#include "Private/Engine/vtkOITDelegate.h"
#include "Private/Engine/vtkOITEngine.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "Private/GL/vtkOITAllocation.h"
#include "Private/GL/vtkOITSavedState.h"
#include "Private/Plan/vtkOITPlan.h"
#include "Private/Plan/vtkOITPlanRunner.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkTranslucentPass.h"

#include <set>
#include <utility>

//------------------------------------------------------------------------------
class vtkOITPass::Internals
{
public:
  explicit Internals(std::unique_ptr<vtkOITEngine> engine)
    : Engine(std::move(engine))
    , Runner(this->Engine.get())
  {
  }

  const vtkOITCapabilities& QueryCapabilities(vtkOpenGLRenderWindow* window)
  {
    if (!this->Capabilities || this->CapabilitiesWindow != window)
    {
      this->Capabilities = std::make_unique<vtkOITCapabilities>(window);
      this->CapabilitiesWindow = window;
    }
    return *this->Capabilities;
  }

  std::unique_ptr<vtkOITEngine> Engine; // of the subclass's method, may be nullptr
  vtkOITPlanRunner Runner;
  vtkOITStatistics Statistics;                      // of the last frame
  std::unique_ptr<vtkOITCapabilities> Capabilities; // of CapabilitiesWindow
  vtkOpenGLRenderWindow* CapabilitiesWindow = nullptr;
  std::set<std::string> Reported; // so that each line is printed once, not every frame
};

//------------------------------------------------------------------------------
vtkOITPass::vtkOITPass(std::unique_ptr<vtkOITEngine> engine)
  : TranslucentPass(vtkSmartPointer<vtkTranslucentPass>::New())
  , Impl(std::make_unique<Internals>(std::move(engine)))
{
}

//------------------------------------------------------------------------------
vtkOITPass::~vtkOITPass() = default;

//------------------------------------------------------------------------------
void vtkOITPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TranslucentPass: " << this->TranslucentPass.Get() << "\n"
     << indent << "TransmittanceThreshold: " << this->TransmittanceThreshold << "\n"
     << indent << "MaximumNumberOfPeels: " << this->MaximumNumberOfPeels << "\n"
     << indent << "OcclusionRatio: " << this->OcclusionRatio << "\n"
     << indent << "MaximumBufferSize: " << this->MaximumBufferSize << "\n"
     << indent << "FragmentPrecision: " << (this->FragmentPrecision == HALF ? "half" : "float")
     << "\n"
     << indent << "AlgorithmName: " << this->GetAlgorithmName() << "\n"
     << indent << "NumberOfGeometryPasses: " << this->GetNumberOfGeometryPasses() << "\n"
     << indent << "NumberOfFragments: " << this->GetNumberOfFragments() << "\n"
     << indent << "MaximumDepthComplexity: " << this->GetMaximumDepthComplexity() << "\n"
     << indent << "BufferSizeInBytes: " << this->GetBufferSizeInBytes() << "\n"
     << indent << "Exact: " << this->GetExact() << "\n"
     << indent << "ErrorBound: " << this->GetErrorBound() << "\n";
}

//------------------------------------------------------------------------------
vtkOITEngine* vtkOITPass::GetEngine() const
{
  return this->Impl->Engine.get();
}

//------------------------------------------------------------------------------
std::string vtkOITPass::GetMissingCapability(vtkOpenGLRenderWindow* window)
{
  if (window && !window->GetNeverRendered())
  {
    window->MakeCurrent();
  }
  const vtkOITCapabilities capabilities(window);
  return this->Impl->Runner.GetSorters().FindMissing(
    capabilities, this->MakeSettings(capabilities));
}

//------------------------------------------------------------------------------
vtkOITSettings vtkOITPass::MakeSettings(const vtkOITCapabilities&) const
{
  vtkOITSettings settings;
  settings.TransmittanceThreshold = this->TransmittanceThreshold;
  settings.FloatColor = this->FragmentPrecision == FLOAT;
  settings.BufferLimit = this->MaximumBufferSize;
  settings.MaximumNumberOfPeels = this->MaximumNumberOfPeels;
  settings.OcclusionRatio = this->OcclusionRatio;
  settings.Time = const_cast<vtkOITPass*>(this)->GetMTime();
  return settings;
}

//------------------------------------------------------------------------------
vtkOITPlan vtkOITPass::MakePlan(const vtkOITFrame& frame, const vtkOITSettings&)
{
  vtkOITPlan plan;
  plan.Frame = frame;
  return plan;
}

//------------------------------------------------------------------------------
void vtkOITPass::Render(const vtkRenderState* state)
{
  this->ResetStatistics();
  if (!this->TranslucentPass)
  {
    vtkErrorMacro("No TranslucentPass is set; give one with SetTranslucentPass(), e.g. a "
                  "vtkTranslucentPass");
    return;
  }
  if (state->GetRenderer()->GetSelector())
  {
    // A selector draws identifiers, not colours: nothing to sort.
    this->TranslucentPass->Render(state);
    this->NumberOfRenderedProps = this->TranslucentPass->GetNumberOfRenderedProps();
    return;
  }
  std::vector<vtkProp*> props = vtkOITFindTranslucentProps(state);
  if (props.empty())
  {
    return;
  }
  if (vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetVTKWindow()))
  {
    this->Draw(state, std::move(props));
  }
  else
  {
    this->DrawUnsorted(state, "the renderer's window is not a vtkOpenGLRenderWindow");
  }
  this->Report();
}

//------------------------------------------------------------------------------
void vtkOITPass::Draw(const vtkRenderState* state, std::vector<vtkProp*> props)
{
  Internals& impl = *this->Impl;
  vtkOITAllocation::TakeErrors();
  vtkOITFrame frame;
  frame.Renderer = state->GetRenderer();
  frame.Window = vtkOpenGLRenderWindow::SafeDownCast(frame.Renderer->GetVTKWindow());
  frame.GLState = frame.Window->GetState();
  frame.Capabilities = &impl.QueryCapabilities(frame.Window);
  frame.Target = vtkOITTarget::Query();
  vtkOITSavedState saved(frame.GLState, frame.Target);
  frame.Viewport = saved.GetViewport();
  frame.Props = std::move(props);
  frame.Extents = vtkOITFindScreenExtents(frame.Renderer, frame.Props, frame.Viewport);
  frame.Rectangle = vtkOITFindScreenRectangle(frame.Extents).Intersect(saved.GetDrawnRectangle());
  if (frame.Rectangle.IsEmpty())
  {
    return;
  }
  vtkOITDelegate delegate(this->TranslucentPass, state);
  const vtkOITSettings settings = this->MakeSettings(*frame.Capabilities);
  impl.Runner.Run(this->MakePlan(frame, settings), settings, delegate, saved, impl.Statistics);
  impl.Statistics.NumberOfGeometryPasses = delegate.GetNumberOfPasses();
  this->NumberOfRenderedProps = delegate.GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkOITPass::DrawUnsorted(const vtkRenderState* state, const std::string& reason)
{
  this->TranslucentPass->Render(state);
  this->NumberOfRenderedProps = this->TranslucentPass->GetNumberOfRenderedProps();
  vtkOITStatistics& statistics = this->Impl->Statistics;
  statistics.Algorithm = "unsorted blending";
  statistics.Reason = reason;
  statistics.Warning = "Translucent props are blended unsorted: " + reason;
  statistics.NumberOfGeometryPasses = 1;
  statistics.NumberOfFragments = -1;
  statistics.MaximumDepthComplexity = -1;
  statistics.NoteError(1.0);
}

//------------------------------------------------------------------------------
void vtkOITPass::Report()
{
  const vtkOITStatistics& statistics = this->Impl->Statistics;
  std::set<std::string>& reported = this->Impl->Reported;
  if (!statistics.Fault.empty())
  {
    if (reported.insert(statistics.Fault).second)
    {
      vtkErrorMacro(<< statistics.Fault);
    }
  }
  else if (!statistics.Warning.empty() && reported.insert(statistics.Warning).second)
  {
    vtkWarningMacro(<< statistics.Warning);
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->TranslucentPass)
  {
    this->TranslucentPass->ReleaseGraphicsResources(window);
  }
  this->Impl->Runner.Release();
  this->Impl->Capabilities.reset();
  this->Impl->CapabilitiesWindow = nullptr;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkOITPass::ResetStatistics()
{
  this->NumberOfRenderedProps = 0;
  this->Impl->Statistics = {};
}

//------------------------------------------------------------------------------
const vtkOITStatistics& vtkOITPass::GetStatistics() const
{
  return this->Impl->Statistics;
}

//------------------------------------------------------------------------------
std::string vtkOITPass::GetAlgorithmName() const
{
  const std::string& name = this->Impl->Statistics.Algorithm;
  return name.empty() ? this->GetOwnAlgorithmName() : name;
}

//------------------------------------------------------------------------------
std::string vtkOITPass::GetOwnAlgorithmName() const
{
  return this->Impl->Engine->GetAlgorithmName(this->MakeSettings(vtkOITCapabilities(nullptr)));
}

//------------------------------------------------------------------------------
int vtkOITPass::GetNumberOfGeometryPasses() const
{
  return this->Impl->Statistics.NumberOfGeometryPasses;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkOITPass::GetNumberOfFragments() const
{
  return this->Impl->Statistics.NumberOfFragments;
}

//------------------------------------------------------------------------------
int vtkOITPass::GetMaximumDepthComplexity() const
{
  return this->Impl->Statistics.MaximumDepthComplexity;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkOITPass::GetBufferSizeInBytes() const
{
  return this->Impl->Runner.GetSizeInBytes();
}

//------------------------------------------------------------------------------
bool vtkOITPass::GetExact() const
{
  return this->Impl->Statistics.Exact;
}

//------------------------------------------------------------------------------
double vtkOITPass::GetErrorBound() const
{
  return this->Impl->Statistics.ErrorBound;
}

//------------------------------------------------------------------------------
void vtkOITPass::SetTranslucentPass(vtkRenderPass* pass)
{
  if (pass == this)
  {
    vtkErrorMacro("The pass is refused as its own TranslucentPass; give the pass that draws the "
                  "props, e.g. a vtkTranslucentPass");
    return;
  }
  if (this->TranslucentPass != pass)
  {
    this->TranslucentPass = pass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkOITPass::GetTranslucentPass()
{
  return this->TranslucentPass;
}

//------------------------------------------------------------------------------
// Not a number is in no range.
bool vtkOITPass::IsInRange(const char* property, double value, double low, double high)
{
  const bool isInRange = value >= low && value <= high;
  if (!isInRange)
  {
    vtkErrorMacro(<< property << " " << value << " is refused; give a number from " << low << " to "
                  << high);
  }
  return isInRange;
}

//------------------------------------------------------------------------------
bool vtkOITPass::IsNamedValue(const char* property, int value, int last, const char* names)
{
  const bool isNamed = value >= 0 && value <= last;
  if (!isNamed)
  {
    vtkErrorMacro(<< property << " " << value << " is refused; give " << names);
  }
  return isNamed;
}

//------------------------------------------------------------------------------
void vtkOITPass::SetTransmittanceThreshold(double threshold)
{
  if (this->IsInRange("TransmittanceThreshold", threshold, 0.0, 1.0) &&
    this->TransmittanceThreshold != threshold)
  {
    this->TransmittanceThreshold = threshold;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::SetMaximumNumberOfPeels(int peels)
{
  if (this->IsInRange("MaximumNumberOfPeels", peels, 0, VTK_INT_MAX) &&
    this->MaximumNumberOfPeels != peels)
  {
    this->MaximumNumberOfPeels = peels;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::SetOcclusionRatio(double ratio)
{
  if (this->IsInRange("OcclusionRatio", ratio, 0.0, 0.5) && this->OcclusionRatio != ratio)
  {
    this->OcclusionRatio = ratio;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::SetMaximumBufferSize(vtkTypeInt64 bytes)
{
  constexpr vtkTypeInt64 smallest = 1 << 20;
  if (bytes < 0 || (bytes > 0 && bytes < smallest))
  {
    vtkErrorMacro("MaximumBufferSize " << bytes << " is refused; give 0 for no limit, or at least "
                                       << smallest << " bytes");
    return;
  }
  if (this->MaximumBufferSize != bytes)
  {
    this->MaximumBufferSize = bytes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::SetFragmentPrecision(int precision)
{
  if (this->IsNamedValue("FragmentPrecision", precision, FLOAT, "HALF or FLOAT") &&
    this->FragmentPrecision != precision)
  {
    this->FragmentPrecision = precision;
    this->Modified();
  }
}
