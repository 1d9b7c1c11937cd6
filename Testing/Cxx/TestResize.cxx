// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// The window changes its size between frames: every size is right, and a size seen before gives
// the same bits again.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include <map>

using namespace vtkOITTest;

namespace
{
/// With limited memory, textures have the size of what is drawn, and are made anew as it grows.
void CheckGrowth(Report& report, const Setup& setup)
{
  const std::vector<Layer> layers = Random(18).Layers(9);
  Rig rig(setup, 64, 64);
  rig.Pass->SetMaximumBufferSize(64 << 20);
  const glm::dvec4 background = rig.GetBackground();
  const glm::dvec4 inside = ReferenceCompositor::Composite(layers, background);
  for (int size = 8; size <= 64; size += 8)
  {
    const PixelRectangle rectangle{ 0.0, 0.0, double(size), double(size) };
    rig.RemoveProps();
    for (const Layer& layer : layers)
    {
      rig.AddQuad(layer, rectangle);
    }
    report.Compare(
      std::to_string(size) + " pixels a side, limited memory", rig.Render(),
      [&](int x, int y) { return rectangle.Contains(x, y) ? inside : background; },
      ReferenceCompositor::RoundingBound(layers, background, setup.FragmentStorage));
  }
}
}

int TestResize(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      CheckGrowth(report, setup);
      const std::vector<Layer> layers = Random(17).Layers(12);
      Rig rig(setup, 64, 64);
      const glm::dvec4 background = rig.GetBackground();
      const Tolerance bound =
        ReferenceCompositor::RoundingBound(layers, background, setup.FragmentStorage);
      const glm::dvec4 inside = ReferenceCompositor::Composite(layers, background);
      std::map<std::pair<int, int>, Image> seen;
      const std::pair<int, int> sizes[] = { { 64, 64 }, { 110, 70 }, { 31, 77 }, { 1, 1 },
        { 64, 64 }, { 300, 7 }, { 110, 70 } };
      for (const auto& size : sizes)
      {
        const std::string what = std::to_string(size.first) + "x" + std::to_string(size.second);
        rig.SetSize(size.first, size.second);
        rig.RemoveProps();
        // A border of a few pixels, so that a stale size shows.
        const PixelRectangle rectangle{ size.first > 10 ? 3.0 : 0.0, size.second > 10 ? 4.0 : 0.0,
          double(size.first), double(size.second) };
        for (const Layer& layer : layers)
        {
          rig.AddQuad(layer, rectangle);
        }
        const Report::Expected expected = [&](int x, int y)
        { return rectangle.Contains(x, y) ? inside : background; };
        const Image image = rig.Render();
        report.Check(image.Width == size.first && image.Height == size.second,
          what + ": the target has another size");
        report.Compare(what, image, expected, bound);
        report.Compare(
          what + " in the window", rig.RenderWindow(), expected, bound + Rig::WindowTolerance());
        const auto first = seen.emplace(size, image);
        report.CompareBits(what + " again", image, first.first->second);
      }
    });
}
