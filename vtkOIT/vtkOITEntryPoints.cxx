// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// What the two small libraries of Autoload/ call, which are not linked to this one: the first in a
// program that finds it through VTK_AUTOLOAD_PATH, the second by LD_PRELOAD.

#include "Private/Hook/vtkOITEnvironment.h"
#include "Private/Hook/vtkOITHookRecord.h"

#include "vtkDepthPeelingPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkOITPass.h"
#include "vtkOITPassFactory.h"
#include "vtkOITProcessHook.h"
#include "vtkObjectFactory.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTranslucentPass.h"

#include <cstring>

namespace
{
/// In an application's chain of passes, in place of the pass that it made.
template <typename BaseClass>
class PreloadedPass : public BaseClass
{
public:
  static PreloadedPass* New() { VTK_STANDARD_NEW_BODY(PreloadedPass); }

  void Render(const vtkRenderState* state) override
  {
    this->Pass->SetNotAsked();
    this->Record->Begin(state->GetRenderer()->GetClassName(), {});
    // Volumes that an application leaves to its dual depth peeling.
    auto* dual = vtkDualDepthPeelingPass::SafeDownCast(this);
    this->Pass->RenderWithVolumes(state, dual ? dual->GetVolumetricPass() : nullptr);
    this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
    this->Record->End({ this->Pass->GetAlgorithmName(), this->Pass->GetExact(),
      this->Pass->GetNumberOfGeometryPasses(), this->Pass->GetNumberOfFragments(),
      this->Pass->GetMaximumDepthComplexity() });
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Pass->ReleaseGraphicsResources(window);
    this->BaseClass::ReleaseGraphicsResources(window);
  }

  vtkSmartPointer<vtkOITPass> Pass;
  std::shared_ptr<vtkOITHookRecord> Record;
};

template <typename BaseClass>
BaseClass* NewPass(const char* className, const vtkOITEnvironment& environment)
{
  auto* pass = PreloadedPass<BaseClass>::New();
  pass->Pass.TakeReference(vtkOITPassFactory::CreatePass(environment.Method));
  pass->Record = vtkOITHookRecord::Create("in place of its " + std::string(className),
    environment.Method, environment.Respect, environment.Log);
  return pass;
}

/// What the environment asks for; Off when something in it is wrong, which is told once.
const vtkOITEnvironment& GetEnvironment()
{
  static const vtkOITEnvironment environment = []
  {
    vtkOITEnvironment read = vtkOITEnvironment::Read();
    read.On = vtkOITProcessHook::CheckEnvironment();
    return read;
  }();
  return environment;
}
}

/// Hooks into the process as the environment says.
extern "C" VTKOIT_EXPORT void vtkOITAutoload()
{
  vtkOITProcessHook::InstallByEnvironment();
}

/// A new object of a class of VTK's translucent passes, which draws by a pass of vtkOIT; the caller
/// knows the class and casts. nullptr when VTK is to make it.
extern "C" VTKOIT_EXPORT void* vtkOITNewTranslucentPass(const char* className)
{
  const vtkOITEnvironment& environment = GetEnvironment();
  if (!environment.On)
  {
    return nullptr;
  }
  if (!std::strcmp(className, "vtkDualDepthPeelingPass"))
  {
    return NewPass<vtkDualDepthPeelingPass>(className, environment);
  }
  if (!std::strcmp(className, "vtkDepthPeelingPass"))
  {
    return NewPass<vtkDepthPeelingPass>(className, environment);
  }
  // An application that has its depth peeling switched off makes one of these.
  if (environment.Respect)
  {
    return nullptr;
  }
  if (!std::strcmp(className, "vtkOrderIndependentTranslucentPass"))
  {
    return NewPass<vtkOrderIndependentTranslucentPass>(className, environment);
  }
  return !std::strcmp(className, "vtkTranslucentPass")
    ? NewPass<vtkTranslucentPass>(className, environment)
    : nullptr;
}
