// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress tests 29, 30 and 34 for methods that peel: what a limit cuts off is within the bound that
// the pass states, with alpha exact and with the layers in front of it; the threshold skips no more
// than it says; what only saves time changes no bit.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkOITBucketPeelingPass.h"
#include "vtkOITMultiLayerPeelingPass.h"
#include "vtkOITPeelingPass.h"

#include <algorithm>
#include <cmath>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 24;
constexpr int Height = 16;

/// Many layers of distinct depths, from near to far.
std::vector<Layer> MakeLayers(unsigned int seed, int count, float opacity)
{
  std::vector<Layer> layers = Random(seed).Layers(count);
  for (Layer& layer : layers)
  {
    layer.Color.a = opacity;
  }
  std::sort(
    layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.Depth < b.Depth; });
  return layers;
}

/// An opaque quad in the middle, over half of the viewport, and the layers in random order.
void AddScene(Rig& rig, std::vector<Layer> layers)
{
  rig.RemoveProps();
  rig.AddQuad({ 0.55f, { 0.1f, 0.3f, 0.9f, 1.0f } }, { 0.0, 0.0, Width / 2.0, double(Height) });
  Random(1).Shuffle(layers);
  rig.AddStack(layers);
}

Report::Expected Reference(const Rig& rig, const std::vector<Layer>& layers)
{
  std::vector<Layer> visible;
  std::copy_if(layers.begin(), layers.end(), std::back_inserter(visible),
    [](const Layer& layer) { return layer.Depth <= 0.55f; });
  const glm::dvec4 left =
    ReferenceCompositor::Composite(visible, glm::dvec4(0.1f, 0.3f, 0.9f, 1.0f));
  const glm::dvec4 right = ReferenceCompositor::Composite(layers, rig.GetBackground());
  return [=](int x, int) { return x < Width / 2 ? left : right; };
}

/// 29: few peels. Alpha is exact: what is cut off counts as one group. With all but the outermost
/// layers of one colour the colour is exact too, so those in front are peeled rightly.
void CheckLimitedPeels(Report& report, Rig& rig, const Setup& setup)
{
  auto* pass = vtkOITPeelingPass::SafeDownCast(rig.Pass);
  // Dual: from each side, at least 1 a peel, and 3 with half floats where it keeps layers.
  const bool keepsThree =
    setup.Method == "dual" && setup.HasFetch && setup.FragmentStorage == Storage::Half;
  const int outer = keepsThree ? 6 : 2;
  for (const int peels : { 2, 4 })
  {
    pass->SetMaximumNumberOfPeels(peels);
    const std::vector<Layer> layers = MakeLayers(29, 40, 0.05f);
    std::vector<Layer> alike = layers;
    const int last = setup.Method == "dual" ? 40 - outer : 40;
    for (int i = outer; i < last; ++i)
    {
      alike[i].Color = { 0.9f, 0.6f, 0.1f, 0.05f };
    }
    // On the left the opaque quad hides the farthest ones; there only alpha is compared for dual.
    const std::string what = std::to_string(peels) + " peels";
    AddScene(rig, layers);
    const Image image = rig.Render();
    const Tolerance bound =
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage);
    report.Check(!pass->GetExact() && pass->GetErrorBound() > 0.0 && pass->GetErrorBound() <= 1.0,
      what + ": the error bound is " + std::to_string(pass->GetErrorBound()));
    report.Compare(
      what, image, Reference(rig, layers), bound + Tolerance{ pass->GetErrorBound(), 0.0 });

    AddScene(rig, alike);
    const Image front = rig.Render();
    const Report::Expected expected = Reference(rig, alike);
    report.Compare(
      what + ", those that are left of one colour", front,
      [&](int x, int y)
      {
        const bool isCut = setup.Method == "dual" && x < Width / 2;
        return isCut ? glm::dvec4(front.At(x, y)) : expected(x, y);
      },
      bound);
    // Nothing behind the layers in front of the cut changes more than their transmittance.
    report.Check(pass->GetErrorBound() <= std::pow(0.95, outer) + 1e-6,
      what + ": the bound " + std::to_string(pass->GetErrorBound()) + " ignores the front layers");
  }
  pass->SetMaximumNumberOfPeels(0);
}

/// 30: black layers until T is at most the threshold, then white ones, which are skipped, or some
/// of them peeled along with the black ones. The error is what was skipped, never more than the
/// threshold.
void CheckThreshold(Report& report, Rig& rig, const Setup& setup)
{
  auto* pass = vtkOITPeelingPass::SafeDownCast(rig.Pass);
  for (const double threshold : { 0.0, 1.0 / 512, 1.0 / 64, 0.1 })
  {
    const std::string what = "threshold " + std::to_string(threshold);
    const int black = threshold > 0.0 ? int(std::ceil(std::log(threshold) / std::log(0.75))) : 20;
    std::vector<Layer> layers = MakeLayers(30, 60, 0.25f);
    for (int i = 0; i < 60; ++i)
    {
      layers[i].Color = glm::vec4(glm::vec3(i < black ? 0.0f : 1.0f), 0.25f);
    }
    pass->SetTransmittanceThreshold(threshold);
    std::vector<float> depths;
    for (const Layer& layer : layers)
    {
      depths.push_back(layer.Depth);
    }
    rig.RemoveProps();
    rig.AddEqualLayers({ depths.begin() + black, depths.end() }, layers.back().Color);
    rig.AddEqualLayers({ depths.begin(), depths.begin() + black }, layers.front().Color);
    const Image image = rig.Render();
    const double bound = pass->GetErrorBound();
    report.Check(bound <= threshold + 1e-6 && pass->GetExact() == (bound == 0.0) &&
        (bound > 0.0) == (threshold > 0.0),
      what + ": the bound is " + std::to_string(bound));
    const glm::dvec4 expected = ReferenceCompositor::Composite(layers, rig.GetBackground());
    report.Compare(what, image, Everywhere(expected),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage) +
        Tolerance{ bound, bound });
    // White is missing, the background of 0.2 shows instead; the last layer may count as skipped in
    // the bound. From both sides some in the middle are left out, and white ones are left behind them.
    const double missing = expected.r - image.At(0, 0).r;
    const bool hasBack = setup.Method == "dual" || setup.Method.rfind("bucket", 0) == 0;
    report.Check(threshold == 0.0 || hasBack || (missing > 0.55 * bound),
      what + ": skipping changes " + std::to_string(missing) + ", the bound is " +
        std::to_string(bound));
  }
  pass->SetTransmittanceThreshold(0.0);
}

/// 34: the same bits with and without occlusion queries, in bands, and in the next frames, which
/// skip what the last frame did not need; within rounding with other properties of a method.
void CheckSameResult(Report& report, Rig& rig, const Setup& setup)
{
  auto* pass = vtkOITPeelingPass::SafeDownCast(rig.Pass);
  const std::vector<Layer> layers = MakeLayers(34, 20, 0.3f);
  AddScene(rig, layers);
  const Image image = rig.Render();
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage);
  report.Compare("20 layers", image, Reference(rig, layers), bound);
  report.CompareBits("the next frame", rig.Render(), image);

  pass->SetUseOcclusionQuery(false);
  pass->SetMaximumNumberOfPeels(setup.Method == "peel" || setup.Method == "deferred" ? 22 : 12);
  report.CompareBits("without occlusion queries", rig.Render(), image);
  pass->SetUseOcclusionQuery(true);
  pass->SetMaximumNumberOfPeels(0);
  pass->SetMaximumBufferSize(1 << 20);
  report.CompareBits("in 1 MiB", rig.Render(), image);
  pass->SetMaximumBufferSize(0);

  if (auto* bucket = vtkOITBucketPeelingPass::SafeDownCast(pass))
  {
    bucket->SetDepthRange(vtkOITBucketPeelingPass::EXACT);
    report.Compare("exact depth ranges", rig.Render(), image, { 1e-6, 1e-6 });
    bucket->SetDepthRange(vtkOITBucketPeelingPass::BOUNDS);
  }
  if (auto* multiLayer = vtkOITMultiLayerPeelingPass::SafeDownCast(pass))
  {
    multiLayer->SetNumberOfLayersPerPass(4);
    report.Compare("4 layers a pass", rig.Render(), image, { 1e-6, 1e-6 });
    multiLayer->SetNumberOfLayersPerPass(8);
  }
  report.CompareBits("as before", rig.Render(), image);
}
}

int TestSkipping(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, Width, Height);
      report.SetStressTest(29);
      CheckLimitedPeels(report, rig, setup);
      report.SetStressTest(30);
      CheckThreshold(report, rig, setup);
      report.SetStressTest(34);
      CheckSameResult(report, rig, setup);
    });
}
