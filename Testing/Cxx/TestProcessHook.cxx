// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Every renderer of a process, without a word to the application: reached, as it was between frames,
// and given back.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/LineCatcher.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkCameraPass.h"
#include "vtkDefaultPass.h"
#include "vtkNew.h"
#include "vtkOITProcessHook.h"
#include "vtkOITRendererHook.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOutputWindow.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAAPass.h"
#include "vtkStringOutputWindow.h"

using namespace vtkOITTest;

namespace
{
/// Keeps what VTK says for the time of a scope.
class Messages
{
public:
  Messages() { vtkOutputWindow::SetInstance(this->Window); }
  ~Messages() { vtkOutputWindow::SetInstance(this->Previous); }
  std::string Get() { return this->Window->GetOutput(); }

private:
  vtkSmartPointer<vtkOutputWindow> Previous = vtkOutputWindow::GetInstance();
  vtkNew<vtkStringOutputWindow> Window;
};

/// A renderer of VTK's, as an application makes it, with a stack of layers in a window of its own.
struct Application
{
  explicit Application(const Setup& setup)
    : Scene(setup, 16, 12)
    , Layers(Random(61).Layers(8))
    , Expected(Everywhere(ReferenceCompositor::Composite(this->Layers, Scene.GetBackground())))
  {
    setup.Detach(this->Scene.Renderer);
    this->Scene.Renderer->UseDepthPeelingOff();
    this->Scene.AddStack(this->Layers);
  }

  vtkOITPass* GetPass() const { return vtkOITRendererHook::GetInstalledPass(this->Scene.Renderer); }

  /// Whether the next frame is right, and drawn by a pass.
  void CheckReached(Report& report, const std::string& what)
  {
    const int switched = this->Scene.Renderer->GetUseDepthPeeling();
    report.Compare(what, this->Scene.RenderWindow(), this->Expected, Rig::WindowTolerance());
    vtkOITPass* pass = this->GetPass();
    report.Check(pass && pass->GetNumberOfGeometryPasses() > 0 && pass->GetExact(),
      what + ": there is no pass, or it did not draw");
    report.Check(this->Scene.Renderer->GetUseDepthPeeling() == switched,
      what + ": the renderer's UseDepthPeeling is changed");
  }

  Rig Scene;
  std::vector<Layer> Layers;
  Report::Expected Expected;
};

void CheckReach(Report& report, const Setup& setup)
{
  const Image stock = Application(setup).Scene.RenderWindow();
  Application before(setup);
  report.Check(vtkOITProcessHook::Install("abuffer"), "not installed");
  report.Check(vtkOITProcessHook::GetInstalledMethod() == "abuffer", "another method");
  vtkNew<vtkRenderer> single;
  report.Check(vtkOITRendererHook::GetInstalledPass(single), "no pass in a new renderer");

  Application application(setup);
  vtkRenderer* renderer = application.Scene.Renderer;
  application.CheckReached(report, "a renderer of a new window");
  vtkOITPass* pass = application.GetPass();
  renderer->UseDepthPeelingOn();
  application.CheckReached(report, "with peeling switched on");
  renderer->UseDepthPeelingOff();
  renderer->RemoveAllObservers();
  application.CheckReached(report, "without observers");
  report.Check(application.GetPass() == pass, "another pass after some frames");

  vtkNew<vtkOpenGLRenderer> own; // as an application's class, past the factory
  own->SetLayer(1);
  application.Scene.Window->SetNumberOfLayers(2);
  application.Scene.Window->AddRenderer(own);
  application.CheckReached(report, "with a second renderer");
  report.Check(vtkOITRendererHook::GetInstalledPass(own), "no pass in a renderer added later");
  application.Scene.Window->RemoveRenderer(own);

  before.Scene.RenderWindow();
  report.Check(!before.GetPass(), "a window from before was reached");
  vtkOITProcessHook::ReachWindow(before.Scene.Window);
  before.CheckReached(report, "a window from before, when asked for");

  report.Check(vtkOITProcessHook::Uninstall(), "not uninstalled");
  report.Check(!vtkOITProcessHook::Uninstall(), "uninstalled twice");
  for (vtkRenderer* each : { renderer, before.Scene.Renderer.Get(), single.Get() })
  {
    report.Check(!vtkOITRendererHook::GetInstalledPass(each), "a pass is left in a renderer");
  }
  report.CompareBits("after uninstalling", application.Scene.RenderWindow(), stock);
  report.Check(!application.GetPass(), "reached after uninstalling");
  vtkNew<vtkRenderer> late;
  report.Check(!vtkOITRendererHook::GetInstalledPass(late), "a pass in a renderer made later");

  vtkOITProcessHook::Install("auto");
  application.CheckReached(report, "installed again");
  before.CheckReached(report, "installed again, a window from before");
  report.Check(
    !vtkOITRendererHook::GetInstalledPass(late), "one that was never reached is reached");
  vtkOITProcessHook::Uninstall();
}

/// The method and the properties of passes that draw already.
void CheckChanges(Report& report, const Setup& setup)
{
  vtkOITProcessHook::Install("abuffer");
  Application application(setup);
  application.CheckReached(report, "before changes");
  vtkOITPass* first = application.GetPass();
  vtkOITProcessHook::Install("abuffer");
  report.Check(application.GetPass() == first, "the same method: another pass");
  vtkOITProcessHook::Install("auto");
  report.Check(application.GetPass()->IsA("vtkOITAutoPass"), "the method is not changed");
  application.CheckReached(report, "another method");

  report.Check(vtkOITProcessHook::SetTransmittanceThreshold(0.25), "a threshold is refused");
  report.Check(vtkOITProcessHook::SetMaximumBufferSize(1 << 24), "a size is refused");
  const auto check = [&](vtkRenderer* renderer, const std::string& what)
  {
    vtkOITPass* pass = vtkOITRendererHook::GetInstalledPass(renderer);
    report.Check(pass->GetTransmittanceThreshold() == 0.25, what + ": the threshold is not set");
    report.Check(pass->GetMaximumBufferSize() == 1 << 24, what + ": the size is not set");
  };
  check(application.Scene.Renderer, "a renderer that draws");
  check(vtkNew<vtkRenderer>(), "a new renderer");
  {
    const LineCatcher lines;
    report.Check(!vtkOITProcessHook::SetTransmittanceThreshold(2), "a wrong threshold is taken");
    report.Check(!vtkOITProcessHook::SetMaximumBufferSize(-1), "a wrong size is taken");
    report.Check(lines.GetTexts().size() == 2, "not one line for each: " + lines.Describe());
  }
  check(application.Scene.Renderer, "after wrong values");
  vtkOITProcessHook::SetTransmittanceThreshold(1.0 / 512.0);
  vtkOITProcessHook::SetMaximumBufferSize(0);
  application.CheckReached(report, "with the defaults again");
  vtkOITProcessHook::Uninstall();
}

/// What was made while nothing is installed is reached later, when asked for.
void CheckWatch(Report& report, const Setup& setup)
{
  Application before(setup);
  vtkOITProcessHook::SetWatch(true);
  Application application(setup);
  vtkOITProcessHook::ReachWindow(before.Scene.Window);
  for (Application* each : { &before, &application })
  {
    each->Scene.RenderWindow();
    report.Check(!each->GetPass(), "reached while nothing is installed");
  }
  for (int i = 0; i < 2; ++i)
  {
    vtkOITProcessHook::Install();
    application.CheckReached(report, "made before the installation");
    before.CheckReached(report, "asked for before the installation");
    vtkOITProcessHook::Uninstall();
    report.Check(!application.GetPass() && !before.GetPass(), "not given back");
  }
  vtkOITProcessHook::SetWatch(false);
  Application after(setup);
  vtkOITProcessHook::Install();
  after.Scene.RenderWindow();
  report.Check(!after.GetPass(), "remembered when not watching");
  vtkOITProcessHook::Uninstall();
}

/// Lets the renderer draw by itself, as ParaView's class of that name; it is known by its name.
class ParaViewPass : public vtkRenderPass
{
public:
  static ParaViewPass* New() { return new ParaViewPass; }
  const char* GetClassNameInternal() const override { return "vtkPVDefaultPass"; }
  vtkTypeBool IsA(const char* name) override
  {
    return std::string(name) == "vtkPVDefaultPass" || this->vtkRenderPass::IsA(name);
  }
  void Render(const vtkRenderState* state) override
  {
    this->UpdateLightGeometry(state->GetRenderer());
    this->UpdateLights(state->GetRenderer());
    this->UpdateGeometry(state->GetRenderer());
  }
};

/// Chains of passes: those that have a slot are reached, others are drawn as without us.
void CheckChains(Report& report, const Setup& setup)
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkRenderPass* translucent = steps->GetTranslucentPass();
  vtkNew<vtkSSAAPass> ssaa;
  ssaa->SetDelegatePass(steps);
  vtkNew<vtkDefaultPass> inner; // draws what is translucent by itself
  vtkNew<vtkCameraPass> hidden;
  hidden->SetDelegatePass(inner);
  Application stock(setup);
  stock.Scene.Renderer->SetPass(hidden);
  const Image without = stock.Scene.RenderWindow();
  report.Check(without.At(0, 0).a > 0.5, "the stock picture is empty");

  vtkOITProcessHook::Install();
  Messages messages;
  Application application(setup);
  application.Scene.Renderer->SetPass(ssaa);
  application.CheckReached(report, "a chain");
  report.Check(steps->GetTranslucentPass() == application.GetPass(), "not in the chain's slot");
  application.Scene.Renderer->SetPass(hidden);
  report.CompareBits("a chain that hides its pass", application.Scene.RenderWindow(), without);
  application.Scene.Renderer->SetPass(ssaa);
  application.CheckReached(report, "the chain again");
  hidden->SetDelegatePass(vtkNew<ParaViewPass>());
  application.Scene.Renderer->SetPass(hidden);
  application.CheckReached(report, "ParaView's chain");
  vtkOITProcessHook::Uninstall();
  report.Check(steps->GetTranslucentPass() == translucent, "the slot is not given back");
  report.Check(messages.Get().empty(), "the application was told: " + messages.Get());
}

void CheckRespect(Report& report, const Setup& setup)
{
  Application stock(setup);
  const Image without = stock.Scene.RenderWindow();
  vtkOITProcessHook::SetRespectDepthPeeling(true);
  vtkOITProcessHook::Install();
  {
    Messages messages;
    Application application(setup);
    report.CompareBits("peeling off", application.Scene.RenderWindow(), without);
    application.Scene.Renderer->UseDepthPeelingOn();
    application.CheckReached(report, "peeling on");
    application.Scene.Renderer->UseDepthPeelingOff();
    report.CompareBits("peeling off again", application.Scene.RenderWindow(), without);
    report.Check(messages.Get().empty(), "the application was told: " + messages.Get());
  }
  vtkOITProcessHook::Uninstall();
  vtkOITProcessHook::SetRespectDepthPeeling(false);
}

/// An application that knows vtkOIT keeps its passes.
void CheckOthers(Report& report, const Setup& setup)
{
  {
    Messages messages;
    report.Check(!vtkOITProcessHook::Install("no such method"), "installed an unknown method");
    report.Check(messages.Get().find("abuffer") != std::string::npos, "the methods are not told");
    report.Check(vtkOITProcessHook::GetInstalledMethod().empty(), "an unknown method is kept");
  }
  vtkOITProcessHook::Install();
  Application application(setup);
  vtkOITRendererHook::Install(application.Scene.Renderer, application.Scene.Pass);
  application.CheckReached(report, "a pass of the application's own");
  report.Check(application.GetPass() == application.Scene.Pass, "it was replaced");
  vtkOITProcessHook::Uninstall();
  report.Check(application.GetPass() == application.Scene.Pass, "it was taken out");
  vtkOITRendererHook::Uninstall(application.Scene.Renderer);
  report.Check(!application.Scene.Renderer->GetUseDepthPeeling(), "peeling is left on");
}
}

int TestProcessHook(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig::KeepWindow(false); // windows are to be new ones
      CheckReach(report, setup);
      CheckChanges(report, setup);
      CheckChains(report, setup);
      CheckRespect(report, setup);
      CheckOthers(report, setup);
      CheckWatch(report, setup);
    });
}
