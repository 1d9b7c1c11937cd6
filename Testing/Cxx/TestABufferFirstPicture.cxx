// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// A picture may be the only one: it waits for no sorting network, and its geometry is drawn once. What
// draws in place of the networks makes the same bits.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/GLObjects.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include <array>

using namespace vtkOITTest;

namespace
{
enum class Kind
{
  Distinct,
  Coincident, // some have the depth of another one
  Opaque      // some end what is seen
};

std::vector<Layer> MakeLayers(int count, Kind kind)
{
  std::vector<Layer> layers = Random(10 + count).Layers(count);
  for (int i = 0; i < count; ++i)
  {
    layers[i].Color.a *= 0.3f;
    if (kind == Kind::Coincident && i % 5 == 4)
    {
      layers[i].Depth = layers[i - 3].Depth;
    }
    if (kind == Kind::Opaque && i % 7 == 3)
    {
      layers[i].Color.a = 1.0f;
    }
  }
  return layers;
}

/// What a new pass draws first, by networks or by what waits for them.
Image RenderFirst(
  const Setup& setup, const std::vector<Layer>& layers, double threshold, bool hasNetworks)
{
  Setup with = setup;
  with.HasNetworksAtOnce = hasNetworks;
  Rig rig(with, 8, 6);
  rig.Pass->SetTransmittanceThreshold(threshold);
  rig.AddStack(layers);
  return rig.Render();
}

void CheckBits(Report& report, const Setup& setup, int count, Kind kind)
{
  const std::vector<Layer> layers = MakeLayers(count, kind);
  const std::string what =
    std::to_string(count) + " layers of kind " + std::to_string(static_cast<int>(kind));
  // Only longer lists than the network for 32 may end at a threshold.
  for (const double threshold : { 0.0, 1.0 / 512.0 })
  {
    if (threshold > 0.0 && count <= 32)
    {
      continue;
    }
    const Image quick = RenderFirst(setup, layers, threshold, false);
    report.CompareBits(what + " without networks, threshold " + std::to_string(threshold), quick,
      RenderFirst(setup, layers, threshold, true));
    if (kind == Kind::Distinct && threshold == 0.0)
    {
      const glm::dvec4 background(0.2, 0.4, 0.6, 0.4);
      report.Compare(what + " without networks", quick,
        Everywhere(ReferenceCompositor::Composite(layers, background)),
        ReferenceCompositor::RoundingBound(layers, background, setup.FragmentStorage));
    }
  }
}

/// Programs that exist after the first frame of a new pass in a new window.
int CountPrograms(const Setup& setup, int count, bool hasNetworks, int frames, int side)
{
  Setup with = setup;
  with.HasNetworksAtOnce = hasNetworks;
  Rig rig(with, side, side);
  rig.AddStack(MakeLayers(count, Kind::Distinct));
  for (int i = 0; i < frames; ++i)
  {
    rig.Render();
  }
  return GLObjectCounts::OfCurrentContext().Programs;
}

/// One for the props, one for pixels, beside those that drawing nothing has.
void CheckPrograms(Report& report, const Setup& setup)
{
  const int nothing = CountPrograms(setup, 0, false, 1, 16);
  for (const int count : { 3, 20, 50 })
  {
    const int first = CountPrograms(setup, count, false, 1, 16) - nothing;
    report.Check(first == 2,
      std::to_string(count) + " layers: the first picture has " + std::to_string(first) +
        " programs, expected 2");
  }
  const int networks = CountPrograms(setup, 20, true, 1, 16) - nothing;
  report.Check(networks == 3,
    "20 layers with networks at once: " + std::to_string(networks) + " programs, expected 3");
  // 400 tiles a frame, whose lists are known from the first one: the network pays after ten more.
  const int before = CountPrograms(setup, 20, false, 11, 320) - nothing;
  const int after = CountPrograms(setup, 20, false, 12, 320) - nothing;
  const int check = setup.HasFetch ? 1 : 0; // that no region was exceeded, from the third frame on
  report.Check(before == 2 + check && after == 3 + check,
    "programs after 11 and 12 frames of 400 tiles: " + std::to_string(before) + " and " +
      std::to_string(after) + ", expected 2 and 3, and " + std::to_string(check));
}

/// More fragments than four a pixel.
void CheckPasses(Report& report, const Setup& setup)
{
  for (const int count : { 5, 20 })
  {
    Rig rig(setup, 64, 64);
    rig.AddStack(MakeLayers(count, Kind::Distinct));
    rig.Render();
    report.Check(rig.Pass->GetNumberOfGeometryPasses() == 1,
      std::to_string(count) + " layers in the first picture: geometry passes " +
        std::to_string(rig.Pass->GetNumberOfGeometryPasses()) + ", expected 1");
  }
}
}

int TestABufferFirstPicture(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig::KeepWindow(true);
      // One walk takes 8, each one before the last 7; walks end at 128, networks at 64.
      for (const int count : { 1, 7, 8, 9, 14, 15, 16, 22, 32, 33, 64, 65, 127, 128, 129, 150 })
      {
        CheckBits(report, setup, count, Kind::Distinct);
      }
      for (const int count : { 5, 8, 16, 40, 130 })
      {
        CheckBits(report, setup, count, Kind::Coincident);
        CheckBits(report, setup, count, Kind::Opaque);
      }
      Rig::KeepWindow(false);
      CheckPrograms(report, setup);
      CheckPasses(report, setup);
    });
}
