// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITPass.h"

#include "Private/Auto/vtkOITVolumeOrder.h"
#include "Private/Engine/vtkOITDelegate.h"
#include "Private/Engine/vtkOITEngine.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "Private/GL/vtkOITAllocation.h"
#include "Private/GL/vtkOITSavedState.h"
#include "Private/Plan/vtkOITHookTrial.h"
#include "Private/Plan/vtkOITPlan.h"
#include "Private/Plan/vtkOITPlanRunner.h"
#include "Private/Volume/vtkOITVolumes.h"

#include "vtkActor2D.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkTranslucentPass.h"

#include <algorithm>
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

  /// While one lives, a frame is being drawn by a pass of ours, in this thread.
  struct Drawing
  {
    Drawing() { IsDrawing = true; }
    ~Drawing() { IsDrawing = false; }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;
  };
  static inline thread_local bool IsDrawing = false;

  const vtkOITCapabilities& QueryCapabilities(vtkOpenGLRenderWindow* window)
  {
    if (!this->Capabilities || this->CapabilitiesWindow != window)
    {
      this->Capabilities = std::make_unique<vtkOITCapabilities>(window);
      this->CapabilitiesWindow = window;
    }
    return *this->Capabilities;
  }

  /// Draws a frame: props that say that they have something translucent, and others that may have.
  void Draw(vtkOITPass* pass, const vtkRenderState* state, std::vector<vtkProp*> props,
    const std::vector<vtkProp*>& denying, vtkOITVolumes& volumes);
  /// A frame that has none but those others.
  void DrawDenying(
    vtkOITPass* pass, const vtkRenderState* state, const std::vector<vtkProp*>& props);

  std::unique_ptr<vtkOITEngine> Engine; // of the subclass's method, may be nullptr
  vtkOITPlanRunner Runner;
  vtkOITStatistics Statistics;                      // of the last frame
  std::unique_ptr<vtkOITCapabilities> Capabilities; // of CapabilitiesWindow
  vtkOpenGLRenderWindow* CapabilitiesWindow = nullptr;
  vtkOITHookTrial HookTrial;
  std::set<std::string> Reported; // so that each line is printed once, not every frame
};

//------------------------------------------------------------------------------
vtkOITPass::vtkOITPass(std::unique_ptr<vtkOITEngine> engine)
  : TranslucentPass(vtkSmartPointer<vtkTranslucentPass>::New())
  , Impl(std::make_unique<Internals>(std::move(engine)))
{
  this->SetNotAsked();
}

//------------------------------------------------------------------------------
vtkOITPass::~vtkOITPass() = default;

//------------------------------------------------------------------------------
void vtkOITPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TranslucentPass: " << this->TranslucentPass.Get() << "\n"
     << indent << "VolumetricPass: " << this->VolumetricPass.Get() << "\n"
     << indent << "TransmittanceThreshold: " << this->TransmittanceThreshold << "\n"
     << indent << "MaximumNumberOfPeels: " << this->MaximumNumberOfPeels << "\n"
     << indent << "OcclusionRatio: " << this->OcclusionRatio << "\n"
     << indent << "MaximumBufferSize: " << this->MaximumBufferSize << "\n"
     << indent << "FragmentPrecision: " << (this->FragmentPrecision == HALF ? "half" : "float")
     << "\n"
     << indent << "CoincidentLayers: " << (this->CoincidentLayers == MEAN ? "mean" : "last on top")
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
vtkOITPlan vtkOITPass::MakePlan(const vtkOITFrame& frame, const vtkOITSettings&)
{
  vtkOITPlan plan;
  plan.Frame = frame;
  return plan;
}

//------------------------------------------------------------------------------
void vtkOITPass::Render(const vtkRenderState* state)
{
  this->RenderWithVolumes(state, this->VolumetricPass);
}

//------------------------------------------------------------------------------
void vtkOITPass::RenderWithVolumes(const vtkRenderState* state, vtkRenderPass* volumetricPass)
{
  this->ResetStatistics();
  vtkOITVolumes volumes(volumetricPass, state);
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
    volumes.DrawAfter();
    this->NumberOfRenderedProps =
      this->TranslucentPass->GetNumberOfRenderedProps() + volumes.GetNumberOfRenderedProps();
    return;
  }
  if (Internals::IsDrawing)
  {
    this->Impl->Statistics.Fault = "A vtkOITPass is drawn inside of another one; it leaves the "
                                   "props to its TranslucentPass. Take "
                                   "it out of the other one's chain";
    this->TranslucentPass->Render(state);
    volumes.DrawAfter();
    this->Report();
    return;
  }
  std::vector<vtkProp*> props = vtkOITFindTranslucentProps(state);
  if (!vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetVTKWindow()))
  {
    this->DrawUnsorted(state, "the renderer's window is not a vtkOpenGLRenderWindow");
  }
  else
  {
    const std::vector<vtkProp*> denying = vtkOITFindDenyingProps(state);
    if (!props.empty())
    {
      this->Impl->Draw(this, state, std::move(props), denying, volumes);
    }
    else if (!denying.empty())
    {
      this->Impl->DrawDenying(this, state, denying);
    }
  }
  volumes.DrawAfter();
  this->NumberOfRenderedProps += volumes.GetNumberOfRenderedProps();
  this->Report();
}

//------------------------------------------------------------------------------
void vtkOITPass::Internals::Draw(vtkOITPass* pass, const vtkRenderState* state,
  std::vector<vtkProp*> props, const std::vector<vtkProp*>& denying, vtkOITVolumes& volumes)
{
  const Drawing drawing;
  vtkOITDelegate delegate(pass->TranslucentPass, state);
  vtkOITFrame frame;
  frame.Renderer = state->GetRenderer();
  frame.Window = vtkOpenGLRenderWindow::SafeDownCast(frame.Renderer->GetVTKWindow());
  frame.GLState = frame.Window->GetState();
  frame.Capabilities = &this->QueryCapabilities(frame.Window);
  frame.Target = vtkOITTarget::Query();
  frame.Props = std::move(props);
  vtkOITAllocation::TakeErrors();
  {
    vtkOITSavedState saved(frame.GLState, frame.Target);
    frame.Viewport = saved.GetViewport();
    const vtkOITSettings settings = pass->MakeSettings(*frame.Capabilities);
    const std::vector<vtkProp*> unsorted = this->HookTrial.TakeUnsorted(frame, delegate, denying,
      [&] { return this->Runner.GetSorters().SortsLight(frame, settings); });
    frame.Extents = vtkOITFindScreenExtents(frame.Renderer, frame.Props, frame.Viewport);
    const vtkOITVolumeOrder order(frame, volumes.GetAll());
    volumes.SetOrder(order.Before, order.Between, order.After);
    frame.Rectangle = vtkOITFindScreenRectangle(frame.Extents);
    if (volumes.CanDraw() && !order.Between.empty())
    {
      frame.Volumes = &volumes;
      frame.Rectangle = frame.Rectangle.Unite(order.Rectangle);
    }
    frame.Rectangle = frame.Rectangle.Intersect(saved.GetDrawnRectangle());
    if (!order.Before.empty())
    {
      saved.SetAgain();
      volumes.DrawBefore();
      saved.SetNeutral();
    }
    // Nothing is skipped, kept or found of a frame that is nowhere on the screen.
    vtkOITPlan plan = frame.Rectangle.IsEmpty() ? pass->vtkOITPass::MakePlan(frame, settings)
                                                : pass->MakePlan(frame, settings);
    plan.Unsorted = unsorted;
    this->Runner.Run(plan, settings, delegate, saved, this->Statistics);
    const std::string doubt = order.FindDoubt(volumes.CanDraw());
    if (!doubt.empty())
    {
      this->Statistics.NoteWarning(doubt);
    }
  }
  this->Statistics.NumberOfGeometryPasses = delegate.GetNumberOfPasses();
  pass->NumberOfRenderedProps = delegate.GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkOITPass::Internals::DrawDenying(
  vtkOITPass* pass, const vtkRenderState* state, const std::vector<vtkProp*>& props)
{
  vtkOITDelegate delegate(pass->TranslucentPass, state);
  // A vtkActor2D says that it has drawn, and most draw nothing before the overlay.
  const auto drawn = std::find_if(
    props.begin(), props.end(), [](vtkProp* prop) { return !vtkActor2D::SafeDownCast(prop); });
  if (delegate.DrawUnsorted(props) && drawn != props.end())
  {
    this->Statistics.NoteUnsorted((*drawn)->GetClassName());
    this->Statistics.NumberOfGeometryPasses = 1;
  }
  pass->NumberOfRenderedProps = delegate.GetNumberOfRenderedProps();
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
  if (this->VolumetricPass)
  {
    this->VolumetricPass->ReleaseGraphicsResources(window);
  }
  if (this->TranslucentPass)
  {
    this->TranslucentPass->ReleaseGraphicsResources(window);
  }
  this->Impl->Runner.Release();
  this->Impl->HookTrial.Release();
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
void vtkOITPass::SetNotAsked()
{
  this->ResetStatistics();
  this->Impl->Statistics.NoteError(1.0);
  this->Impl->Statistics.Reason = "the pass was not asked to draw";
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
