// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress tests 3, 4 and 34: the picture has the same bits whatever the order of drawing, frame
// after frame, in every way of use, and with a storage so small that it is rendered in parts.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include <map>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 61;
constexpr int Height = 43;

struct Piece
{
  Layer TheLayer;
  PixelRectangle Rectangle;
};

/// Overlapping rectangles of random size at distinct depths.
std::vector<Piece> MakeScene()
{
  Random random(7);
  std::vector<Piece> pieces;
  for (const Layer& layer : random.Layers(40))
  {
    const double x = random.Below(Width - 10);
    const double y = random.Below(Height - 10);
    pieces.push_back({ layer, { x, y, x + 10 + random.Below(40), y + 10 + random.Below(30) } });
  }
  return pieces;
}

Image Reference(const std::vector<Piece>& pieces, const glm::dvec4& background)
{
  Image image{ Width, Height, {} };
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      std::vector<Layer> layers;
      for (const Piece& piece : pieces)
      {
        if (piece.Rectangle.Contains(x, y))
        {
          layers.push_back(piece.TheLayer);
        }
      }
      image.Pixels.emplace_back(ReferenceCompositor::Composite(layers, background));
    }
  }
  return image;
}

Image RenderPieces(Rig& rig, const std::vector<Piece>& pieces)
{
  rig.RemoveProps();
  for (const Piece& piece : pieces)
  {
    rig.AddQuad(piece.TheLayer, piece.Rectangle);
  }
  return rig.Render();
}
}

int TestDrawOrder(int argc, char* argv[])
{
  // The picture of the first way of use, for each tier and storage.
  std::map<std::pair<std::string, Storage>, Image> firstUse;
  return RunTest(argc, argv, Setups::All,
    [&](Report& report, const Setup& setup)
    {
      std::vector<Piece> pieces = MakeScene();
      Rig rig(setup, Width, Height);
      report.SetStressTest(2);
      const Image first = RenderPieces(rig, pieces);

      report.Compare("against the reference", first, Reference(pieces, rig.GetBackground()),
        ReferenceCompositor::RoundingBoundOfAnyStack(40, setup.FragmentStorage));

      // In other ways of use and tiers fewer ones.
      const bool hasMany =
        setup.IsLong || setup.IsContender || (setup.UseMode == Use::Installed && setup.HasFetch);
      report.SetStressTest(4);
      for (int frame = 0; frame < (hasMany ? 20 : 4); ++frame)
      {
        report.CompareBits("frame " + std::to_string(frame), rig.Render(), first);
      }
      report.SetStressTest(3);
      Random random(11);
      for (int order = 0; order < (hasMany ? 8 : 3); ++order)
      {
        random.Shuffle(pieces);
        report.CompareBits("draw order " + std::to_string(order), RenderPieces(rig, pieces), first);
      }
      report.SetStressTest(34);
      rig.Pass->SetMaximumBufferSize(1 << 20);
      report.CompareBits("with 1 MiB of storage", rig.Render(), first);
      rig.Pass->SetMaximumBufferSize(0);
      report.CompareBits("without a limit again", rig.Render(), first);

      const auto other = firstUse.emplace(std::make_pair(setup.Tier, setup.FragmentStorage), first);
      report.CompareBits("as in the first way of use", first, other.first->second);
    });
}
