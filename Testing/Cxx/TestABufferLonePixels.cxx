// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// One pixel of a tile has more fragments than all others, or needs more than the first try because
// its fragments coincide, at each place that it can have in a tile: it must be noticed, and drawn,
// in every frame that starts from what the last one had. Tiles are drawn as two triangles, and one
// pixel of two notes what the tile still needs; so the diagonal is another case. The other pixels,
// which the first try has drawn, are not drawn twice.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/vec2.hpp>

#include <string>

using namespace vtkOITTest;

namespace
{
constexpr int TileSize = 16; // of the pass, in either direction

/// A quad over one pixel in each of tiles x tiles tiles: in tile (i, j) over its pixel (i, j).
void AddLonePixels(Rig& rig, const Layer& layer, int tiles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> quads;
  for (int tile = 0; tile < tiles * tiles; ++tile)
  {
    const int x = (tile % tiles) * (TileSize + 1);
    const int y = (tile / tiles) * (TileSize + 1);
    quads->InsertNextCell(4);
    for (const auto& corner : { glm::ivec2(0, 0), { 1, 0 }, { 1, 1 }, { 0, 1 } })
    {
      const glm::dvec3 p = rig.ToWorld(x + corner.x, y + corner.y, layer.Depth);
      quads->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    }
  }
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetPolys(quads);
  rig.AddPolyData(polydata, layer.Color);
}

void CheckLonePixels(Report& report, const Setup& setup, const std::string& what,
  const std::vector<Layer>& common, const std::vector<Layer>& more, int tiles = TileSize,
  int frames = 4)
{
  Rig rig(setup, tiles * TileSize, tiles * TileSize);
  rig.AddStack(common);
  std::vector<Layer> layers = common;
  for (const Layer& layer : more)
  {
    AddLonePixels(rig, layer, tiles);
    layers.push_back(layer);
  }
  const glm::dvec4 background = rig.GetBackground();
  const glm::dvec4 elsewhere = ReferenceCompositor::Composite(common, background);
  const glm::dvec4 lone = ReferenceCompositor::Composite(layers, background);
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(common, background, setup.FragmentStorage) +
    ReferenceCompositor::RoundingBound(layers, background, setup.FragmentStorage);
  for (int frame = 1; frame <= frames; ++frame)
  {
    report.Compare(
      what + ", frame " + std::to_string(frame), rig.Render(),
      [&](int x, int y)
      {
        const bool isLone = x % TileSize == x / TileSize && y % TileSize == y / TileSize;
        return isLone ? lone : elsewhere;
      },
      bound);
    report.Check(rig.Pass->GetMaximumDepthComplexity() == static_cast<int>(layers.size()),
      what + ": a depth complexity of " + std::to_string(rig.Pass->GetMaximumDepthComplexity()));
  }
}
}

int TestABufferLonePixels(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      const std::vector<Layer> layers = Random(5).Layers(12);
      CheckLonePixels(report, setup, "many fragments", { layers.begin(), layers.begin() + 2 },
        { layers.begin() + 2, layers.end() });
      CheckLonePixels(report, setup, "coincident fragments",
        { { 0.75f, { 0.2f, 0.3f, 0.9f, 0.5f } } },
        { { 0.5f, { 0.9f, 0.2f, 0.1f, 0.5f } }, { 0.5f, { 0.1f, 0.8f, 0.2f, 0.25f } } });
      // Lists for the network for long lists, which is used from the ninth frame on that has any: those
      // beside the lone pixel must not be drawn again with it.
      std::vector<Layer> many = Random(7).Layers(40);
      for (Layer& layer : many)
      {
        layer.Color.a = 0.03f; // so that they are seen when they are drawn twice
      }
      const float depth = many[20].Depth;
      CheckLonePixels(report, setup, "coincident fragments beside long lists", many,
        { { depth, { 0.9f, 0.2f, 0.1f, 0.5f } } }, 3, 10);
      CheckLonePixels(
        report, setup, "a very long list beside long ones", many, Random(8).Layers(30), 3, 10);
    });
}
