// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// What is told of props without bringing pipelines up to date is what VTK tells: bounds, and when
// something has changed; and a pipeline is brought up to date where there is one.

#include "Rig/Report.h"

#include "Private/Frame/vtkOITPropInput.h"
#include "Private/Frame/vtkOITScreenExtents.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDataSetMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace vtkOITTest;

namespace
{
class Checker
{
public:
  explicit Checker(Report& report)
    : TheReport(report)
  {
  }

  void CheckBounds(const std::string& what, vtkActor* actor)
  {
    double found[6];
    if (!vtkOITGetBounds(actor, found))
    {
      this->TheReport.Check(false, what + ": no bounds");
      return;
    }
    const double* expected = actor->GetBounds();
    double difference = 0.0;
    for (int i = 0; i < 6; ++i)
    {
      difference = std::max(difference, std::abs(found[i] - expected[i]));
    }
    this->TheReport.Check(difference <= 1e-12, what + ": not the bounds that VTK tells");
  }

  /// Whether the actor is told to have changed since the last call.
  void CheckChange(const std::string& what, vtkActor* actor, bool expected = true)
  {
    const vtkMTimeType time = vtkOITGetRedrawMTime(actor);
    this->TheReport.Check((time != this->Time) == expected,
      what + (expected ? ": no change" : ": a change") + " is told");
    this->TheReport.Check(time == actor->GetRedrawMTime(), what + ": not the time that VTK tells");
    this->Time = time;
  }

private:
  Report& TheReport;
  vtkMTimeType Time = 0;
};

/// A triangle, and a point far away that no cell uses.
void MakeMesh(vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1, 2, 3);
  points->InsertNextPoint(4, 2, 3.5);
  points->InsertNextPoint(1, 7, 3);
  points->InsertNextPoint(100, 100, 100);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2 });
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
}

void CheckData(Checker& checker)
{
  vtkNew<vtkPolyData> mesh;
  MakeMesh(mesh);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  checker.CheckBounds("a mesh", actor);
  checker.CheckChange("a mesh", actor);
  checker.CheckChange("a mesh that rests", actor, false);

  mesh->GetPoints()->SetPoint(1, -3, 2, 3.5);
  mesh->GetPoints()->Modified();
  checker.CheckBounds("a point that has moved", actor);
  checker.CheckChange("a point that has moved", actor);
  actor->GetProperty()->SetOpacity(0.25);
  checker.CheckChange("another opacity", actor);
  mapper->ScalarVisibilityOff();
  checker.CheckChange("another setting of the mapper", actor);

  actor->SetPosition(1, -2, 3);
  actor->SetOrientation(20, 40, 60);
  actor->SetScale(2, -1, 0.5);
  checker.CheckBounds("a transformed mesh", actor);
  checker.CheckChange("a transformed mesh", actor);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, 10);
  matrix->SetElement(1, 0, 0.5);
  actor->SetUserMatrix(matrix);
  checker.CheckBounds("a matrix of the user", actor);
  checker.CheckChange("a matrix of the user", actor);
  matrix->SetElement(0, 3, 20);
  checker.CheckBounds("a matrix of the user that has changed", actor);
  checker.CheckChange("a matrix of the user that has changed", actor);

  vtkNew<vtkDataSetMapper> ofDataSets;
  ofDataSets->SetInputData(mesh);
  actor->SetMapper(ofDataSets);
  checker.CheckBounds("a mapper of data sets", actor);
  checker.CheckChange("a mapper of data sets", actor);
}

void CheckPipeline(Checker& checker, Report& report)
{
  vtkNew<vtkSphereSource> source;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  checker.CheckBounds("a pipeline", actor);
  checker.CheckChange("a pipeline", actor);
  source->SetRadius(3);
  double bounds[6] = {};
  report.Check(vtkOITGetBounds(actor, bounds) && bounds[5] > 2.5,
    "a pipeline that has changed: bounds of before");
  source->SetRadius(5);
  checker.CheckChange("a pipeline that has changed", actor);
  source->SetRadius(7);
  vtkOITUpdateInput(mapper);
  report.Check(source->GetOutput()->GetBounds()[5] > 6.5, "a pipeline is not brought up to date");
}

/// What is drawn of a static mapper is what it has.
void CheckStatic(Checker& checker, Report& report)
{
  vtkNew<vtkSphereSource> source;
  source->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->StaticOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  checker.CheckBounds("a static mapper", actor);
  source->SetRadius(3);
  vtkOITUpdateInput(mapper);
  checker.CheckBounds("a static mapper whose source has changed", actor);
  report.Check(
    source->GetOutput()->GetBounds()[5] < 1.0, "the input of a static mapper is updated");
}

/// Bounds do not limit where a perspective matrix of the user puts a mesh.
void CheckPerspective(Report& report)
{
  vtkNew<vtkPolyData> mesh;
  MakeMesh(mesh);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkMatrix4x4> matrix;
  actor->SetUserMatrix(matrix);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(2, 4, 50);
  renderer->GetActiveCamera()->SetFocalPoint(2, 4, 3);
  renderer->GetActiveCamera()->SetClippingRange(1, 100);
  const auto isBounded = [&]() {
    return vtkOITFindScreenExtents(renderer, { actor }, { 0, 0, 100, 100 }).front().IsBounded;
  };
  report.Check(isBounded(), "an affine matrix has no extent");
  matrix->SetElement(3, 0, 0.25);
  report.Check(!isBounded(), "a perspective matrix has an extent");
}

void CheckNothing(Report& report)
{
  vtkNew<vtkActor> actor;
  vtkNew<vtkPolyDataMapper> mapper;
  double bounds[6];
  vtkNew<vtkPolyData> mesh;
  mapper->SetInputData(mesh);
  actor->SetMapper(mapper);
  report.Check(
    vtkOITGetBounds(actor, bounds) && !vtkMath::AreBoundsInitialized(bounds), "bounds of no cells");
  vtkNew<vtkPolyDataMapper> unconnected;
  actor->SetMapper(unconnected);
  report.Check(vtkOITGetBounds(actor, bounds) && !vtkMath::AreBoundsInitialized(bounds),
    "bounds without an input");
  vtkOITUpdateInput(unconnected);
  report.Check(vtkOITGetRedrawMTime(actor) > 0, "no time without an input");
}
}

int TestPropInput(int, char*[])
{
  Report report;
  report.SetContext("prop input");
  Checker checker(report);
  CheckData(checker);
  CheckPipeline(checker, report);
  CheckStatic(checker, report);
  CheckPerspective(report);
  CheckNothing(report);
  return report.GetExitStatus();
}
