// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TestSetup.h"

#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkOITABufferPass.h"
#include "vtkOITHeadless.h"
#include "vtkOITPassFactory.h"
#include "vtkOITRendererHook.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOverlayPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkTesting.h"
#include "vtkVolumetricPass.h"

#include <cstdio>
#include <cstdlib>

namespace vtkOITTest
{
namespace
{
vtkSmartPointer<vtkRenderPass> MakeRenderSteps(vtkOITPass* pass)
{
  auto steps = vtkSmartPointer<vtkRenderStepsPass>::New();
  steps->SetTranslucentPass(pass);
  return steps;
}

vtkSmartPointer<vtkRenderPass> MakeCameraChain(vtkOITPass* pass)
{
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(pass);
  passes->AddItem(vtkNew<vtkVolumetricPass>());
  passes->AddItem(vtkNew<vtkOverlayPass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

/// Empty when the method runs here, otherwise what is missing.
std::string FindMissingCapability(const Setup& setup)
{
  vtkSmartPointer<vtkOITPass> pass = setup.CreatePass();
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(8, 8);
  window->AddRenderer(renderer);
  window->Render();
  return pass->GetMissingCapability(vtkOpenGLRenderWindow::SafeDownCast(window));
}
}

//------------------------------------------------------------------------------
std::string Setup::Describe() const
{
  const char* use = this->UseMode == Use::Installed ? "installed"
    : this->UseMode == Use::RenderSteps             ? "render steps"
                                                    : "camera chain";
  return this->Method + " " + (this->FragmentStorage == Storage::Half ? "half" : "float32") + ", " +
    use;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkOITPass> Setup::CreatePass() const
{
  auto pass = vtkSmartPointer<vtkOITPass>::Take(vtkOITPassFactory::CreatePass(this->Method));
  if (auto* abuffer = vtkOITABufferPass::SafeDownCast(pass))
  {
    abuffer->SetFragmentPrecision(
      this->FragmentStorage == Storage::Half ? vtkOITABufferPass::HALF : vtkOITABufferPass::FLOAT);
  }
  return pass;
}

//------------------------------------------------------------------------------
void Setup::Attach(vtkRenderer* renderer, vtkOITPass* pass) const
{
  switch (this->UseMode)
  {
    case Use::Installed:
      vtkOITRendererHook::Install(renderer, pass);
      break;
    case Use::RenderSteps:
      renderer->SetPass(MakeRenderSteps(pass));
      break;
    case Use::CameraChain:
      renderer->SetPass(MakeCameraChain(pass));
      break;
  }
}

//------------------------------------------------------------------------------
void Setup::Detach(vtkRenderer* renderer) const
{
  if (this->UseMode == Use::Installed)
  {
    vtkOITRendererHook::Uninstall(renderer);
    return;
  }
  if (renderer->GetPass() && renderer->GetVTKWindow())
  {
    renderer->GetPass()->ReleaseGraphicsResources(renderer->GetVTKWindow());
  }
  renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------
int RunTest(
  int argc, char* argv[], Setups setups, const std::function<void(TestReport&, const Setup&)>& body)
{
  Setup setup;
  // VTK 9.6 passes an empty argument to tests; options of vtk_add_test_cxx start with a dash.
  const bool named = argc > 1 && argv[1][0] != '\0' && argv[1][0] != '-';
  setup.Method = named ? argv[1] : "abuffer";
  if (!setup.CreatePass())
  {
    std::printf("FAILED: no method is called %s\n", setup.Method.c_str());
    return EXIT_FAILURE;
  }
  if (!vtkOITHeadless::Initialize())
  {
    std::printf("FAILED: no headless render window; see the error above\n");
    return EXIT_FAILURE;
  }
  const std::string missing = FindMissingCapability(setup);
  if (!missing.empty())
  {
    std::printf("skipped: %s\n", missing.c_str());
    return VTK_SKIP_RETURN_CODE;
  }

  std::vector<Use> uses{ Use::Installed };
  if (setups == Setups::All)
  {
    uses = { Use::Installed, Use::RenderSteps, Use::CameraChain };
  }
  TestReport report;
  for (const Storage storage : { Storage::Half, Storage::Float32 })
  {
    for (const Use use : uses)
    {
      setup.FragmentStorage = storage;
      setup.UseMode = use;
      report.SetContext(setup.Describe());
      body(report, setup);
    }
  }
  return report.GetExitStatus();
}
}
