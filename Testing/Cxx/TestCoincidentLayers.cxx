// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress tests 5, 6, 7 and 9: fragments of equal depth each count once, by the symmetric rule of
// ReferenceCompositor.h, whatever the draw order.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace vtkOITTest;

namespace
{
/// The symmetric rule. A contender may also draw coincident layers in any order: the answer that is
/// nearest to the pixel.
glm::dvec4 FindAnswer(
  const Rig& rig, const Setup& setup, const std::vector<Layer>& layers, const glm::vec4& pixel)
{
  glm::dvec4 answer = ReferenceCompositor::Composite(layers, rig.GetBackground());
  if (!setup.IsContender || layers.size() > 5)
  {
    return answer;
  }
  std::vector<int> order(layers.size());
  std::iota(order.begin(), order.end(), 0);
  do
  {
    std::vector<Layer> ordered = layers;
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      ordered[i].Depth += 1e-5f * order[i];
    }
    const glm::dvec4 candidate = ReferenceCompositor::Composite(ordered, rig.GetBackground());
    if (glm::distance(candidate, glm::dvec4(pixel)) < glm::distance(answer, glm::dvec4(pixel)))
    {
      answer = candidate;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return answer;
}

void CheckStack(Report& report, Rig& rig, const Setup& setup, const std::string& what,
  const std::vector<Layer>& layers)
{
  rig.RemoveProps();
  rig.AddStack(layers);
  const Image image = rig.Render();
  report.Compare(what, image, Everywhere(FindAnswer(rig, setup, layers, image.At(0, 0))),
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
}

/// k coincident faces of one colour: c (1-(1-a)^k) + b (1-a)^k, from one mesh and from k actors.
void CheckEqualColors(Report& report, Rig& rig, const Setup& setup)
{
  const glm::vec4 color(0.9f, 0.5f, 0.1f, 0.5f);
  for (const int count : { 2, 3, 4, 5, 6, 7, 8, 9, 17, 33 })
  {
    const std::vector<float> depths(count, 0.625f);
    const std::vector<Layer> layers = EqualLayers(depths, color);
    const double transmittance = std::pow(0.5, count);
    const glm::dvec4 expected = glm::dvec4(color.r, color.g, color.b, 1.0) * (1.0 - transmittance) +
      transmittance * rig.GetBackground();
    rig.RemoveProps();
    rig.AddEqualLayers(depths, color);
    report.Compare(std::to_string(count) + " coincident faces of a mesh", rig.Render(),
      Everywhere(expected),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
    CheckStack(report, rig, setup, std::to_string(count) + " coincident actors", layers);
  }
}

/// Different colours, between a layer in front and one behind, in every draw order.
void CheckDifferentColors(Report& report, Rig& rig, const Setup& setup)
{
  std::vector<Layer> layers{ { 0.25f, { 0.2f, 0.9f, 0.1f, 0.3f } },
    { 0.5f, { 1.0f, 0.0f, 0.0f, 0.5f } }, { 0.5f, { 0.0f, 1.0f, 0.0f, 0.25f } },
    { 0.5f, { 0.0f, 0.0f, 1.0f, 0.75f } }, { 0.75f, { 0.9f, 0.9f, 0.1f, 0.6f } } };
  const std::vector<int> identity{ 0, 1, 2, 3, 4 };
  std::vector<int> order = identity;
  int number = 0;
  do
  {
    std::vector<Layer> drawn;
    for (const int index : order)
    {
      drawn.push_back(layers[index]);
    }
    // All 6 orders of the coincident three; the outer two stay first and last or swap.
    if ((order[0] == 0 && order[4] == 4) || (order[0] == 4 && order[4] == 0))
    {
      CheckStack(report, rig, setup, "draw order " + std::to_string(number++), drawn);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  report.Check(number == 12, "expected 12 draw orders, had " + std::to_string(number));
}

/// A mesh drawn twice is the mesh with each opacity a replaced by 1 - (1-a)^2.
void CheckDuplicateMesh(Report& report, Rig& rig, const Setup& setup)
{
  std::vector<Layer> layers = Random(3).Layers(6);
  std::vector<Layer> merged = layers;
  for (Layer& layer : merged)
  {
    layer.Color.a = 1.0f - (1.0f - layer.Color.a) * (1.0f - layer.Color.a);
  }
  std::vector<Layer> twice = layers;
  twice.insert(twice.end(), layers.begin(), layers.end());
  rig.RemoveProps();
  rig.AddStack(twice);
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(twice, rig.GetBackground(), setup.FragmentStorage);
  report.Compare("stack drawn twice", rig.Render(),
    Everywhere(ReferenceCompositor::Composite(merged, rig.GetBackground())), bound);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.7);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  sphere->Update();
  const glm::vec4 color(0.9f, 0.3f, 0.1f, 0.4f);
  rig.RemoveProps();
  rig.AddPolyData(sphere->GetOutput(), color);
  rig.AddPolyData(sphere->GetOutput(), color);
  const Image drawnTwice = rig.Render();
  rig.RemoveProps();
  rig.AddPolyData(sphere->GetOutput(), { color.r, color.g, color.b, 1.0f - 0.6f * 0.6f });
  report.Compare("sphere drawn twice", drawnTwice, rig.Render(), bound + bound);
}

/// Layers whose eye depths differ, but not their float32 window depths.
void CheckEqualWindowDepths(Report& report, Rig& rig, const Setup& setup)
{
  // Window depths have steps of 2^-24 here; a quarter of that survives in the float32 position.
  const double near = 0.625;
  const double far = 0.625 + std::ldexp(1.0, -26);
  const glm::vec4 red(1.0f, 0.0f, 0.0f, 0.5f);
  const glm::vec4 green(0.0f, 1.0f, 0.0f, 0.25f);
  Image depths[2];
  for (int i = 0; i < 2; ++i)
  {
    rig.RemoveProps();
    vtkActor* actor = rig.AddQuad({ 0.625f, { 1.0f, 1.0f, 1.0f, 1.0f } });
    actor->SetPosition(0.0, 0.0, DepthToZ(i == 0 ? near : far) - DepthToZ(0.625));
    rig.Render();
    depths[i] = rig.GetDepth();
  }
  report.CompareBits("the two window depths", depths[1], depths[0]);

  for (int order = 0; order < 2; ++order)
  {
    rig.RemoveProps();
    for (int i = 0; i < 2; ++i)
    {
      const bool isNear = i == order;
      vtkActor* actor = rig.AddQuad({ 0.625f, isNear ? red : green });
      actor->SetPosition(0.0, 0.0, DepthToZ(isNear ? near : far) - DepthToZ(0.625));
    }
    const std::vector<Layer> layers{ { 0.625f, red }, { 0.625f, green } };
    const Image image = rig.Render();
    report.Compare("equal window depths, order " + std::to_string(order), image,
      Everywhere(FindAnswer(rig, setup, layers, image.At(0, 0))),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
  }
}
}

int TestCoincidentLayers(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 20, 16);
      report.SetStressTest(5);
      CheckEqualColors(report, rig, setup);
      report.SetStressTest(6);
      CheckDifferentColors(report, rig, setup);
      report.SetStressTest(7);
      CheckDuplicateMesh(report, rig, setup);
      report.SetStressTest(9);
      CheckEqualWindowDepths(report, rig, setup);
    });
}
