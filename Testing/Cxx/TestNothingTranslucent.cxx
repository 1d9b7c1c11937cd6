// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 35: without anything translucent to see, a pass does nothing: zero geometry passes,
// nothing allocated, the picture as without it. And a scene with opaque, translucent and empty
// pixels is right in each of them.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/GLObjects.h"
#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

using namespace vtkOITTest;

namespace
{
constexpr int Width = 40;
constexpr int Height = 30;
const glm::vec4 Red(0.9f, 0.2f, 0.1f, 0.5f);

struct Scene
{
  const char* Name;
  void (*Build)(Rig&);
};

const Scene Scenes[] = {
  { "no props", [](Rig&) {} },
  { "opaque props",
    [](Rig& rig) {
      rig.AddQuad({ 0.5f, { 0.1f, 0.9f, 0.2f, 1.0f } }, { 5.0, 5.0, 25.0, 20.0 });
    } },
  { "invisible translucent prop",
    [](Rig& rig)
    {
      rig.AddQuad({ 0.5f, { 0.1f, 0.9f, 0.2f, 1.0f } }, { 5.0, 5.0, 25.0, 20.0 });
      rig.AddQuad({ 0.25f, Red })->VisibilityOff();
    } },
  { "empty translucent poly data",
    [](Rig& rig)
    {
      vtkNew<vtkPolyData> empty;
      empty->SetPoints(vtkNew<vtkPoints>());
      empty->SetPolys(vtkNew<vtkCellArray>());
      rig.AddPolyData(empty, Red);
      rig.AddPolyData(vtkNew<vtkPolyData>(), Red);
    } },
  { "translucent prop beside the viewport",
    [](Rig& rig) {
      rig.AddQuad({ 0.5f, Red }, { 50.0, 5.0, 70.0, 20.0 });
    } },
  { "translucent prop behind the camera",
    [](Rig& rig) {
      rig.AddQuad({ -4.0f, Red }, { 5.0, 5.0, 25.0, 20.0 });
    } },
};

void CheckNothing(Report& report, const Setup& setup, const Scene& scene)
{
  const std::string what = scene.Name;
  Rig rig(setup, Width, Height);
  setup.Detach(rig.Renderer);
  scene.Build(rig);
  const Image expected = rig.Render();
  const Image expectedWindow = rig.RenderWindow();
  rig.Window->MakeCurrent();
  const GLObjectCounts before = GLObjectCounts::OfCurrentContext();

  setup.Attach(rig.Renderer, rig.Pass);
  for (int frame = 0; frame < 3; ++frame)
  {
    report.CompareBits(what, rig.Render(), expected);
    report.CompareBits(what + " in the window", rig.RenderWindow(), expectedWindow);
    report.Check(rig.Pass->GetNumberOfGeometryPasses() == 0,
      what + ": " + std::to_string(rig.Pass->GetNumberOfGeometryPasses()) + " geometry passes");
    report.Check(rig.Pass->GetNumberOfFragments() == 0, what + ": fragments were counted");
    report.Check(rig.Pass->GetMaximumDepthComplexity() == 0, what + ": layers were counted");
    report.Check(rig.Pass->GetBufferSizeInBytes() == 0, what + ": buffers were allocated");
    report.Check(rig.Pass->GetExact() && rig.Pass->GetErrorBound() == 0.0,
      what + ": nothing was drawn, which is exact");
  }
  rig.Window->MakeCurrent();
  const GLObjectCounts after = GLObjectCounts::OfCurrentContext();
  report.Check(
    before == after, what + ": objects went from " + before.Describe() + " to " + after.Describe());
}

/// Half of the viewport opaque, a translucent quad over a part of both halves.
void CheckMixedPixels(Report& report, const Setup& setup)
{
  Rig rig(setup, Width, Height);
  const PixelRectangle opaque{ 0.0, 0.0, 20.0, 30.0 };
  const PixelRectangle translucent{ 10.0, 5.0, 30.0, 25.0 };
  const glm::vec4 green(0.1f, 0.9f, 0.2f, 1.0f);
  rig.AddQuad({ 0.75f, green }, opaque);
  rig.AddQuad({ 0.5f, Red }, translucent);
  const glm::dvec4 background = rig.GetBackground();
  report.Compare(
    "opaque, translucent and empty pixels", rig.Render(),
    [&](int x, int y)
    {
      const glm::dvec4 behind = opaque.Contains(x, y) ? glm::dvec4(green) : background;
      return translucent.Contains(x, y) ? ReferenceCompositor::Composite({ { 0.5f, Red } }, behind)
                                        : behind;
    },
    ReferenceCompositor::RoundingBoundOfAnyStack(1, setup.FragmentStorage));
}
}

int TestNothingTranslucent(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(35);
      if (setup.FragmentStorage == Storage::Half) // what is not stored has no format
      {
        for (const Scene& scene : Scenes)
        {
          CheckNothing(report, setup, scene);
        }
      }
      CheckMixedPixels(report, setup);
    });
}
