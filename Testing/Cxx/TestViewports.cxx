// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 28: odd sizes, and viewports with an offset in a larger window: the picture is the
// one of a window of the viewport's size, and nothing outside the viewport changes.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

using namespace vtkOITTest;

namespace
{
void CheckOddSizes(Report& report, const Setup& setup)
{
  const std::vector<Layer> layers = Random(23).Layers(6);
  const std::pair<int, int> sizes[] = { { 1, 1 }, { 3, 7 }, { 257, 129 } };
  for (const auto& size : sizes)
  {
    Rig rig(setup, size.first, size.second);
    rig.AddStack(layers);
    const Report::Expected expected =
      Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground()));
    const Tolerance bound =
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage);
    const std::string what = std::to_string(size.first) + "x" + std::to_string(size.second);
    report.Compare(what, rig.Render(), expected, bound);
    report.Compare(
      what + " in the window", rig.RenderWindow(), expected, bound + Rig::WindowTolerance());
  }
}

/// Spheres and an opaque one, which have a different picture in each pixel.
void AddScene(vtkRenderer* renderer, Rig& rig)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  sphere->Update();
  for (int i = 0; i < 4; ++i)
  {
    vtkActor* actor = rig.AddPolyData(
      sphere->GetOutput(), { 0.2f + 0.2f * i, 0.9f - 0.2f * i, 0.3f, i == 0 ? 1.0f : 0.4f });
    actor->SetPosition(0.3 * i - 0.5, 0.2 * i - 0.3, 0.1 * (i % 2));
    if (renderer != rig.Renderer)
    {
      renderer->AddActor(actor);
      rig.Renderer->RemoveActor(actor);
    }
  }
}

/// A renderer with a viewport of 60 x 40 pixels at (30, 20), over one that fills the window.
void CheckOffset(Report& report, const Setup& setup)
{
  Rig plain(setup, 60, 40);
  plain.SetBackground(glm::dvec4(0.2, 0.4, 0.6, 1.0));
  AddScene(plain.Renderer, plain);
  const Image expected = plain.RenderWindow();

  Rig rig(setup, 120, 80);
  rig.Window->SetNumberOfLayers(2);
  rig.SetBackground(glm::dvec4(1.0, 0.0, 1.0, 1.0));
  vtkNew<vtkRenderer> inner;
  inner->SetLayer(1);
  inner->SetViewport(0.25, 0.25, 0.75, 0.75);
  inner->SetActiveCamera(plain.Renderer->GetActiveCamera());
  inner->SetBackground(plain.Renderer->GetBackground());
  // Under it, in the colours of the plain case, a quad instead of the background: renderers of
  // higher layers do not clear the colours.
  const glm::dvec4 background = plain.GetBackground();
  rig.AddQuad({ 0.99f, glm::vec4(background) }, { 30.0, 20.0, 90.0, 60.0 });
  rig.Window->AddRenderer(inner);
  const auto pass = setup.CreatePass();
  setup.Attach(inner, pass);
  AddScene(inner, rig);

  for (int frame = 0; frame < 2; ++frame)
  {
    const Image image = rig.RenderWindow();
    report.CompareBits("viewport with an offset", Crop(image, 30, 20, 60, 40), expected);
    report.Compare("outside of the viewport", image,
      [&](int x, int y)
      {
        const bool inside = x >= 30 && x < 90 && y >= 20 && y < 60;
        return inside ? glm::dvec4(image.At(x, y)) : glm::dvec4(1.0, 0.0, 1.0, 1.0);
      },
      { 0.0, 0.0 });
  }
}
}

int TestViewports(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(28);
      CheckOddSizes(report, setup);
      CheckOffset(report, setup);
    });
}
