// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// How often the automatic pass tries to prove the shape of a mesh: not of one that changes in frame
// after frame, and again of one that stays.

#include "Rig/Report.h"

#include "Private/Auto/vtkOITMeshShapes.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace vtkOITTest;

namespace
{
using Shape = vtkOITMeshShape;

/// Proofs that are tried of a mesh that changes before some frames.
void CheckProofs(Report& report)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 5; ++i)
  {
    const int row = i / 2;
    points->InsertNextPoint(i % 2, row, 0.3 * (i % 3));
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2 });
  polys->InsertNextCell({ 1, 3, 2 });
  polys->InsertNextCell({ 2, 3, 4 });
  vtkNew<vtkPolyData> mesh; // neither closed nor flat
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkOITMeshShapes shapes;
  vtkOITMeshBalls balls;
  const auto look = [&](bool changes, int expected)
  {
    if (changes)
    {
      mesh->GetPoints()->Modified();
    }
    const vtkOITMeshShape shape = shapes.Find(actor, balls);
    shapes.Prune();
    report.Check(shape == vtkOITMeshShape::Unknown && shapes.GetNumberOfProofs() == expected,
      std::to_string(shapes.GetNumberOfProofs()) + " proofs, expected " + std::to_string(expected));
  };
  look(false, 1); // the first frame
  look(false, 1);
  for (int frame = 0; frame < 10; ++frame)
  {
    look(true, 1);
  }
  look(false, 2); // it stays
  look(false, 2);
  look(true, 2);
}

/// Of a closed convex mesh: found again after a change, not while it changes in frame after frame; and
/// scalars are no change.
void CheckProofsOfConvex(Report& report)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(32);
  ball->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(ball->GetOutput());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkOITMeshShapes shapes;
  vtkOITMeshBalls balls;
  const auto look = [&](const std::string& what, int expected, Shape shape)
  {
    const Shape found = shapes.Find(actor, balls);
    shapes.Prune();
    report.Check(found == shape && shapes.GetNumberOfProofs() == expected,
      what + (found == shape ? ": " : ": another shape, and ") +
        std::to_string(shapes.GetNumberOfProofs()) + " proofs, expected " +
        std::to_string(expected));
  };
  const auto change = [&]() { ball->GetOutput()->GetPoints()->Modified(); };
  look("new", 1, Shape::ClosedConvex);
  ball->GetOutput()->GetPointData()->Modified();
  look("other scalars", 1, Shape::ClosedConvex);
  change();
  look("changed once", 2, Shape::ClosedConvex);
  for (int frame = 0; frame < 5; ++frame)
  {
    change();
    look("changing", 2, Shape::Unknown);
  }
  look("resting", 3, Shape::ClosedConvex);
  look("resting", 3, Shape::ClosedConvex);
  std::vector<vtkSmartPointer<vtkPolyData>> series;
  for (int step = 0; step < 5; ++step)
  {
    series.push_back(vtkSmartPointer<vtkPolyData>::New());
    series.back()->DeepCopy(ball->GetOutput());
    mapper->SetInputData(series.back());
    look("a series", std::min(4 + step, 6), step < 3 ? Shape::ClosedConvex : Shape::Unknown);
  }
  look("the end of a series", 7, Shape::ClosedConvex);
}
}

int TestMeshProofs(int, char*[])
{
  Report report;
  report.SetContext("mesh proofs");
  CheckProofs(report);
  CheckProofsOfConvex(report);
  return report.GetExitStatus();
}
