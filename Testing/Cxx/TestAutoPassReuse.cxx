// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Frames in which nothing has changed are reused, and only those: after each kind of change the
// picture is the one that is drawn without reuse.

#include "Rig/Rig.h"
#include "Scenes/ReuseChanges.h"
#include "Scenes/ReuseScene.h"

#include "vtkActor.h"
#include "vtkAutoInit.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkOITAutoPass.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextActor.h"
#include "vtkTexture.h"
#include "vtkTranslucentPass.h"

#include <cmath>

VTK_MODULE_INIT(vtkRenderingFreeType); // for vtkTextActor

using namespace vtkOITTest;

namespace
{
constexpr int Width = 64;
constexpr int Height = 48;
constexpr Tolerance LastBits{ 1e-6, 1e-6 }; // of a layer composited over a float32 framebuffer

bool IsReused(vtkOITAutoPass* pass)
{
  return pass->GetSkipSummary().find("whole frame reused") != std::string::npos;
}

double FindLargestDifference(const Image& a, const Image& b)
{
  double largest = a.Pixels.size() == b.Pixels.size() ? 0.0 : HUGE_VAL;
  for (std::size_t i = 0; i < a.Pixels.size() && i < b.Pixels.size(); ++i)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      largest = std::max<double>(largest, std::abs(a.Pixels[i][channel] - b.Pixels[i][channel]));
    }
  }
  return largest;
}

/// Renders until a frame is reused; it has the same bits as the one before.
Image RenderStill(Report& report, ReuseScene& scene, const std::string& what)
{
  scene.TheRig.Render();
  const Image second = scene.TheRig.Render();
  Image third = scene.TheRig.Render();
  report.Check(IsReused(scene.Pass) && scene.Pass->GetNumberOfGeometryPasses() == 0,
    what + ": the third still frame is not reused");
  report.CompareBits(what + ", third still frame", third, second);
  return third;
}

Image RenderFresh(ReuseScene& scene)
{
  scene.Pass->ReuseFramesOff();
  Image image = scene.TheRig.Render();
  scene.Pass->ReuseFramesOn();
  return image;
}

void CheckChange(Report& report, ReuseScene& scene, const Change& change)
{
  const Image before =
    change.Is == Change::NotReady ? scene.TheRig.Render() : RenderStill(report, scene, change.Name);
  change.Do(scene);
  const Image after = scene.TheRig.Render();
  const bool isReused = IsReused(scene.Pass);
  report.Check(isReused == (change.Is == Change::Shown),
    change.Name + (isReused ? ": is not seen" : ": the frame is not reused"));
  report.Check(
    FindLargestDifference(before, after) > 1e-3 || isReused, change.Name + ": changes nothing");
  report.Compare(change.Name, after, RenderFresh(scene), LastBits);
}

void CheckPass(Report& report, const Setup& setup)
{
  Rig rig(setup, Width, Height);
  ReuseScene scene(rig);
  rig.Render();
  for (const auto& change : GetPassChanges())
  {
    CheckChange(report, scene, change);
  }
  scene.Pass->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
  // Half floats or floats: too little to be seen, but whoever asks for it must get it.
  for (const auto& change :
    std::vector<Change>{
      { "precision",
        [](ReuseScene& s)
        {
          s.Pass->SetFragmentPrecision(s.Pass->GetFragmentPrecision() == vtkOITPass::HALF
              ? vtkOITPass::FLOAT
              : vtkOITPass::HALF);
        } },
      { "threshold", [](ReuseScene& s) { s.Pass->SetTransmittanceThreshold(0.25); } },
      { "sorting", [](ReuseScene& s) { s.Pass->SkipSortingOff(); } },
      { "peels", [](ReuseScene& s) { s.Pass->SetMaximumNumberOfPeels(100); } },
    })
  {
    RenderStill(report, scene, change.Name);
    change.Do(scene);
    rig.Render();
    report.Check(!IsReused(scene.Pass), change.Name + ": is not seen");
  }
}

/// A uniform that an observer sets anew for each frame.
struct UniformSetter
{
  float Value = 0.1f;
  void Set(vtkObject*, unsigned long, void* data)
  {
    static_cast<vtkShaderProgram*>(data)->SetUniformf("red", this->Value);
  }
};

void CheckUniforms(Report& report, const Setup& setup)
{
  Rig rig(setup, Width, Height);
  ReuseScene scene(rig);
  UniformSetter setter;
  scene.Ball->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  gl_FragData[0].r = red;\n", false);
  scene.Ball->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Color::Dec", true, "//VTK::Color::Dec\nuniform float red;\n", false);
  scene.BallMapper->AddObserver(vtkCommand::UpdateShaderEvent, &setter, &UniformSetter::Set);
  Image before = rig.Render();
  for (int frame = 0; frame < 5; ++frame)
  {
    setter.Value += 0.15f;
    const Image image = rig.Render();
    report.Check(!IsReused(scene.Pass), "a frame with a uniform of an observer is reused");
    report.Check(FindLargestDifference(before, image) > 0.01, "the uniform is not seen");
    before = image;
  }
}

/// The layer belongs to one renderer of one window.
void CheckRenderers(Report& report, const Setup& setup)
{
  Rig rig(setup, Width, Height);
  ReuseScene scene(rig);
  rig.Render();
  RenderStill(report, scene, "one renderer");

  // The same props in a second renderer, by the same pass.
  vtkNew<vtkRenderer> second;
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(rig.Renderer->GetActiveCamera());
  second->SetActiveCamera(camera);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  rig.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  for (vtkActor* actor : { scene.Ball.Get(), scene.SecondBall.Get(), scene.Poster.Get() })
  {
    second->AddActor(actor);
  }
  rig.Window->AddRenderer(second);
  setup.Attach(second, rig.Pass);
  const Image first = rig.RenderWindow();
  for (int frame = 0; frame < 4; ++frame)
  {
    report.Compare("two renderers", rig.RenderWindow(), first, { 1.1 / 255.0, 1.1 / 255.0 });
  }
  camera->Azimuth(40.0);
  const Image turned = rig.RenderWindow();
  report.Check(FindLargestDifference(first, turned) > 0.01, "the second renderer is not redrawn");
  setup.Detach(second);
  rig.Window->RemoveRenderer(second);
  rig.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  const Image still = RenderStill(report, scene, "one renderer left");

  // Another window, with the camera and the props of the first.
  setup.Detach(rig.Renderer);
  {
    Rig other(setup, Width, Height);
    setup.Attach(other.Renderer, rig.Pass);
    other.Renderer->SetActiveCamera(rig.Renderer->GetActiveCamera());
    for (vtkActor* actor : { scene.TableActor.Get(), scene.Poster.Get() })
    {
      actor->ReleaseGraphicsResources(rig.Window); // VTK 9.6 takes along what the window had
      other.Renderer->AddActor(actor);
    }
    other.Render();
    const Image second2 = other.Render();
    report.CompareBits("another window", other.Render(), second2);
    scene.Pass->ReuseFramesOff();
    report.Compare("another window, fresh", second2, other.Render(), LastBits);
    scene.Pass->ReuseFramesOn();
    setup.Detach(other.Renderer);
    other.Renderer->RemoveAllViewProps();
    for (vtkActor* actor : { scene.TableActor.Get(), scene.Poster.Get() })
    {
      actor->ReleaseGraphicsResources(other.Window);
    }
  }
  setup.Attach(rig.Renderer, rig.Pass);
  report.Compare("back in the first window", rig.Render(), still, LastBits);
  RenderStill(report, scene, "back in the first window");
}

void CheckNewContext(Report& report, const Setup& setup)
{
  Rig rig(setup, Width, Height);
  ReuseScene scene(rig);
  rig.RenderWindow();
  rig.RenderWindow();
  rig.RenderWindow();
  const Image before = rig.RenderWindow();
  report.Check(IsReused(scene.Pass), "window: the third frame is not reused");
  rig.Window->Finalize();
  const Image after = rig.RenderWindow();
  report.Check(!IsReused(scene.Pass), "a layer of a context that is gone is reused");
  report.Compare("after Finalize()", after, before, { 1.1 / 255.0, 1.1 / 255.0 });
}
}

int TestAutoPassReuse(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [&](Report& report, const Setup& setup)
    {
      if (IsAsked(argc, argv, "pass"))
      {
        CheckPass(report, setup);
        CheckUniforms(report, setup);
        CheckRenderers(report, setup);
        CheckNewContext(report, setup);
      }
      if (!IsAsked(argc, argv, "changes"))
      {
        return;
      }
      const bool isFirst = setup.FragmentStorage == Storage::Half && setup.Tier == "all extensions";
      Rig rig(setup, Width, Height);
      ReuseScene scene(rig);
      rig.Render();              // makes default lookup tables, which is a change
      for (const auto& changes : // in this order, as what they do stays
        { GetLightChanges(), GetViewChanges(), GetPropChanges(), GetDataChanges() })
      {
        for (const Change& change : changes)
        {
          CheckChange(report, scene, change);
          if (!isFirst)
          {
            break; // the rest does not depend on the tier
          }
        }
      }
      vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(2.0, 2.0); // VTK's
    });
}
