// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress tests 31, 32 and 33: what follows from the equation of blending, whatever the scene: a
// layer may be split, layers of the background's colour do not show, and the picture is linear in
// the colours.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/FragmentColor.h"
#include "Scenes/Random.h"

#include <algorithm>
#include <cmath>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 10;
constexpr int Height = 6;

Image RenderStack(Rig& rig, const std::vector<Layer>& layers)
{
  rig.RemoveProps();
  AddStackOfAnyColor(rig, layers);
  return rig.Render();
}

/// 31: two layers of opacity a' = 1 - sqrt(1 - a) one right behind the other, or coincident, are
/// one of opacity a.
void CheckSplitting(Report& report, Rig& rig, const Setup& setup)
{
  for (const int count : { 1, 4, 12 })
  {
    const std::vector<Layer> layers = Random(310 + count).Layers(count);
    const Image whole = RenderStack(rig, layers);
    for (const double distance : { 0.0, std::ldexp(1.0, -23) })
    {
      std::vector<Layer> split;
      for (Layer layer : layers)
      {
        layer.Color.a = static_cast<float>(1.0 - std::sqrt(1.0 - double(layer.Color.a)));
        split.push_back(layer);
        layer.Depth = static_cast<float>(layer.Depth + distance);
        split.push_back(layer);
      }
      const std::string what =
        std::to_string(count) + (distance > 0.0 ? " layers split" : " layers doubled");
      const Tolerance bound =
        ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage) +
        ReferenceCompositor::RoundingBound(split, rig.GetBackground(), setup.FragmentStorage);
      report.Compare(what, RenderStack(rig, split), whole, bound);
    }
  }
}

/// 32: any layers of the background's colour give the background's colour.
void CheckEqualColors(Report& report, Rig& rig, const Setup& setup)
{
  const glm::dvec4 background = rig.GetBackground();
  rig.SetBackground({ 0.25, 0.5, 0.75, 0.0 }); // halves, and sums of 8 bits, hold them
  std::vector<int> counts{ 1, 3, 16, 40, 250 };
  for (const int count : counts)
  {
    if (count > setup.LargestStack)
    {
      continue;
    }
    std::vector<Layer> layers = Random(320 + count).Layers(count);
    for (Layer& layer : layers)
    {
      layer.Color = { 0.25f, 0.5f, 0.75f, layer.Color.a };
    }
    for (int i = 0; i + 1 < count; i += 5) // coincident ones too
    {
      layers[i].Depth = layers[i + 1].Depth;
    }
    const glm::dvec4 expected(
      0.25, 0.5, 0.75, ReferenceCompositor::Composite(layers, rig.GetBackground()).a);
    const Tolerance bound =
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage);
    // Rounded opacities do not matter; what matters is that the weights sum up to 1 - T.
    const double sums = 2e-6 * (1.0 + count / 1000.0);
    report.Compare(std::to_string(count) + " layers of the background's colour",
      RenderStack(rig, layers), Everywhere(expected), { sums, bound.Alpha });
  }
  rig.SetBackground(background);
}

/// 33: with the colours of two scenes added, layer by layer, the pictures add up.
void CheckLinearity(Report& report, Rig& rig, const Setup& setup)
{
  const glm::dvec4 background = rig.GetBackground();
  Random random(33);
  std::vector<Layer> first = random.Layers(14);
  first[3].Depth = first[4].Depth; // coincident
  std::vector<Layer> second = first;
  std::vector<Layer> sum = first;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    const glm::dvec3 color(random.Uniform(), random.Uniform(), random.Uniform());
    second[i].Color = glm::vec4(glm::vec3(color), first[i].Color.a);
    sum[i].Color =
      glm::vec4(glm::vec3(first[i].Color) + glm::vec3(second[i].Color), first[i].Color.a);
  }
  const glm::dvec3 backgrounds[2] = { glm::dvec3(background), { 0.5, 0.125, 0.0 } };
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(sum, glm::dvec4(2.0), setup.FragmentStorage);
  rig.SetBackground({ backgrounds[0], background.a });
  Image expected = RenderStack(rig, first);
  rig.SetBackground({ backgrounds[1], background.a });
  const Image other = RenderStack(rig, second);
  for (std::size_t i = 0; i < expected.Pixels.size(); ++i)
  {
    expected.Pixels[i] += glm::vec4(glm::vec3(other.Pixels[i]), 0.0f);
  }
  rig.SetBackground({ backgrounds[0] + backgrounds[1], background.a });
  const Image image = RenderStack(rig, sum);
  report.Compare("sum of two scenes", image, expected, bound + bound);
  report.Check(image.At(0, 0).r > 1.0f || image.At(0, 0).g > 1.0f || image.At(0, 0).b > 1.0f,
    "sum of two scenes: no colour above 1, this tests little");
  rig.SetBackground(background);
}
}

int TestBlendingLaws(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, Width, Height);
      report.SetStressTest(31);
      CheckSplitting(report, rig, setup);
      report.SetStressTest(32);
      CheckEqualColors(report, rig, setup);
      if (!setup.IsContender) // an 8-bit window has no colours above 1
      {
        report.SetStressTest(33);
        CheckLinearity(report, rig, setup);
      }
    });
}
