// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 20: a quad cut into a million triangles smaller than a pixel covers each of its
// pixels exactly once.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace vtkOITTest;

namespace
{
constexpr int Cells = 708; // on a side: 2 * 708^2 triangles are 1.0e6

vtkSmartPointer<vtkPolyData> MakeSheet(
  const Rig& rig, const PixelRectangle& rectangle, double depth)
{
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(vtkIdType(Cells + 1) * (Cells + 1));
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j <= Cells; ++j)
  {
    for (int i = 0; i <= Cells; ++i)
    {
      const vtkIdType id = vtkIdType(j) * (Cells + 1) + i;
      const glm::dvec3 point = rig.ToWorld(rectangle.X0 + (rectangle.X1 - rectangle.X0) * i / Cells,
        rectangle.Y0 + (rectangle.Y1 - rectangle.Y0) * j / Cells, depth);
      points->SetPoint(id, point.x, point.y, point.z);
      if (i < Cells && j < Cells)
      {
        const vtkIdType corners[2][3] = { { id, id + 1, id + Cells + 2 },
          { id, id + Cells + 2, id + Cells + 1 } };
        triangles->InsertNextCell(3, corners[0]);
        triangles->InsertNextCell(3, corners[1]);
      }
    }
  }
  auto sheet = vtkSmartPointer<vtkPolyData>::New();
  sheet->SetPoints(points);
  sheet->SetPolys(triangles);
  return sheet;
}
}

int TestTessellation(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(20);
      Rig rig(setup, 64, 48);
      // Edges on borders of pixels, so that no pixel centre lies on one.
      const PixelRectangle rectangle{ 5.0, 7.0, 59.0, 41.0 };
      const Layer layer{ 0.5f, { 0.9f, 0.2f, 0.4f, 0.375f } };
      rig.AddPolyData(MakeSheet(rig, rectangle, layer.Depth), layer.Color);
      const Image tessellated = rig.Render();
      const glm::dvec4 inside = ReferenceCompositor::Composite({ layer }, rig.GetBackground());
      report.Compare(
        "a million triangles", tessellated,
        [&](int x, int y) { return rectangle.Contains(x, y) ? inside : rig.GetBackground(); },
        ReferenceCompositor::RoundingBound({ layer }, rig.GetBackground(), setup.FragmentStorage));
      report.Check(
        rig.Pass->GetNumberOfFragments() < 0 || rig.Pass->GetNumberOfFragments() == 54 * 34,
        "the pass counts " + std::to_string(rig.Pass->GetNumberOfFragments()) +
          " fragments, there are 1836");

      rig.RemoveProps();
      rig.AddQuad(layer, rectangle);
      if (setup.Method == "auto")
      {
        // It blends the quad and sorts the sheet, which is too large to be proven flat.
        report.Compare("the single quad", rig.Render(), tessellated,
          ReferenceCompositor::RoundingBound(
            { layer }, rig.GetBackground(), setup.FragmentStorage));
        return;
      }
      report.CompareBits("the single quad", rig.Render(), tessellated);
    });
}
