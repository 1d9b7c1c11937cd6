// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress tests 1 and 2: N equal layers have a closed formula, random layers the recurrence.
// In a float32 framebuffer, in the 8-bit window, and on a transparent background.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include <cmath>

using namespace vtkOITTest;

namespace
{
/// c (1 - (1-a)^N) + b (1-a)^N, alpha alike; the half and the float32 opacity differ, so the
/// tolerance is the one of the reference.
void CheckEqualLayers(Report& report, Rig& rig, const Setup& setup, int count, float a)
{
  const glm::vec4 color(0.8f, 0.1f, 0.3f, a);
  const std::vector<float> depths = Random(count).Depths(count);
  rig.RemoveProps();
  rig.AddEqualLayers(depths, color);
  const double transmittance = std::pow(1.0 - double(a), count);
  const glm::dvec4 expected =
    glm::dvec4(glm::dvec4(color).r, color.g, color.b, 1.0) * (1.0 - transmittance) +
    transmittance * rig.GetBackground();
  report.Compare(std::to_string(count) + " layers of " + std::to_string(a), rig.Render(),
    Everywhere(expected),
    ReferenceCompositor::RoundingBound(
      EqualLayers(depths, color), rig.GetBackground(), setup.FragmentStorage));
}

void CheckRandomLayers(Report& report, Rig& rig, const Setup& setup, int count)
{
  const std::vector<Layer> layers = Random(100 + count).Layers(count);
  rig.RemoveProps();
  rig.AddStack(layers);
  const std::string what = std::to_string(count) + " random layers";
  for (const glm::dvec4& background :
    { glm::dvec4(0.2, 0.4, 0.6, 1.0), glm::dvec4(0.0), glm::dvec4(0.2, 0.4, 0.6, 0.4) })
  {
    rig.SetBackground(background);
    const glm::dvec4 expected = ReferenceCompositor::Composite(layers, background);
    const Tolerance bound =
      ReferenceCompositor::RoundingBound(layers, background, setup.FragmentStorage);
    const std::string over = what + " over alpha " + std::to_string(background.a);
    report.Compare(over, rig.Render(), Everywhere(expected), bound);
    report.Compare(over + " in the window", rig.RenderWindow(), Everywhere(expected),
      bound + Rig::WindowTolerance());
  }
  rig.SetBackground(glm::dvec4(0.2, 0.4, 0.6, 0.4));
}
}

int TestLayerStacks(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 8, 6);
      std::vector<int> counts{ 1, 2, 3, 8, 17, 64, 1000 };
      if (setup.UseMode == Use::Installed)
      {
        counts = { 1, 2, 3, 7, 8, 9, 15, 16, 17, 31, 32, 33, 63, 64, 65, 127, 255, 256, 257, 1000,
          4096 };
      }
      report.SetStressTest(1);
      for (const int count : counts)
      {
        if (count > setup.LargestStack)
        {
          continue;
        }
        std::vector<float> opacities{ 1.0f / count };
        if (setup.IsLong || setup.IsContender || setup.UseMode == Use::Installed)
        {
          opacities = { 0.5f, 0.1f, 1.0f / count };
        }
        for (const float opacity : opacities)
        {
          CheckEqualLayers(report, rig, setup, count, opacity);
        }
      }
      report.SetStressTest(2);
      for (const int count : { 2, 5, 16, 40 })
      {
        CheckRandomLayers(report, rig, setup, count);
      }
    });
}
