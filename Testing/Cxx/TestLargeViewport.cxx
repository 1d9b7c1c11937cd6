// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 27: viewports as wide and as high as a texture may be, with a different picture in
// every block of pixels: indices that wrap or are rounded to float32 would show. The size of what
// is tested is bounded by the memory and time of a test; what lies beyond 128 MiB of fragments is
// in TestABufferLargeStore.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/GLObjects.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

using namespace vtkOITTest;

namespace
{
/// Rectangles that cover the viewport in overlapping blocks, at distinct depths.
struct Piece
{
  Layer TheLayer;
  PixelRectangle Rectangle;
};

std::vector<Piece> MakePieces(int width, int height)
{
  Random random(27);
  std::vector<Piece> pieces;
  for (const Layer& layer : random.Layers(24))
  {
    const int x = random.Below(width);
    const int y = random.Below(height);
    const int right = x + 1 + width / 3;
    const int top = y + 1 + height / 3;
    pieces.push_back({ layer, { double(x), double(y), double(right), double(top) } });
  }
  // The last pixel of all.
  pieces.push_back({ { 0.0625f, { 0.9f, 0.8f, 0.1f, 0.5f } },
    { width - 1.0, height - 1.0, double(width), double(height) } });
  return pieces;
}

void CheckSize(Report& report, const Setup& setup, int width, int height)
{
  const std::string what = std::to_string(width) + " x " + std::to_string(height);
  Rig rig(setup, width, height);
  const std::vector<Piece> pieces = MakePieces(width, height);
  for (const Piece& piece : pieces)
  {
    rig.AddQuad(piece.TheLayer, piece.Rectangle);
  }
  const Image image = rig.Render();
  report.Compare(
    what, image,
    [&](int x, int y)
    {
      std::vector<Layer> layers;
      for (const Piece& piece : pieces)
      {
        if (piece.Rectangle.Contains(x, y))
        {
          layers.push_back(piece.TheLayer);
        }
      }
      return ReferenceCompositor::Composite(layers, rig.GetBackground());
    },
    ReferenceCompositor::RoundingBoundOfAnyStack(25, setup.FragmentStorage));
  report.Check(rig.Pass->GetExact() && rig.Pass->GetErrorBound() == 0.0, what + ": not exact");

  // Rendered in tiles of half the size the picture has the same bits.
  if (width % 2 == 0 && height % 2 == 0)
  {
    Rig part(setup, width / 2, height / 2);
    part.Window->SetTileScale(2);
    for (const Piece& piece : pieces)
    {
      part.AddQuad(piece.TheLayer,
        { piece.Rectangle.X0 / 2, piece.Rectangle.Y0 / 2, piece.Rectangle.X1 / 2,
          piece.Rectangle.Y1 / 2 });
    }
    for (int tile = 0; tile < 4; ++tile)
    {
      const int row = tile / 2;
      const double x = 0.5 * (tile % 2);
      const double y = 0.5 * row;
      // As vtkWindowToImageFilter does it.
      part.Window->SetTileViewport(x, y, x + 0.5, y + 0.5);
      part.Renderer->GetActiveCamera()->SetWindowCenter(4.0 * x - 1.0, 4.0 * y - 1.0);
      part.Renderer->GetActiveCamera()->SetParallelScale(0.5);
      const std::string name = what + ", tile " + std::to_string(tile);
      const Image expected =
        Crop(image, tile % 2 * width / 2, tile / 2 * height / 2, width / 2, height / 2);
      if (setup.Method == "dual")
      {
        // Which layers are blended first depends on the depth complexity of the frame before.
        const double rounding = std::ldexp(1.0, -22);
        report.Compare(name, part.Render(), expected, { rounding, rounding });
      }
      else
      {
        report.CompareBits(name, part.Render(), expected);
      }
    }
  }
}
}

int TestLargeViewport(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(27);
      int largest = 0;
      {
        Rig rig(setup, 8, 8);
        rig.Window->Render();
        rig.Window->MakeCurrent();
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
      }
      largest = std::min(largest, 16384);
      // Buckets have textures only, whose pixels are not counted through, and draw slowly.
      const bool isSmall = setup.Method.rfind("bucket", 0) == 0 && !setup.IsLong;
      CheckSize(report, setup, largest, isSmall ? 4 : 8);
      CheckSize(report, setup, isSmall ? 4 : 8, largest);
      CheckSize(report, setup, 1025, isSmall ? 33 : 513);
    });
}
