// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITRendererHook.h"

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

  vtkSmartPointer<vtkOITPass> Pass;
  vtkRenderer* Renderer = nullptr;
  vtkOITPassChain Chain;                   // of the renderer, when it has one
  unsigned long Observers[2] = { 0, 0 };   // of the renderer's StartEvent and EndEvent
  std::string Obstacle;                    // why the renderer does not ask the pass in this frame
  std::set<std::string> Warnings;          // that were printed
  vtkDepthPeelingPass* Previous = nullptr; // what the renderer owned before
  bool PreviousUseDepthPeeling = false;
  bool PreviousUseDepthPeelingForVolumes = false;

protected:
  std::string FindObstacle();

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
    return this->Chain.Put(chain, this->Pass)
      ? std::string()
      : "The renderer has a pass, " + std::string(chain->GetClassName()) +
        ", in which no translucent pass of VTK was found; put the pass there yourself, e.g. by "
        "vtkRenderStepsPass::SetTranslucentPass()";
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

void Adapter::Begin()
{
  this->Pass->SetNotAsked();
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
}

/// A derived class may name a protected member and apply the pointer to any vtkOpenGLRenderer:
/// plain standard C++ ([class.protected]), no cast.
struct Access : public vtkOpenGLRenderer
{
  static vtkDepthPeelingPass*& Slot(vtkOpenGLRenderer* renderer)
  {
    return renderer->*(&Access::DepthPeelingPass);
  }
};

Adapter* FindAdapter(vtkRenderer* renderer)
{
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  return glRenderer ? dynamic_cast<Adapter*>(Access::Slot(glRenderer)) : nullptr;
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
  Adapter* adapter = FindAdapter(renderer);
  if (!adapter)
  {
    adapter = Adapter::New(); // owned by the renderer, which calls Delete()
    adapter->Previous = Access::Slot(glRenderer);
    adapter->PreviousUseDepthPeeling = renderer->GetUseDepthPeeling() != 0;
    adapter->PreviousUseDepthPeelingForVolumes = renderer->GetUseDepthPeelingForVolumes();
    renderer->UseDepthPeelingForVolumesOn();
    adapter->Renderer = renderer;
    adapter->Observers[0] = renderer->AddObserver(vtkCommand::StartEvent, adapter, &Adapter::Begin);
    adapter->Observers[1] = renderer->AddObserver(vtkCommand::EndEvent, adapter, &Adapter::End);
    Access::Slot(glRenderer) = adapter;
  }
  else if (adapter->Pass != pass)
  {
    adapter->Chain.GiveBack();
    if (renderer->GetVTKWindow())
    {
      adapter->Pass->ReleaseGraphicsResources(renderer->GetVTKWindow());
    }
  }
  adapter->Pass = pass;
  renderer->UseDepthPeelingOn();
  return true;
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
  renderer->SetUseDepthPeeling(adapter->PreviousUseDepthPeeling);
  renderer->SetUseDepthPeelingForVolumes(adapter->PreviousUseDepthPeelingForVolumes);
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
