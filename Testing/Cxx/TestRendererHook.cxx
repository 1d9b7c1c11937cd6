// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Installing a pass in a renderer that exists, replacing it, and giving the renderer back.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/GLMessages.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkCommand.h"
#include "vtkDefaultPass.h"
#include "vtkNew.h"
#include "vtkOITRendererHook.h"
#include "vtkOutputWindow.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAAPass.h"
#include "vtkStringOutputWindow.h"

#include <functional>
#include <utility>

using namespace vtkOITTest;

namespace
{
/// Renderer and pass missing: false and one message that says so.
void CheckErrors(Report& report, const Setup& setup)
{
  vtkSmartPointer<vtkOutputWindow> previous = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> messages;
  vtkOutputWindow::SetInstance(messages);
  vtkNew<vtkRenderer> renderer;
  const auto pass = setup.CreatePass();
  report.Check(!vtkOITRendererHook::Install(nullptr, pass), "installed without a renderer");
  const std::string first = messages->GetOutput();
  report.Check(!vtkOITRendererHook::Install(renderer, nullptr), "installed without a pass");
  const std::string second = messages->GetOutput();
  vtkOutputWindow::SetInstance(previous);
  report.Check(first.find("renderer") != std::string::npos, "no message about the renderer");
  report.Check(second.size() > first.size(), "no message about the pass");
  report.Check(!vtkOITRendererHook::GetInstalledPass(nullptr), "a pass in no renderer");
  report.Check(!vtkOITRendererHook::GetInstalledPass(renderer), "a pass in a fresh renderer");
  report.Check(!vtkOITRendererHook::Uninstall(renderer), "uninstalled from a fresh renderer");
}

void CheckCycle(Report& report, const Setup& setup)
{
  const std::vector<Layer> layers = Random(51).Layers(8);
  Rig rig(setup, 16, 12);
  setup.Detach(rig.Renderer);
  rig.AddStack(layers);
  const Report::Expected expected =
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground()));
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage);

  for (const int usePeeling : { 0, 1 })
  {
    const std::string what = usePeeling ? "with peeling" : "without peeling";
    rig.Renderer->SetUseDepthPeeling(usePeeling);
    rig.Renderer->SetMaximumNumberOfPeels(2);
    // By VTK's own pass, which blits the depth of this target into one of another format.
    const auto renderWithout = [&rig]
    {
      const GLMessages::Pause pause;
      return rig.Render();
    };
    const Image before = renderWithout();

    report.Check(vtkOITRendererHook::Install(rig.Renderer, rig.Pass), what + ": not installed");
    report.Check(
      vtkOITRendererHook::GetInstalledPass(rig.Renderer) == rig.Pass, what + ": another pass");
    report.Compare(what + ": installed", rig.Render(), expected, bound);
    report.Check(rig.Pass->GetNumberOfGeometryPasses() > 0, what + ": the pass was not used");

    const auto other = setup.CreatePass();
    report.Check(vtkOITRendererHook::Install(rig.Renderer, other), what + ": not replaced");
    report.Check(vtkOITRendererHook::Install(rig.Renderer, other), what + ": not installed twice");
    report.Check(
      vtkOITRendererHook::GetInstalledPass(rig.Renderer) == other, what + ": not the new pass");
    report.Compare(what + ": replaced", rig.Render(), expected, bound);
    report.Check(other->GetNumberOfGeometryPasses() > 0, what + ": the new pass was not used");

    report.Check(vtkOITRendererHook::Uninstall(rig.Renderer), what + ": not uninstalled");
    report.Check(!vtkOITRendererHook::Uninstall(rig.Renderer), what + ": uninstalled twice");
    report.Check(
      !vtkOITRendererHook::GetInstalledPass(rig.Renderer), what + ": a pass is left behind");
    report.Check(rig.Renderer->GetUseDepthPeeling() == usePeeling, what + ": peeling changed");
    report.Check(rig.Renderer->GetMaximumNumberOfPeels() == 2, what + ": peels changed");
    report.Check(other->GetBufferSizeInBytes() == 0, what + ": buffers are left behind");
    report.CompareBits(what + ": picture after uninstalling", renderWithout(), before);
  }

  // The window goes away while a pass is installed, and the pass outlives it.
  vtkSmartPointer<vtkOITPass> survivor = setup.CreatePass();
  {
    Rig other(setup, 16, 12);
    vtkOITRendererHook::Install(other.Renderer, survivor);
    other.AddStack(layers);
    report.Compare("in another window", other.Render(), expected, bound);
  }
  vtkOITRendererHook::Install(rig.Renderer, survivor);
  report.Compare("moved to a window that was there before", rig.Render(), expected, bound);
}

/// A renderer with a pass of its own, set before or after: the translucent slots of VTK's containers
/// are taken, and given back.
void CheckChains(Report& report, const Setup& setup)
{
  const std::vector<Layer> layers = Random(52).Layers(8);
  Rig rig(setup, 16, 12);
  setup.Detach(rig.Renderer);
  rig.AddStack(layers);
  const Report::Expected expected =
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground()));
  vtkNew<vtkRenderStepsPass> steps;
  vtkRenderPass* translucent = steps->GetTranslucentPass();
  vtkNew<vtkSSAAPass> ssaa;
  ssaa->SetDelegatePass(steps);
  for (const bool isBefore : { true, false })
  {
    const std::string what = isBefore ? "a chain set before" : "a chain set after";
    if (isBefore)
    {
      rig.Renderer->SetPass(ssaa);
    }
    vtkOITRendererHook::Install(rig.Renderer, rig.Pass);
    rig.Renderer->SetPass(ssaa);
    report.Compare(what, rig.RenderWindow(), expected, Rig::WindowTolerance());
    report.Check(rig.Pass->GetNumberOfGeometryPasses() > 0 && rig.Pass->GetExact(),
      what + ": the pass was not asked, or is not exact");
    report.Check(steps->GetTranslucentPass() == rig.Pass, what + ": another pass in the slot");
    vtkOITRendererHook::Uninstall(rig.Renderer);
    report.Check(steps->GetTranslucentPass() == translucent, what + ": the slot is not given back");
    rig.Renderer->SetPass(nullptr);
  }
}

/// What keeps the renderer from asking the pass is told once, and no frame is called exact.
void CheckObstacles(Report& report, const Setup& setup)
{
  using Change = std::function<void(vtkRenderer*)>;
  vtkNew<vtkDefaultPass> chain;
  const std::vector<std::pair<std::string, Change>> obstacles{
    { "UseDepthPeeling", [](vtkRenderer* renderer) { renderer->UseDepthPeelingOff(); } },
    { "UseShadows", [](vtkRenderer* renderer) { renderer->UseShadowsOn(); } },
    { "vtkDefaultPass", [&](vtkRenderer* renderer) { renderer->SetPass(chain); } }
  };
  vtkSmartPointer<vtkOutputWindow> previous = vtkOutputWindow::GetInstance();
  for (const auto& [name, change] : obstacles)
  {
    Rig rig(setup, 16, 12);
    rig.AddStack(Random(53).Layers(3));
    report.Check(!rig.Pass->GetExact(), name + ": exact before the first frame");
    rig.RenderWindow();
    report.Check(rig.Pass->GetExact(), name + ": the first frame is not exact");
    change(rig.Renderer);
    vtkNew<vtkStringOutputWindow> messages;
    vtkOutputWindow::SetInstance(messages);
    rig.RenderWindow();
    const std::string first = messages->GetOutput();
    rig.RenderWindow();
    const std::string second = messages->GetOutput();
    vtkOutputWindow::SetInstance(previous);
    std::string wrong = name;
    wrong.append(": the warning is ").append(first);
    report.Check(first.find(name) != std::string::npos, wrong);
    report.Check(second == first, name + ": warned again");
    report.Check(!rig.Pass->GetExact() && rig.Pass->GetNumberOfGeometryPasses() == 0,
      name + ": a frame without the pass is called exact");
    rig.RemoveProps();
    rig.RenderWindow();
    report.Check(rig.Pass->GetExact(), name + ": a frame without translucent props is not exact");
  }
}
}

int TestRendererHook(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      CheckErrors(report, setup);
      CheckCycle(report, setup);
      CheckChains(report, setup);
      CheckObstacles(report, setup);
    });
}
