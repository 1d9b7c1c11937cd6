// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rig/Setup.h"

#include "Rig/Contenders.h"
#include "Rig/GLMessages.h"
#include "Rig/GLObjects.h"
#include "Rig/Rig.h"

#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
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

#include <vtksys/SystemTools.hxx>

#include <algorithm>
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

/// A capability tier: the extensions that are hidden from vtkOITCapabilities.
struct Tier
{
  const char* Name;
  const char* Hidden;
};
constexpr Tier Full{ "all extensions", "" };
constexpr Tier NoFetch{ "without framebuffer fetch", "GL_EXT_shader_framebuffer_fetch" };
constexpr Tier GL32{ "OpenGL 3.2",
  "GL_EXT_shader_framebuffer_fetch GL_ARB_fragment_shader_interlock GL_ARB_texture_barrier "
  "GL_ARB_shader_image_load_store GL_ARB_shader_storage_buffer_object GL_ARB_clear_texture "
  "GL_ARB_draw_buffers_blend" };

/// The table of methods: what each promises, how it keeps fragments, on which tiers it runs.
struct MethodRow
{
  const char* Name;
  Expectation Promise;
  std::vector<Storage> Storages;
  std::vector<Tier> Tiers;
  int LargestStack; // see Setup
};
const std::vector<MethodRow>& GetMethodTable()
{
  static const std::vector<MethodRow> table = {
    { "auto", Expectation::Exact, { Storage::Half, Storage::Float32 }, { Full, NoFetch, GL32 },
      4096 },
    { "abuffer", Expectation::Exact, { Storage::Half, Storage::Float32 }, { Full, NoFetch }, 4096 },
    { "deferred-abuffer", Expectation::Exact, { Storage::Half, Storage::Float32 },
      { Full, NoFetch }, 4096 },
    { "deferred", Expectation::Exact, { Storage::Float32 }, { Full, GL32 }, 65 },
    { "peel", Expectation::Exact, { Storage::Float32 }, { Full, GL32 }, 65 },
    { "dual", Expectation::Exact, { Storage::Half, Storage::Float32 }, { Full, GL32 }, 257 },
    { "multilayer", Expectation::Exact, { Storage::Half }, { Full, NoFetch }, 257 },
    { "bucket", Expectation::Exact, { Storage::Float32 }, { Full, GL32 }, 65 },
    { "bucket-pairs", Expectation::Exact, { Storage::Float32 }, { Full, GL32 }, 65 },
    { "bucket-adaptive", Expectation::Exact, { Storage::Float32 }, { Full, GL32 }, 65 },
    { "weighted-average", Expectation::Preview, { Storage::Float32 }, { Full, GL32 }, 4096 },
    { "weighted-sum", Expectation::Preview, { Storage::Float32 }, { Full, GL32 }, 4096 },
    { "weighted-blended", Expectation::Preview, { Storage::Float32 }, { Full, GL32 }, 4096 },
  };
  return table;
}

/// What is missing for the method to run here, if anything, and what the context has that tests
/// expect something of.
struct Context
{
  std::string Missing;
  bool HasFetch = false;
  bool HasInterlock = false;
};

Context FindContext(const Setup& setup)
{
  vtkSmartPointer<vtkOITPass> pass = setup.CreatePass();
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(8, 8);
  window->AddRenderer(renderer);
  window->Render();
  Context context;
  context.Missing = pass->GetMissingCapability(vtkOpenGLRenderWindow::SafeDownCast(window));
  context.HasInterlock = HasGLExtension("GL_ARB_fragment_shader_interlock");
  context.HasFetch = HasGLExtension("GL_EXT_shader_framebuffer_fetch");
  return context;
}
}

//------------------------------------------------------------------------------
std::string Setup::Describe() const
{
  const char* use = this->UseMode == Use::Installed ? "installed"
    : this->UseMode == Use::RenderSteps             ? "render steps"
                                                    : "camera chain";
  return this->Method + " " + (this->FragmentStorage == Storage::Half ? "half" : "float32") + ", " +
    use + ", " + this->Tier;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkOITPass> Setup::CreatePass() const
{
  if (this->IsContender)
  {
    return CreateContenderPass(this->Method);
  }
  const bool hasLists = this->Method == "abuffer" || this->Method == "deferred-abuffer";
  const bool hasNetworks = hasLists && this->HasNetworksAtOnce;
  vtksys::SystemTools::PutEnv(hasNetworks ? "VTKOIT_NETWORKS=1" : "VTKOIT_NETWORKS=0");
  auto pass = vtkSmartPointer<vtkOITPass>::Take(vtkOITPassFactory::CreatePass(this->Method));
  if (pass)
  {
    pass->SetFragmentPrecision(
      this->FragmentStorage == Storage::Half ? vtkOITPass::HALF : vtkOITPass::FLOAT);
    pass->SetTransmittanceThreshold(0.0);
  }
  return pass;
}

//------------------------------------------------------------------------------
void Setup::Attach(vtkRenderer* renderer, vtkOITPass* pass) const
{
  if (this->IsContender)
  {
    AttachContender(this->Method, renderer, pass);
    return;
  }
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
  if (this->IsContender)
  {
    DetachContender(renderer);
    return;
  }
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
bool IsAsked(int argc, char* argv[], const std::string& part)
{
  const bool isNamed = argc > 2 && argv[2][0] != '\0' && argv[2][0] != '-';
  return !isNamed || part == argv[2];
}

//------------------------------------------------------------------------------
int RunTest(
  int argc, char* argv[], Setups setups, const std::function<void(Report&, const Setup&)>& body)
{
  Setup setup;
  // VTK 9.6 passes an empty argument to tests; options of vtk_add_test_cxx start with a dash.
  const bool named = argc > 1 && argv[1][0] != '\0' && argv[1][0] != '-';
  setup.Method = named ? argv[1] : "abuffer";
  if (IsContender(setup.Method) || !GetOption(argc, argv, "--results").empty())
  {
    return RunContender(argc, argv, body);
  }
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
  const Context context = FindContext(setup);
  if (!context.Missing.empty())
  {
    std::printf("skipped: %s\n", context.Missing.c_str());
    return VTK_SKIP_RETURN_CODE;
  }
  const auto row = std::find_if(GetMethodTable().begin(), GetMethodTable().end(),
    [&setup](const MethodRow& candidate) { return setup.Method == candidate.Name; });
  if (row == GetMethodTable().end())
  {
    std::printf("FAILED: %s is not in the table of methods\n", setup.Method.c_str());
    return EXIT_FAILURE;
  }
  setup.Promise = row->Promise;
  setup.IsLong = std::find(argv, argv + argc, std::string("--long")) != argv + argc;

  Report report;
  for (const Tier& tier : row->Tiers)
  {
    std::vector<Use> uses{ Use::Installed };
    const bool isFull = tier.Name == std::string(Full.Name);
    if (!context.HasFetch && tier.Name == std::string(NoFetch.Name))
    {
      continue; // that was the one before
    }
    if (setups == Setups::All && isFull)
    {
      uses = { Use::Installed, Use::RenderSteps, Use::CameraChain };
    }
    vtksys::SystemTools::PutEnv(std::string("VTKOIT_HIDE_EXTENSIONS=") + tier.Hidden);
    Rig::KeepWindow(true); // a new one in each tier
    setup.Tier = tier.Name;
    setup.HasStorage = std::string(tier.Hidden).find("storage") == std::string::npos;
    setup.HasFetch = isFull && context.HasFetch;
    setup.HasInterlock =
      context.HasInterlock && std::string(tier.Hidden).find("interlock") == std::string::npos;
    setup.LargestStack = setup.HasStorage ? row->LargestStack : std::min(row->LargestStack, 257);
    for (const Storage storage : row->Storages)
    {
      for (const Use use : uses)
      {
        setup.FragmentStorage = storage;
        setup.UseMode = use;
        report.SetContext(setup.Describe());
        body(report, setup);
        for (const std::string& message : GLMessages::Take())
        {
          report.Check(false, "OpenGL says: " + message);
        }
      }
    }
  }
  Rig::KeepWindow(false);
  return report.GetExitStatus();
}
}
