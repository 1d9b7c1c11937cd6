// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress tests 12, 13 and 14: layers of opacity 0, of opacity 1, and thousands of faint layers.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include <cmath>

using namespace vtkOITTest;

namespace
{
/// Layers of opacity 0 in front, behind, between and everywhere change nothing.
void CheckInvisibleLayers(Report& report, Rig& rig)
{
  const std::vector<Layer> visible{ { 0.3f, { 0.9f, 0.1f, 0.1f, 0.5f } },
    { 0.5f, { 0.1f, 0.9f, 0.1f, 0.25f } }, { 0.7f, { 0.1f, 0.1f, 0.9f, 0.75f } } };
  rig.RemoveProps();
  rig.AddStack(visible);
  const Image expected = rig.Render();
  report.Compare("without invisible layers", expected,
    Everywhere(ReferenceCompositor::Composite(visible, rig.GetBackground())),
    ReferenceCompositor::RoundingBoundOfAnyStack(3, Storage::Half));
  const std::vector<std::pair<std::string, std::vector<float>>> places{ { "in front", { 0.1f } },
    { "behind", { 0.9f } }, { "between", { 0.4f, 0.6f } }, { "coincident", { 0.3f, 0.5f } },
    { "everywhere", { 0.1f, 0.2f, 0.4f, 0.5f, 0.6f, 0.8f, 0.9f } } };
  for (const auto& place : places)
  {
    std::vector<Layer> layers = EqualLayers(place.second, { 1.0f, 1.0f, 1.0f, 0.0f });
    layers.insert(layers.end(), visible.begin(), visible.end());
    rig.RemoveProps();
    rig.AddStack(layers);
    report.CompareBits("invisible layers " + place.first, rig.Render(), expected);
  }
}

/// Nothing behind a layer of opacity 1 contributes anything, and alpha is exactly 1.
void CheckOpaqueLayer(Report& report, Rig& rig, const Setup& setup)
{
  rig.SetBackground(glm::dvec4(0.2, 0.4, 0.6, 0.0));
  for (int position = 0; position < 6; ++position)
  {
    std::vector<Layer> layers;
    for (int i = 0; i < 6; ++i)
    {
      layers.push_back({ 0.1f + 0.125f * i, { 0.5f + 0.05f * i, 0.3f, 0.9f - 0.1f * i, 0.25f } });
    }
    layers[position].Color.a = 1.0f;
    const std::string what = "opacity 1 at " + std::to_string(position);
    rig.RemoveProps();
    rig.AddStack(layers);
    const Image image = rig.Render();
    report.Compare(what, image,
      Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
    report.Check(image.At(0, 0).a == 1.0f, what + ": alpha is " + std::to_string(image.At(0, 0).a));
    for (int i = position + 1; i < 6; ++i)
    {
      layers[i].Color = { 1.0f, 1.0f, 0.0f, 0.9f };
    }
    rig.RemoveProps();
    rig.AddStack(layers);
    report.CompareBits(what + ", other layers behind it", rig.Render(), image);
  }
  rig.SetBackground(glm::dvec4(0.2, 0.4, 0.6, 0.4));
}

/// Colours between two halves go to the nearer one: cutting bits off would be twice as wrong.
void CheckRounding(Report& report, Rig& rig, const Setup& setup)
{
  const float step = 1.0f / 2048; // of a half in [0.5, 1)
  const std::vector<Layer> layers{ { 0.5f,
    { 0.5f + 0.9f * step, 0.5f + 0.6f * step, 0.5f + 0.4f * step, 1.0f } } };
  rig.RemoveProps();
  rig.AddStack(layers);
  report.Compare("colours between two halves", rig.Render(),
    Everywhere(glm::dvec4(layers[0].Color)),
    ReferenceCompositor::RoundingBound(layers, glm::dvec4(0.5), setup.FragmentStorage));
}

/// Opacities that 8 bits cannot hold add up.
void CheckFaintLayers(Report& report, Rig& rig, const Setup& setup)
{
  for (const float opacity : { 1.0f / 255, 1.0f / 510, 1.0f / 1024, 1e-6f })
  {
    for (const int count : { 1, 60, 1000, 4096 })
    {
      if (count > setup.LargestStack)
      {
        continue;
      }
      const glm::vec4 color(0.9f, 0.6f, 0.05f, opacity);
      const std::vector<float> depths = Random(count).Depths(count);
      rig.RemoveProps();
      rig.AddEqualLayers(depths, color);
      const double transmittance = std::pow(1.0 - double(opacity), count);
      const glm::dvec4 expected =
        glm::dvec4(color.r, color.g, color.b, 1.0) * (1.0 - transmittance) +
        transmittance * rig.GetBackground();
      report.Compare(std::to_string(count) + " layers of opacity 1/" +
          std::to_string(std::lround(1.0 / opacity)),
        rig.Render(), Everywhere(expected),
        ReferenceCompositor::RoundingBound(
          EqualLayers(depths, color), rig.GetBackground(), setup.FragmentStorage));
    }
  }
}
}

int TestOpacityExtremes(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 8, 6);
      report.SetStressTest(12);
      CheckInvisibleLayers(report, rig);
      report.SetStressTest(13);
      CheckOpaqueLayer(report, rig, setup);
      report.SetStressTest(0);
      CheckRounding(report, rig, setup);
      report.SetStressTest(14);
      CheckFaintLayers(report, rig, setup);
    });
}
