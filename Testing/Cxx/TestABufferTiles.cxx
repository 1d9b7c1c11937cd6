// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Resolve draws tiles as two triangles, and one pixel of four notes what the tile still needs. A
// single pixel that needs more than the first try, because its fragments coincide, is not
// forgotten, wherever in the tile it is: on the diagonal too.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include "vtkActor.h"

using namespace vtkOITTest;

namespace
{
constexpr int TileSize = 16;
constexpr int Size = 3 * TileSize;
}

int TestABufferTiles(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, Size, Size);
      // Two coincident fragments in one pixel that moves, and a layer over everything behind it:
      // the rectangle that is rendered and the size of the networks stay the same.
      const std::vector<Layer> layers{ { 0.5f, { 0.9f, 0.2f, 0.1f, 0.5f } },
        { 0.5f, { 0.1f, 0.8f, 0.2f, 0.25f } } };
      const Layer behind{ 0.75f, { 0.2f, 0.3f, 0.9f, 0.5f } };
      rig.AddQuad(behind);
      vtkActor* actors[2];
      for (int i = 0; i < 2; ++i)
      {
        actors[i] = rig.AddQuad(layers[i], { 0.0, 0.0, 1.0, 1.0 });
      }
      const glm::dvec4 one = ReferenceCompositor::Composite({ behind }, rig.GetBackground());
      const glm::dvec4 three =
        ReferenceCompositor::Composite({ layers[0], layers[1], behind }, rig.GetBackground());
      const Tolerance bound = ReferenceCompositor::RoundingBound(
        { layers[0], layers[1], behind }, rig.GetBackground(), setup.FragmentStorage);
      for (int i = 0; i < TileSize * TileSize; ++i)
      {
        const int column = TileSize + i % TileSize;
        const int row = TileSize + i / TileSize;
        for (vtkActor* actor : actors)
        {
          actor->SetPosition(2.0 * column / Size, 2.0 * row / Size, 0.0);
        }
        report.Compare(
          "pixel " + std::to_string(column) + ", " + std::to_string(row), rig.Render(),
          [&](int x, int y) { return x == column && y == row ? three : one; }, bound);
        report.Check(rig.Pass->GetMaximumDepthComplexity() == 3,
          "a depth complexity of " + std::to_string(rig.Pass->GetMaximumDepthComplexity()));
      }
    });
}
