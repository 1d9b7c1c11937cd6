// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 36: an opacity that goes from 0 to 1 over 4096 pixels, behind 10 layers, in front of
// them and among them. In a float32 framebuffer the formula holds in each pixel; in an 8-bit window
// no step is larger than those of the format.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <glm/vec2.hpp>

#include <cmath>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 4096;
constexpr int Height = 2;

/// Opacity x / Width at x pixels: scalars of 0 and 255 at the borders, interpolated.
void AddGradient(Rig& rig, float depth)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 2, 3 });
  for (const glm::dvec2& corner :
    { glm::dvec2(0, 0), glm::dvec2(Width, 0), glm::dvec2(Width, Height), glm::dvec2(0, Height) })
  {
    const glm::dvec3 point = rig.ToWorld(corner.x, corner.y, depth);
    points->InsertNextPoint(point.x, point.y, point.z);
    colors->InsertNextTuple4(255, 51, 0, corner.x > 0.0 ? 255 : 0);
  }
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetPolys(quads);
  polydata->GetPointData()->SetScalars(colors);
  rig.AddPolyData(polydata, glm::vec4(1.0f))->ForceTranslucentOn();
}

void CheckGradient(Report& report, Rig& rig, const Setup& setup, float depth)
{
  const std::vector<Layer> layers = EqualLayers(Random(36).Depths(10), { 0.1f, 0.5f, 0.9f, 0.06f });
  rig.RemoveProps();
  rig.AddStack(layers);
  AddGradient(rig, depth);
  std::vector<glm::dvec4> expected;
  for (int x = 0; x < Width; ++x)
  {
    std::vector<Layer> all = layers;
    all.push_back({ depth, { 1.0f, 0.2f, 0.0f, float((x + 0.5) / Width) } });
    expected.push_back(ReferenceCompositor::Composite(all, rig.GetBackground()));
  }
  const Report::Expected formula = [&](int x, int) { return expected[x]; };
  const std::string what = "gradient at depth " + std::to_string(depth);
  // The opacity is interpolated in float32: some steps of 2^-24.
  const Tolerance bound = ReferenceCompositor::RoundingBoundOfAnyStack(11, setup.FragmentStorage) +
    Tolerance{ 1e-6, 1e-6 };
  report.Compare(what, rig.Render(), formula, bound);

  const Image window = rig.RenderWindow();
  report.Compare(what + ", in the window", window, formula, bound + Rig::WindowTolerance());
  if (!setup.HasFetch) // the blend unit rounds source, factor and result: 1.5 steps each way
  {
    return;
  }
  // No band: neighbours differ by a step of 1/255 at most, as the formula's do by far less.
  int jumps = 0;
  for (int x = 1; x < Width; ++x)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      jumps += std::abs(window.At(x, 0)[channel] - window.At(x - 1, 0)[channel]) > 1.5f / 255;
    }
  }
  report.Check(jumps == 0, what + ": " + std::to_string(jumps) + " jumps in the window");
}
}

int TestOpacityGradient(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(36);
      Rig rig(setup, Width, Height);
      for (const float depth : { 0.0625f, 0.5f, 0.9375f })
      {
        CheckGradient(report, rig, setup, depth);
      }
    });
}
