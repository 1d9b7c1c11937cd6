// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 26: sheets cut by the near and the far plane keep every fragment inside, and layers
// at the window depths 0 and 1 exactly are not lost.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include <algorithm>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 64;
constexpr int Height = 12;

/// A sheet that leaves the view at the middle, in front of or behind a constant layer.
void CheckClippedSheet(Report& report, Rig& rig, const Setup& setup, double left, double right)
{
  const Layer middle{ 0.5f, { 0.1f, 0.9f, 0.2f, 0.5f } };
  const glm::vec4 color(0.9f, 0.2f, 0.1f, 0.375f);
  rig.RemoveProps();
  rig.AddRamp(left, right, color);
  rig.AddQuad(middle);
  const bool inFront = std::max(left, right) < 0.5;
  const std::vector<Layer> both{ { inFront ? 0.25f : 0.75f, color }, middle };
  const glm::dvec4 one = ReferenceCompositor::Composite({ middle }, rig.GetBackground());
  const glm::dvec4 two = ReferenceCompositor::Composite(both, rig.GetBackground());
  report.Compare(
    "sheet from depth " + std::to_string(left) + " to " + std::to_string(right), rig.Render(),
    [&](int x, int)
    {
      const double depth = left + (right - left) * (x + 0.5) / Width;
      return depth >= 0.0 && depth <= 1.0 ? two : one;
    },
    ReferenceCompositor::RoundingBound(both, rig.GetBackground(), setup.FragmentStorage));
}

/// Constant layers on the planes themselves: the clip volume and the depth test include both.
void CheckLimits(Report& report, Rig& rig, const Setup& setup)
{
  const std::vector<Layer> layers{ { 0.0f, { 0.9f, 0.1f, 0.1f, 0.5f } },
    { 0.5f, { 0.1f, 0.9f, 0.1f, 0.25f } }, { 1.0f, { 0.1f, 0.1f, 0.9f, 0.75f } } };
  for (const std::vector<Layer>& stack : { std::vector<Layer>{ layers[0] }, { layers[2] },
         { layers[0], layers[1] }, { layers[2], layers[1] }, { layers[2], layers[0], layers[1] } })
  {
    rig.RemoveProps();
    rig.AddStack(stack);
    report.Compare(
      std::to_string(stack.size()) + " layers with depth " + std::to_string(stack[0].Depth),
      rig.Render(), Everywhere(ReferenceCompositor::Composite(stack, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(stack, rig.GetBackground(), setup.FragmentStorage));
  }
}
}

int TestDepthLimits(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(26);
      Rig rig(setup, Width, Height);
      CheckClippedSheet(report, rig, setup, -0.25, 0.25);
      CheckClippedSheet(report, rig, setup, 0.25, -0.25);
      CheckClippedSheet(report, rig, setup, 0.75, 1.25);
      CheckClippedSheet(report, rig, setup, 1.25, 0.75);
      CheckLimits(report, rig, setup);
    });
}
