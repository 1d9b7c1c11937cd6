// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Several renderers in a window, side by side and in layers, with a pass each and with one pass
// for all of them.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

using namespace vtkOITTest;

namespace
{
constexpr int Width = 48;
constexpr int Height = 20;

/// A stack of layers over the whole viewport of a renderer.
void AddStackTo(Rig& rig, vtkRenderer* renderer, const std::vector<Layer>& layers)
{
  for (const Layer& layer : layers)
  {
    // Large enough for every viewport's aspect ratio.
    vtkActor* actor = rig.AddQuad(layer, { -2.0 * Width, -Height, 3.0 * Width, 2.0 * Height });
    if (renderer != rig.Renderer)
    {
      renderer->AddActor(actor);
      rig.Renderer->RemoveActor(actor);
    }
  }
}

void CheckRenderers(Report& report, const Setup& setup, bool share)
{
  const std::string what = share ? "one pass for all" : "a pass each";
  Rig rig(setup, Width, Height);
  rig.Window->SetNumberOfLayers(2);
  rig.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  const glm::dvec4 leftBackground = rig.GetBackground();
  const glm::dvec4 rightBackground(0.8, 0.2, 0.4, 1.0);

  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetBackground(rightBackground.r, rightBackground.g, rightBackground.b);
  right->SetBackgroundAlpha(1.0);
  vtkNew<vtkRenderer> top; // over the upper half of both, starts with its own depth
  top->SetLayer(1);
  top->SetViewport(0.0, 0.5, 1.0, 1.0);
  std::vector<vtkSmartPointer<vtkOITPass>> passes;
  for (vtkRenderer* renderer : { right.Get(), top.Get() })
  {
    renderer->SetActiveCamera(rig.Renderer->GetActiveCamera());
    rig.Window->AddRenderer(renderer);
    passes.push_back(share ? rig.Pass : setup.CreatePass());
    setup.Attach(renderer, passes.back());
  }

  Random random(31);
  const std::vector<Layer> leftLayers = random.Layers(9);
  const std::vector<Layer> rightLayers = random.Layers(5);
  const std::vector<Layer> topLayers = random.Layers(3);
  AddStackTo(rig, rig.Renderer, leftLayers);
  AddStackTo(rig, right, rightLayers);
  AddStackTo(rig, top, topLayers);

  const glm::dvec4 left = ReferenceCompositor::Composite(leftLayers, leftBackground);
  const glm::dvec4 rightColor = ReferenceCompositor::Composite(rightLayers, rightBackground);
  const Report::Expected expected = [&](int x, int y)
  {
    const glm::dvec4 below = x < Width / 2 ? left : rightColor;
    return y < Height / 2 ? below : ReferenceCompositor::Composite(topLayers, below);
  };
  // The lower layer's picture is rounded to 8 bits before the upper layer is drawn on it.
  const Tolerance bound = ReferenceCompositor::RoundingBoundOfAnyStack(12, setup.FragmentStorage) +
    Rig::WindowTolerance() + Tolerance{ 1.0 / 255, 1.0 / 255 };
  for (int frame = 0; frame < 3; ++frame)
  {
    report.Compare(what + ", frame " + std::to_string(frame), rig.RenderWindow(), expected, bound);
  }

  // A renderer leaves, the others stay right.
  setup.Detach(top);
  rig.Window->RemoveRenderer(top);
  report.Compare(
    what + ", top layer gone", rig.RenderWindow(),
    [&](int x, int) { return x < Width / 2 ? left : rightColor; }, bound);
}
}

int TestRenderers(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(28);
      CheckRenderers(report, setup, false);
      CheckRenderers(report, setup, true);
    });
}
