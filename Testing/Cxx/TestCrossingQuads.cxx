// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 21: two quads that cross are in one order left of the crossing and in the other
// right of it, pixel by pixel.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 64;
constexpr int Height = 16;

/// The quads meet at the column position x = crossing, in pixels.
void CheckCrossing(Report& report, Rig& rig, const Setup& setup, double crossing)
{
  const glm::vec4 red(1.0f, 0.1f, 0.0f, 0.5f);
  const glm::vec4 green(0.0f, 1.0f, 0.3f, 0.5f);
  const double slope = 0.25 / Width;
  rig.RemoveProps();
  rig.AddRamp(0.5 - slope * crossing, 0.5 + slope * (Width - crossing), red);
  rig.AddRamp(0.5 + slope * crossing, 0.5 - slope * (Width - crossing), green);
  const std::vector<Layer> redFirst{ { 0.25f, red }, { 0.75f, green } };
  const std::vector<Layer> greenFirst{ { 0.75f, red }, { 0.25f, green } };
  const glm::dvec4 left = ReferenceCompositor::Composite(redFirst, rig.GetBackground());
  const glm::dvec4 right = ReferenceCompositor::Composite(greenFirst, rig.GetBackground());
  const glm::dvec4 merged =
    ReferenceCompositor::Composite({ { 0.5f, red }, { 0.5f, green } }, rig.GetBackground());
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(redFirst, rig.GetBackground(), setup.FragmentStorage);
  const Image image = rig.Render();
  report.Compare(
    "crossing at " + std::to_string(crossing), image,
    [&](int x, int y) -> glm::dvec4
    {
      if (x + 0.5 != crossing)
      {
        return x + 0.5 < crossing ? left : right;
      }
      // On the line rounding decides: one order, the other, or equal depths. Alpha is known.
      const glm::dvec4 pixel(image.At(x, y));
      glm::dvec4 nearest = merged;
      for (const glm::dvec4& candidate : { left, right })
      {
        nearest =
          glm::distance(pixel, candidate) < glm::distance(pixel, nearest) ? candidate : nearest;
      }
      return nearest;
    },
    bound);
}
}

int TestCrossingQuads(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(21);
      Rig rig(setup, Width, Height);
      CheckCrossing(report, rig, setup, 32.0); // between two columns
      CheckCrossing(report, rig, setup, 20.0);
      CheckCrossing(report, rig, setup, 40.5); // on the centres of a column
    });
}
