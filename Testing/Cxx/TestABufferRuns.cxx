// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Lists that are longer than the sorting networks are merged from runs, and what was drawn in order
// is one run. The picture has the same bits for orders of every kind: both directions, parts that
// go on with the part before them or do not, coincident fragments within a run and between two.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include <algorithm>

using namespace vtkOITTest;

namespace
{
/// From near to far, faint enough for the last one to be seen.
std::vector<Layer> MakeLayers(int count, bool inPairs)
{
  std::vector<Layer> layers = Random(count).Layers(count);
  std::sort(
    layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.Depth < b.Depth; });
  for (int i = 0; i < count; ++i)
  {
    layers[i].Color.a *= 4.0f / static_cast<float>(count);
    layers[i].Depth = layers[inPairs ? i / 2 * 2 : i].Depth;
  }
  return layers;
}

Image RenderInOrder(Rig& rig, const std::vector<Layer>& layers, const std::vector<int>& order)
{
  rig.RemoveProps();
  for (const int i : order)
  {
    rig.AddQuad(layers[i]);
  }
  return rig.Render();
}

void CheckOrders(Report& report, Rig& rig, const Setup& setup, int count, bool inPairs)
{
  const std::vector<Layer> layers = MakeLayers(count, inPairs);
  std::vector<int> sorted(count);
  for (int i = 0; i < count; ++i)
  {
    sorted[i] = i;
  }
  const std::string what = std::to_string(count) + (inPairs ? " layers in pairs" : " layers");
  const Image first = RenderInOrder(rig, layers, sorted);
  report.Compare(what, first,
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));

  std::vector<int> reversed(sorted.rbegin(), sorted.rend());
  report.CompareBits(what + ", back to front", RenderInOrder(rig, layers, reversed), first);

  std::vector<int> rotated = sorted;
  std::rotate(rotated.begin(), rotated.begin() + count / 3, rotated.end());
  report.CompareBits(what + ", the last parts first", RenderInOrder(rig, layers, rotated), first);

  std::vector<int> both = sorted; // the near half front to back, the far half back to front
  std::reverse(both.begin() + count / 2, both.end());
  report.CompareBits(what + ", halves in two directions", RenderInOrder(rig, layers, both), first);

  std::vector<int> interleaved = sorted;
  std::stable_partition(interleaved.begin(), interleaved.end(), [](int i) { return i % 2 == 0; });
  report.CompareBits(
    what + ", every other one first", RenderInOrder(rig, layers, interleaved), first);

  std::vector<int> shuffled = sorted;
  Random(count + 1).Shuffle(shuffled);
  report.CompareBits(what + ", in no order", RenderInOrder(rig, layers, shuffled), first);
}

/// Sorted in two draws.
void CheckDeepList(Report& report, Rig& rig, const Setup& setup)
{
  constexpr int count = 3600;
  std::vector<Layer> layers = MakeLayers(count, false);
  Random(1).Shuffle(layers);
  rig.RemoveProps();
  rig.AddStack(layers);
  report.Compare(std::to_string(count) + " layers", rig.Render(),
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
}
}

int TestABufferRuns(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 8, 6);
      CheckOrders(report, rig, setup, 70, false);
      CheckOrders(report, rig, setup, 70, true);
      if (setup.FragmentStorage == Storage::Half && setup.Tier == "all extensions")
      {
        CheckDeepList(report, rig, setup);
      }
    });
}
