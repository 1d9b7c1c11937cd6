// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITRendererHook.h"

#include "Private/Hook/vtkOITHookRecord.h"
#include "Private/Hook/vtkOITPassChain.h"

#include "vtkCommand.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkOITPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>

namespace
{
/// Sits in the renderer's slot for depth peeling and forwards to one of our passes. Derives from
/// the dual pass, because the renderer hands UseDepthPeelingForVolumes only to that class.
class Adapter : public vtkDualDepthPeelingPass
{
public:
  static Adapter* New();
  vtkTypeMacro(Adapter, vtkDualDepthPeelingPass);

  void Render(const vtkRenderState* state) override
  {
    // With UseDepthPeelingForVolumes the renderer leaves volumes to this pass.
    this->Pass->RenderWithVolumes(state, this->GetVolumetricPass());
    this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    if (this->Pass)
    {
      this->Pass->ReleaseGraphicsResources(window);
    }
    this->Superclass::ReleaseGraphicsResources(window);
  }

  /// Before and after a frame of the renderer.
  ///@{
  void Begin();
  void End();
  ///@}
  void Observe();

  vtkSmartPointer<vtkOITPass> Pass;
  vtkRenderer* Renderer = nullptr;
  vtkOITPassChain Chain;                   // of the renderer, when it has one
  unsigned long Observers[2] = { 0, 0 };   // of the renderer's StartEvent and EndEvent
  std::string Obstacle;                    // why the renderer does not ask the pass in this frame
  std::set<std::string> Warnings;          // that were printed
  vtkDepthPeelingPass* Previous = nullptr; // what the renderer owned before
  bool PreviousUseDepthPeeling = false;
  bool PreviousUseDepthPeelingForVolumes = false;
  std::shared_ptr<vtkOITHookRecord> Record; // where nobody asked for the pass
  bool IsInUnaskedFrame = false;

protected:
  std::string FindObstacle();
  void BeginUnasked();
  void EndUnasked();

  Adapter() = default;
  ~Adapter() override
  {
    if (this->Previous)
    {
      this->Previous->Delete();
    }
  }
};
vtkStandardNewMacro(Adapter);

bool HasTranslucentProps(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (prop->GetVisibility() && prop->HasTranslucentPolygonalGeometry())
    {
      return true;
    }
  }
  return false;
}

/// Empty, or why the renderer does not ask the pass: with a pass of its own it asks that one, and not
/// the slot that the adapter sits in.
std::string Adapter::FindObstacle()
{
  vtkRenderer* renderer = this->Renderer;
  if (vtkRenderPass* chain = renderer->GetPass())
  {
    if (this->Chain.Put(chain, this->Pass))
    {
      return {};
    }
    if (!this->Chain.LeadsToRenderer())
    {
      return "The renderer has a pass, " + std::string(chain->GetClassName()) +
        ", in which no translucent pass of VTK was found; put the pass there yourself, e.g. by "
        "vtkRenderStepsPass::SetTranslucentPass()";
    }
  }
  if (renderer->GetUseShadows())
  {
    return "VTK draws nothing translucent in a renderer with UseShadows; call UseShadowsOff()";
  }
  return renderer->GetUseDepthPeeling()
    ? ""
    : "The renderer's UseDepthPeeling is off, so the pass does not draw; call UseDepthPeelingOn(), "
      "or uninstall the pass";
}

/// A derived class may name a protected member and apply the pointer to any vtkOpenGLRenderer:
/// plain standard C++ ([class.protected]), no cast.
struct Access : public vtkOpenGLRenderer
{
  static vtkDepthPeelingPass*& Slot(vtkOpenGLRenderer* renderer)
  {
    return renderer->*(&Access::DepthPeelingPass);
  }
  /// Set without Modified(): the application is not to notice.
  static void SetUseDepthPeeling(vtkRenderer* renderer, bool on, bool forVolumes)
  {
    renderer->*(&Access::UseDepthPeeling) = on ? 1 : 0;
    renderer->*(&Access::UseDepthPeelingForVolumes) = forVolumes;
  }
};

/// The application's switch keeps its value but for the time of a frame.
void Adapter::BeginUnasked()
{
  this->EndUnasked(); // of a frame whose end was not observed
  this->PreviousUseDepthPeeling = this->Renderer->GetUseDepthPeeling() != 0;
  this->PreviousUseDepthPeelingForVolumes = this->Renderer->GetUseDepthPeelingForVolumes();
  if (this->Record->RespectsDepthPeeling() && !this->PreviousUseDepthPeeling)
  {
    this->Chain.GiveBack();
    this->Obstacle = "its depth peeling is off";
  }
  else
  {
    this->IsInUnaskedFrame = true;
    Access::SetUseDepthPeeling(this->Renderer, true, true);
    this->Obstacle = this->FindObstacle();
    if (!this->Obstacle.empty())
    {
      this->EndUnasked();
    }
  }
  this->Record->Begin(this->Renderer->GetClassName(), this->Obstacle);
}

void Adapter::EndUnasked()
{
  if (this->IsInUnaskedFrame)
  {
    this->IsInUnaskedFrame = false;
    Access::SetUseDepthPeeling(
      this->Renderer, this->PreviousUseDepthPeeling, this->PreviousUseDepthPeelingForVolumes);
  }
}

void Adapter::Begin()
{
  this->Pass->SetNotAsked();
  if (this->Record)
  {
    this->BeginUnasked();
    return;
  }
  this->Obstacle = this->FindObstacle();
  if (!this->Obstacle.empty() && this->Warnings.insert(this->Obstacle).second)
  {
    vtkWarningMacro(<< this->Obstacle);
  }
}

/// A frame in which the renderer found nothing translucent does not ask the pass either.
void Adapter::End()
{
  if (this->Pass->GetNumberOfGeometryPasses() == 0 && !this->Pass->GetExact() &&
    (this->Obstacle.empty() || !HasTranslucentProps(this->Renderer)))
  {
    this->Pass->ResetStatistics();
  }
  if (this->Record)
  {
    this->EndUnasked();
    this->Record->End({ this->Pass->GetAlgorithmName(), this->Pass->GetExact(),
      this->Pass->GetNumberOfGeometryPasses(), this->Pass->GetNumberOfFragments(),
      this->Pass->GetMaximumDepthComplexity() });
  }
}

/// An application may remove all observers of its renderer.
void Adapter::Observe()
{
  if (!this->Renderer->GetCommand(this->Observers[0]))
  {
    this->Observers[0] = this->Renderer->AddObserver(vtkCommand::StartEvent, this, &Adapter::Begin);
  }
  if (!this->Renderer->GetCommand(this->Observers[1]))
  {
    this->Observers[1] = this->Renderer->AddObserver(vtkCommand::EndEvent, this, &Adapter::End);
  }
}

Adapter* FindAdapter(vtkRenderer* renderer)
{
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  return glRenderer ? dynamic_cast<Adapter*>(Access::Slot(glRenderer)) : nullptr;
}

/// The renderer's adapter, a new one where it has none, with the pass.
Adapter* PutAdapter(vtkOpenGLRenderer* renderer, vtkOITPass* pass)
{
  Adapter* adapter = FindAdapter(renderer);
  if (!adapter)
  {
    adapter = Adapter::New(); // owned by the renderer, which calls Delete()
    adapter->Previous = Access::Slot(renderer);
    adapter->Renderer = renderer;
    Access::Slot(renderer) = adapter;
  }
  else if (adapter->Pass != pass)
  {
    adapter->Chain.GiveBack();
    if (renderer->GetVTKWindow())
    {
      adapter->Pass->ReleaseGraphicsResources(renderer->GetVTKWindow());
    }
  }
  adapter->Observe();
  adapter->Pass = pass;
  return adapter;
}
}

vtkStandardNewMacro(vtkOITRendererHook);

//------------------------------------------------------------------------------
bool vtkOITRendererHook::Install(vtkRenderer* renderer, vtkOITPass* pass)
{
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  if (!glRenderer || !pass)
  {
    vtkGenericWarningMacro("vtkOITRendererHook: "
      << (pass ? "the renderer is not a vtkOpenGLRenderer; give one that a render window draws"
               : "no pass was given; create one, e.g. vtkOITABufferPass::New()"));
    return false;
  }
  const bool wasAsked = FindAdapter(renderer) && !FindAdapter(renderer)->Record;
  Adapter* adapter = PutAdapter(glRenderer, pass);
  if (!wasAsked)
  {
    adapter->Record.reset();
    adapter->PreviousUseDepthPeeling = renderer->GetUseDepthPeeling() != 0;
    adapter->PreviousUseDepthPeelingForVolumes = renderer->GetUseDepthPeelingForVolumes();
    renderer->UseDepthPeelingForVolumesOn();
  }
  renderer->UseDepthPeelingOn();
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITRendererHook::InstallUnasked(
  vtkRenderer* renderer, vtkOITPass* pass, const std::shared_ptr<vtkOITHookRecord>& record)
{
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  if (!glRenderer)
  {
    return false;
  }
  PutAdapter(glRenderer, pass)->Record = record;
  return true;
}

//------------------------------------------------------------------------------
void vtkOITRendererHook::Observe(vtkRenderer* renderer)
{
  if (Adapter* adapter = FindAdapter(renderer))
  {
    adapter->Observe();
  }
}

//------------------------------------------------------------------------------
bool vtkOITRendererHook::IsInstalledUnasked(vtkRenderer* renderer)
{
  Adapter* adapter = FindAdapter(renderer);
  return adapter && adapter->Record;
}

//------------------------------------------------------------------------------
bool vtkOITRendererHook::Uninstall(vtkRenderer* renderer)
{
  Adapter* adapter = FindAdapter(renderer);
  if (!adapter)
  {
    return false;
  }
  if (renderer->GetVTKWindow())
  {
    adapter->ReleaseGraphicsResources(renderer->GetVTKWindow());
  }
  for (const unsigned long observer : adapter->Observers)
  {
    renderer->RemoveObserver(observer);
  }
  adapter->Chain.GiveBack();
  if (!adapter->Record)
  {
    renderer->SetUseDepthPeeling(adapter->PreviousUseDepthPeeling);
    renderer->SetUseDepthPeelingForVolumes(adapter->PreviousUseDepthPeelingForVolumes);
  }
  Access::Slot(vtkOpenGLRenderer::SafeDownCast(renderer)) = adapter->Previous;
  adapter->Previous = nullptr;
  adapter->Delete();
  return true;
}

//------------------------------------------------------------------------------
vtkOITPass* vtkOITRendererHook::GetInstalledPass(vtkRenderer* renderer)
{
  Adapter* adapter = FindAdapter(renderer);
  return adapter ? adapter->Pass.Get() : nullptr;
}
