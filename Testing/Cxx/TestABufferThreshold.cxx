// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// A TransmittanceThreshold of the A-buffer: long lists are composited up to the first fragment
// behind which the transmittance is at most that, whatever the order of drawing and whether all of
// the list was sorted for it or only its nearest fragments. What is skipped is reported.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkOITABufferPass.h"

#include <algorithm>

using namespace vtkOITTest;

namespace
{
/// From near to far, of about this opacity; groups of `together` coincide.
std::vector<Layer> MakeLayers(int count, float opacity, int together)
{
  std::vector<Layer> layers = Random(count).Layers(count);
  std::sort(
    layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.Depth < b.Depth; });
  for (int i = 0; i < count; ++i)
  {
    layers[i].Color.a = opacity * (0.9f + 0.2f * layers[i].Color.a);
    layers[i].Depth = layers[i / together * together].Depth;
  }
  return layers;
}

/// The layers up to the first group behind which the transmittance is at most the threshold, and
/// the transmittance behind it.
std::vector<Layer> CutOff(const std::vector<Layer>& layers, double threshold, double& transmittance)
{
  transmittance = 1.0;
  std::vector<Layer> seen;
  for (const Layer& layer : layers)
  {
    if (transmittance <= threshold && layer.Depth != seen.back().Depth)
    {
      break;
    }
    seen.push_back(layer);
    transmittance *= 1.0 - layer.Color.a;
  }
  return seen;
}

/// As often as `frames`. With `hasTieBehind` the two farthest layers coincide.
void CheckThreshold(Report& report, Rig& rig, const Setup& setup, int count, float opacity,
  int together, int frames, bool hasTieBehind = false)
{
  auto* pass = vtkOITABufferPass::SafeDownCast(rig.Pass);
  std::vector<Layer> layers = MakeLayers(count, opacity, together);
  if (hasTieBehind)
  {
    layers[count - 2].Depth = layers[count - 1].Depth;
  }
  for (const double threshold : { 0.0, 1.0 / 512 })
  {
    double skipped = 0.0;
    const std::vector<Layer> seen = CutOff(layers, threshold, skipped);
    const bool isWhole = seen.size() == layers.size();
    const std::string what = std::to_string(count) + " layers, opacity " + std::to_string(opacity) +
      ", groups of " + std::to_string(together) + ", threshold " + std::to_string(threshold);
    pass->SetTransmittanceThreshold(threshold);
    Image first;
    rig.RemoveProps();
    rig.AddStack(layers);
    auto drawn = rig.GetActors();
    for (int order = 0; order < frames; ++order)
    {
      rig.SetDrawOrder(drawn);
      const Image image = rig.Render();
      first = order == 0 ? image : first;
      report.CompareBits(what + ", order " + std::to_string(order), image, first);
      const double bound = pass->GetErrorBound();
      report.Check(std::abs(bound - (isWhole ? 0.0 : skipped)) < 1e-3 * threshold + 1e-9 &&
          pass->GetExact() == (bound == 0.0),
        what + ": the bound is " + std::to_string(bound));
      report.Check(pass->GetNumberOfFragments() == count * rig.GetWidth() * rig.GetHeight() &&
          pass->GetMaximumDepthComplexity() == count,
        what + ": fragments " + std::to_string(pass->GetNumberOfFragments()));
      if (order == 1)
      {
        std::reverse(drawn.begin(), drawn.end());
      }
      else
      {
        Random(order).Shuffle(drawn);
      }
    }
    report.Compare(what, first,
      Everywhere(ReferenceCompositor::Composite(seen, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(seen, rig.GetBackground(), setup.FragmentStorage));
  }
}
}

int TestABufferThreshold(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 8, 6);
      // The nearest 23 are enough, all are, all are not.
      for (const float opacity : { 0.4f, 0.2f, 0.05f })
      {
        CheckThreshold(report, rig, setup, 90, opacity, 1, 3);
      }
      CheckThreshold(report, rig, setup, 90, 0.3f, 2, 3);
      // From the ninth frame on with lists of 33 to 64 fragments they are sorted in registers.
      CheckThreshold(report, rig, setup, 64, 0.2f, 1, 10);
      CheckThreshold(report, rig, setup, 33, 0.2f, 2, 3);
      CheckThreshold(report, rig, setup, 60, 0.4f, 1, 12, true);
    });
}
