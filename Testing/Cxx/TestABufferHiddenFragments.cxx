// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Fragments of opacity 1, of textures and of scalars, hide what is behind them before it is stored.
// The picture has the same bits with and without, also with coincident fragments and opaque
// geometry in between, and it is not tried where no prop can have such fragments.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkOITABufferPass.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <string>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;
constexpr float OpaqueDepth = 0.6f;
const PixelRectangle OpaqueRectangle{ 0.0, 30.0, 80.0, 90.0 };

/// Of the left and the right half of a prop, in steps of 1/255.
using Halves = std::array<std::array<unsigned char, 4>, 2>;

struct Piece
{
  float Depth;
  Halves Colors;
  enum
  {
    Plain,
    Texture,
    Scalars,
    Table
  } Kind;
};

glm::vec4 GetColor(const Piece& piece, int x, float opacity)
{
  const auto& c = piece.Colors[x < Width / 2 ? 0 : 1];
  return glm::vec4(c[0], c[1], c[2], c[3] * opacity) / 255.0f;
}

vtkSmartPointer<vtkTexture> MakeTexture(const Halves& halves)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  colors->InsertNextTypedTuple(halves[0].data());
  colors->InsertNextTypedTuple(halves[1].data());
  image->GetPointData()->SetScalars(colors);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  texture->SetColorModeToDirectScalars();
  return texture;
}

/// Two quads side by side over the viewport, with texture coordinates.
vtkSmartPointer<vtkPolyData> MakeHalves(const Rig& rig, float depth)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const double y : { 0.0, 1.0 })
  {
    for (const double x : { 0.0, 0.5, 1.0 })
    {
      const glm::dvec3 point = rig.ToWorld(x * Width, y * Height, depth);
      points->InsertNextPoint(point.x, point.y, point.z);
      coordinates->InsertNextTuple2(x, y);
    }
  }
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 4, 3 });
  quads->InsertNextCell({ 1, 2, 5, 4 });
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetPolys(quads);
  polydata->GetPointData()->SetTCoords(coordinates);
  return polydata;
}

void AddPiece(Rig& rig, const Piece& piece, float opacity)
{
  if (piece.Kind == Piece::Plain)
  {
    rig.AddQuad({ piece.Depth, GetColor(piece, 0, 1.0f) });
    return;
  }
  vtkActor* actor = rig.AddPolyData(MakeHalves(rig, piece.Depth), glm::vec4(1.0f));
  auto* polydata = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  actor->ForceTranslucentOn();
  actor->GetProperty()->SetOpacity(opacity);
  if (piece.Kind == Piece::Texture)
  {
    actor->SetTexture(MakeTexture(piece.Colors));
  }
  else if (piece.Kind == Piece::Scalars)
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    colors->InsertNextTypedTuple(piece.Colors[0].data());
    colors->InsertNextTypedTuple(piece.Colors[1].data());
    polydata->GetCellData()->SetScalars(colors);
  }
  else
  {
    vtkNew<vtkFloatArray> values;
    values->InsertNextValue(0.0f);
    values->InsertNextValue(1.0f);
    polydata->GetCellData()->SetScalars(values);
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(2);
    for (int i = 0; i < 2; ++i)
    {
      const glm::dvec4 c = glm::dvec4(GetColor(piece, i * Width / 2, 1.0f));
      table->SetTableValue(i, c.r, c.g, c.b, c.a);
    }
    actor->GetMapper()->SetLookupTable(table);
    actor->GetMapper()->SetScalarRange(0.0, 1.0);
    actor->GetMapper()->UseLookupTableScalarRangeOff();
  }
}

Piece MakePlain(float depth, unsigned char red, unsigned char opacity)
{
  const std::array<unsigned char, 4> color{ red, 120, 40, opacity };
  return { depth, { color, color }, Piece::Plain };
}

/// Solid on the right at 0.3, on the left at 0.4, where something coincides, everywhere at 0.75;
/// pairs that coincide in front of them and behind.
std::vector<Piece> MakeScene()
{
  std::vector<Piece> pieces{
    { 0.3f, { { { 10, 200, 30, 64 }, { 240, 20, 10, 255 } } }, Piece::Texture },
    { 0.4f, { { { 30, 10, 250, 255 }, { 90, 90, 10, 128 } } }, Piece::Scalars },
    { 0.75f, { { { 200, 100, 10, 255 }, { 10, 100, 200, 255 } } }, Piece::Table },
  };
  for (const float depth : { 0.2f, 0.4f, 0.8f })
  {
    pieces.push_back(MakePlain(depth, 250, 40));
    pieces.push_back(MakePlain(depth, 90, 60));
  }
  for (const float depth : Random(5).Depths(40))
  {
    pieces.push_back(MakePlain(depth, static_cast<unsigned char>(255.0f * depth), 12));
  }
  Random(6).Shuffle(pieces);
  return pieces;
}

void Build(Rig& rig, const std::vector<Piece>& pieces, float opacity = 1.0f)
{
  rig.RemoveProps();
  rig.AddQuad({ OpaqueDepth, { 0.3f, 0.9f, 0.6f, 1.0f } }, OpaqueRectangle);
  for (const Piece& piece : pieces)
  {
    AddPiece(rig, piece, opacity);
  }
}

/// Those that the depth test lets pass at a pixel.
std::vector<Layer> GetLayers(const std::vector<Piece>& pieces, int x, int y, float nearest)
{
  std::vector<Layer> layers;
  for (const Piece& piece : pieces)
  {
    const Layer layer{ piece.Depth, GetColor(piece, x, 1.0f) };
    if (piece.Depth <= nearest && (piece.Depth <= OpaqueDepth || !OpaqueRectangle.Contains(x, y)))
    {
      layers.push_back(layer);
    }
  }
  return layers;
}

/// Fragments, with or without those that are hidden.
vtkTypeInt64 CountFragments(const std::vector<Piece>& pieces, bool withHidden)
{
  vtkTypeInt64 count = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const float solid = x < Width / 2 ? 0.4f : 0.3f;
      count += static_cast<vtkTypeInt64>(GetLayers(pieces, x, y, withHidden ? 1.0f : solid).size());
    }
  }
  return count;
}

bool HasSkipped(Report& report, Rig& rig, const std::string& what, vtkTypeInt64 fragments)
{
  auto* pass = vtkOITABufferPass::SafeDownCast(rig.Pass);
  const bool hasSkipped = pass->GetSkippedHiddenFragments();
  report.Check(pass->GetNumberOfGeometryPasses() == (hasSkipped ? 2 : 1), what + ": passes");
  report.Check(pass->GetNumberOfFragments() == fragments,
    what + ": " + std::to_string(pass->GetNumberOfFragments()) + " fragments, expected " +
      std::to_string(fragments));
  report.Check(pass->GetExact() && pass->GetErrorBound() == 0.0, what + ": is not exact");
  return hasSkipped;
}

void CheckPicture(Report& report, const Setup& setup, int depthFormat)
{
  Rig rig(setup, Width, Height);
  rig.SetTargetFormat(VTK_FLOAT, depthFormat);
  auto* pass = vtkOITABufferPass::SafeDownCast(rig.Pass);
  std::vector<Piece> pieces = MakeScene();
  Build(rig, pieces);
  const vtkTypeInt64 all = CountFragments(pieces, true);
  const vtkTypeInt64 seen = CountFragments(pieces, false);

  pass->SkipHiddenFragmentsOff();
  const Image complete = rig.Render();
  const Image depth = rig.GetDepth();
  rig.Render();
  report.Check(!HasSkipped(report, rig, "off", all), "off: skipped");
  report.Compare(
    "off", complete,
    [&](int x, int y)
    {
      const glm::dvec4 behind = OpaqueRectangle.Contains(x, y)
        ? glm::dvec4(glm::vec4(0.3f, 0.9f, 0.6f, 1.0f))
        : rig.GetBackground();
      return ReferenceCompositor::Composite(GetLayers(pieces, x, y, 1.0f), behind);
    },
    ReferenceCompositor::RoundingBoundOfAnyStack(50, setup.FragmentStorage));

  pass->SkipHiddenFragmentsOn();
  report.CompareBits("on, first frame", rig.Render(), complete);
  report.Check(!HasSkipped(report, rig, "first frame", all), "first frame: skipped");
  for (const std::string frame : { "second frame", "third frame" })
  {
    report.CompareBits("on, " + frame, rig.Render(), complete);
    report.Check(HasSkipped(report, rig, frame, seen), frame + ": not skipped");
    report.CompareBits("depth, " + frame, rig.GetDepth(), depth);
  }
  for (int order = 0; order < 2; ++order)
  {
    Random(7 + order).Shuffle(pieces);
    Build(rig, pieces);
    report.CompareBits("another order of drawing", rig.Render(), complete);
    report.Check(HasSkipped(report, rig, "another order", seen), "another order: not skipped");
  }
}

/// Never where it cannot save anything, and once where it turns out to save too little.
void CheckTrials(Report& report, const Setup& setup)
{
  Rig rig(setup, Width, Height);
  const std::vector<Piece> pieces = MakeScene();
  Build(rig, pieces, 0.9f);
  rig.Render(); // twice, until the storage is large enough
  for (int frame = 0; frame < 3; ++frame)
  {
    rig.Render();
    report.Check(!HasSkipped(report, rig, "opacity 0.9", CountFragments(pieces, true)),
      "opacity 0.9: skipped");
  }
  std::vector<Piece> behind{ { 0.95f, { { { 9, 9, 9, 64 }, { 9, 9, 9, 254 } } }, Piece::Table } };
  for (int i = 0; i < 3; ++i)
  {
    behind.push_back(MakePlain(0.1f * static_cast<float>(i + 1), 100, 100));
  }
  Build(rig, behind);
  for (int frame = 0; frame < 3; ++frame)
  {
    rig.Render();
    report.Check(!HasSkipped(report, rig, "faint table", CountFragments(behind, true)),
      "faint table: skipped");
  }
  behind[0].Colors[1][3] = 255;
  Build(rig, behind);
  for (int frame = 0; frame < 4; ++frame)
  {
    rig.Render();
    report.Check(
      HasSkipped(report, rig, "solid behind", CountFragments(behind, true)) == (frame == 1),
      "solid behind: frame " + std::to_string(frame));
  }
}
}

int TestABufferHiddenFragments(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      CheckPicture(report, setup, vtkTextureObject::Float32);
      CheckPicture(report, setup, vtkTextureObject::Fixed24);
      CheckTrials(report, setup);
    });
}
