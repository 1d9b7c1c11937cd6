// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 24: translucent lines. Where two cross there are two layers, and at the joint of a
// polyline one or two, never none.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <glm/vec2.hpp>

#include <cmath>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 64;
constexpr int Height = 48;

/// A polyline through pixel positions, of one depth.
vtkActor* AddLine(
  Rig& rig, const std::vector<glm::dvec2>& pixels, double depth, const glm::vec4& color)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(pixels.size()));
  for (const glm::dvec2& pixel : pixels)
  {
    const glm::dvec3 point = rig.ToWorld(pixel.x, pixel.y, depth);
    lines->InsertCellPoint(points->InsertNextPoint(point.x, point.y, point.z));
  }
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetLines(lines);
  return rig.AddPolyData(polydata, color);
}

/// A horizontal and a vertical line, whose pixels are known: the row and the column.
void CheckCrossing(Report& report, Rig& rig, const Setup& setup, bool swapped)
{
  const Layer row{ swapped ? 0.75f : 0.25f, { 0.9f, 0.1f, 0.2f, 0.5f } };
  const Layer column{ 0.5f, { 0.1f, 0.8f, 0.3f, 0.25f } };
  rig.RemoveProps();
  AddLine(rig, { { 6.5, 20.5 }, { 50.5, 20.5 } }, row.Depth, row.Color);
  AddLine(rig, { { 30.5, 4.5 }, { 30.5, 40.5 } }, column.Depth, column.Color);
  const Image image = rig.Render();
  const glm::dvec4 background = rig.GetBackground();
  const Tolerance bound =
    ReferenceCompositor::RoundingBound({ row, column }, background, setup.FragmentStorage);
  report.Compare(
    swapped ? "crossing lines, column in front" : "crossing lines, row in front", image,
    [&](int x, int y)
    {
      // The last pixel of a line belongs to it or not, by the diamond-exit rule.
      if ((y == 20 && x == 50) || (x == 30 && y == 40) || (y == 20 && x == 6) ||
        (x == 30 && y == 4))
      {
        return glm::dvec4(image.At(x, y));
      }
      std::vector<Layer> layers;
      if (y == 20 && x > 6 && x < 50)
      {
        layers.push_back(row);
      }
      if (x == 30 && y > 4 && y < 40)
      {
        layers.push_back(column);
      }
      return ReferenceCompositor::Composite(layers, background);
    },
    bound);
}

/// Zigzag: each pixel that an opaque zigzag covers has one layer, or two at the joints.
void CheckJoints(Report& report, Rig& rig, const Setup& setup, float width)
{
  std::vector<glm::dvec2> zigzag;
  for (int i = 0; i < 7; ++i)
  {
    zigzag.emplace_back(5.25 + 8.5 * i, i % 2 ? 39.75 : 7.5);
  }
  const Layer layer{ 0.5f, { 0.9f, 0.6f, 0.1f, 0.5f } };
  rig.RemoveProps();
  vtkActor* actor = AddLine(rig, zigzag, layer.Depth, layer.Color);
  actor->GetProperty()->SetLineWidth(width);
  const Image image = rig.Render();
  actor->GetProperty()->SetOpacity(1.0);
  actor->ForceOpaqueOn();
  const Image opaque = rig.Render();

  const glm::dvec4 background = rig.GetBackground();
  const glm::dvec4 one = ReferenceCompositor::Composite({ layer }, background);
  const glm::dvec4 two = ReferenceCompositor::Composite({ layer, layer }, background);
  int covered = 0;
  int doubled = 0;
  bool far = false;
  const std::string what = "joints of a polyline of width " + std::to_string(int(width));
  report.Compare(
    what, image,
    [&](int x, int y)
    {
      if (opaque.At(x, y).r == float(background.r))
      {
        return background;
      }
      ++covered;
      if (std::abs(image.At(x, y).r - two.r) >= std::abs(image.At(x, y).r - one.r))
      {
        return one;
      }
      ++doubled;
      double nearest = 1e30;
      for (const glm::dvec2& joint : zigzag)
      {
        nearest = std::min(nearest, std::hypot(x + 0.5 - joint.x, y + 0.5 - joint.y));
      }
      // Segments that meet at an acute angle overlap up to some widths from the joint.
      far = far || nearest > 1.5 + 4.0 * (width - 1.0);
      return two;
    },
    ReferenceCompositor::RoundingBound({ layer, layer }, background, setup.FragmentStorage));
  report.Check(covered > 150, what + ": only " + std::to_string(covered) + " pixels");
  report.Check(!far && doubled < covered / 4,
    what + ": " + std::to_string(doubled) + " of " + std::to_string(covered) + " pixels doubled");
}
}

int TestLines(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(24);
      Rig rig(setup, Width, Height);
      CheckCrossing(report, rig, setup, false);
      CheckCrossing(report, rig, setup, true);
      CheckJoints(report, rig, setup, 1.0f);
      CheckJoints(report, rig, setup, 3.0f);
    });
}
