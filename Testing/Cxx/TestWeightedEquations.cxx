// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// The previews give exactly what their equations say, and say that they are not exact.

#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include <cmath>

using namespace vtkOITTest;

namespace
{
/// Bavoil and Myers 2008, Weighted average and Weighted sum. For weighted blended the layers have
/// one colour, so that the weights cancel: the transmittance is the product.
glm::dvec4 Evaluate(
  const std::string& method, const std::vector<Layer>& layers, const glm::dvec4& background)
{
  glm::dvec3 colors(0.0);
  double opacities = 0.0;
  double product = 1.0;
  for (const Layer& layer : layers)
  {
    const glm::dvec4 c(layer.Color);
    colors += c.a * glm::dvec3(c);
    opacities += c.a;
    product *= 1.0 - c.a;
  }
  if (method == "weighted-sum")
  {
    return glm::dvec4(colors, opacities) + (1.0 - opacities) * background;
  }
  const double n = static_cast<double>(layers.size());
  const double transmittance =
    method == "weighted-average" ? std::pow(1.0 - opacities / n, n) : product;
  return glm::dvec4(colors / opacities * (1.0 - transmittance), 1.0 - transmittance) +
    transmittance * background;
}
}

int TestWeightedEquations(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 12, 8);
      for (const int count : { 1, 2, 3, 8, 40 })
      {
        std::vector<Layer> layers = Random(count).Layers(count);
        if (setup.Method == "weighted-blended")
        {
          for (Layer& layer : layers)
          {
            layer.Color = { 0.9f, 0.3f, 0.1f, layer.Color.a };
          }
        }
        rig.RemoveProps();
        rig.AddStack(layers);
        const std::string what = std::to_string(count) + " layers";
        const double sum = setup.Method == "weighted-sum" ? count : 1.0;
        report.Compare(what, rig.Render(),
          Everywhere(Evaluate(setup.Method, layers, rig.GetBackground())),
          { 3e-6 * sum, 3e-6 * sum });
        report.Check(rig.Pass->GetExact() == (count == 1), what + ": GetExact()");
        report.Check(rig.Pass->GetErrorBound() == (count == 1 ? 0.0 : 1.0), what + ": bound");
        report.Check(rig.Pass->GetNumberOfGeometryPasses() == 1, what + ": geometry passes");
        report.Check(rig.Pass->GetMaximumDepthComplexity() == count, what + ": complexity");
      }
    });
}
