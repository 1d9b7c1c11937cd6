// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITRendererHook.h"

#include "vtkCommand.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkOITPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderState.h"
#include "vtkSmartPointer.h"

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
    this->Pass->Render(state);
    this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
    // With UseDepthPeelingForVolumes the renderer leaves volumes to this pass. They are composited
    // over the translucent geometry, as without that setting.
    if (vtkRenderPass* volumes = this->GetVolumetricPass())
    {
      volumes->Render(state);
      this->NumberOfRenderedProps += volumes->GetNumberOfRenderedProps();
    }
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    if (this->Pass)
    {
      this->Pass->ReleaseGraphicsResources(window);
    }
    this->Superclass::ReleaseGraphicsResources(window);
  }

  void ResetStatistics() { this->Pass->ResetStatistics(); }

  vtkSmartPointer<vtkOITPass> Pass;
  unsigned long Observer = 0;              // of the renderer's StartEvent
  vtkDepthPeelingPass* Previous = nullptr; // what the renderer owned before
  bool PreviousUseDepthPeeling = false;

protected:
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
    adapter->Observer =
      renderer->AddObserver(vtkCommand::StartEvent, adapter, &Adapter::ResetStatistics);
    Access::Slot(glRenderer) = adapter;
  }
  else if (adapter->Pass != pass && renderer->GetVTKWindow())
  {
    adapter->Pass->ReleaseGraphicsResources(renderer->GetVTKWindow());
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
  renderer->RemoveObserver(adapter->Observer);
  renderer->SetUseDepthPeeling(adapter->PreviousUseDepthPeeling);
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
