// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 8: layers as close as float32 window depths can be are still in the right order.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include <cmath>

using namespace vtkOITTest;

namespace
{
/// Four layers from the depth on, the given number of steps apart, drawn in three orders.
void CheckSpacing(Report& report, Rig& rig, const Setup& setup, double depth, double step)
{
  const glm::vec4 colors[4] = { { 1.0f, 0.0f, 0.0f, 0.5f }, { 0.0f, 1.0f, 0.0f, 0.5f },
    { 0.0f, 0.0f, 1.0f, 0.5f }, { 1.0f, 1.0f, 0.0f, 0.5f } };
  std::vector<Layer> layers;
  for (int i = 0; i < 4; ++i)
  {
    layers.push_back({ static_cast<float>(depth + i * step), colors[i] });
  }
  const std::string what =
    "steps of 2^" + std::to_string(std::log2(step)) + " at " + std::to_string(depth);

  // The depths that the rasteriser makes are the ones that are meant.
  for (const Layer& layer : layers)
  {
    rig.RemoveProps();
    rig.AddQuad({ layer.Depth, { 1.0f, 1.0f, 1.0f, 1.0f } });
    rig.Render();
    report.Check(rig.GetDepth().At(0, 0).r == layer.Depth,
      what + ": window depth is " + std::to_string(rig.GetDepth().At(0, 0).r));
  }

  Random random(5);
  for (int order = 0; order < 3; ++order)
  {
    rig.RemoveProps();
    rig.AddStack(layers);
    report.Compare(what + ", order " + std::to_string(order), rig.Render(),
      Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
    random.Shuffle(layers);
  }
}
}

int TestDepthResolution(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 8, 6);
      report.SetStressTest(8);
      for (const int ulps : { 1, 2, 4, 8 })
      {
        CheckSpacing(report, rig, setup, 0.75, std::ldexp(ulps, -24));
        CheckSpacing(report, rig, setup, 0.9990234375, std::ldexp(ulps, -24));
        CheckSpacing(report, rig, setup, 0.25, std::ldexp(ulps, -25));
        CheckSpacing(report, rig, setup, 0.375, std::ldexp(ulps, -25));
        // Near the near plane the steps are those of the clip coordinate, 2^-24 at -1.
        CheckSpacing(report, rig, setup, 0.0009765625, std::ldexp(ulps, -25));
      }
    });
}
