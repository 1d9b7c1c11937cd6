// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// The balls inside of and around closed convex meshes, which tell that one prop encloses another.

#include "Rig/Report.h"

#include "Private/Auto/vtkOITMeshShape.h"

#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <string>

using namespace vtkOITTest;

namespace
{
constexpr double Rounding = 1e-5; // of float coordinates, and the tolerance of flatness

bool IsNear(double a, double b)
{
  return std::abs(a - b) < Rounding;
}

void CheckBalls(
  Report& report, const std::string& what, vtkPolyData* mesh, const vtkOITMeshBalls& expected)
{
  vtkOITMeshBalls balls;
  vtkOITFindMeshShape(mesh, balls);
  bool isRight = IsNear(balls.Inner, expected.Inner) && IsNear(balls.Outer, expected.Outer);
  for (int i = 0; i < 3; ++i)
  {
    isRight = isRight && IsNear(balls.Center[i], expected.Center[i]);
  }
  report.Check(isRight,
    what + ": inner radius " + std::to_string(balls.Inner) + ", outer radius " +
      std::to_string(balls.Outer));
  report.Check(balls.Inner <= expected.Inner && balls.Outer >= expected.Outer,
    what + ": a ball is not on the safe side");
}
}

int TestMeshBalls(int, char*[])
{
  Report report;
  report.SetContext("mesh balls");

  vtkNew<vtkCubeSource> box;
  box->SetBounds(1.0, 3.0, -2.0, 2.0, 0.0, 6.0);
  box->Update();
  const vtkOITMeshBalls ofBox{ { 2.0, 0.0, 3.0 }, 1.0, std::sqrt(1.0 + 4.0 + 9.0) };
  CheckBalls(report, "box", box->GetOutput(), ofBox);

  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputConnection(box->GetOutputPort());
  reverse->ReverseCellsOn();
  reverse->Update();
  CheckBalls(report, "box inside out", reverse->GetOutput(), ofBox);

  // An octahedron: the planes of its faces are 1 / sqrt(3) away.
  vtkNew<vtkSphereSource> octahedron;
  octahedron->SetRadius(2.0);
  octahedron->SetThetaResolution(4);
  octahedron->SetPhiResolution(3);
  octahedron->Update();
  CheckBalls(
    report, "octahedron", octahedron->GetOutput(), { {}, 2.0 / std::sqrt(3.0) + 1e-7, 2.0 - 1e-7 });

  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  vtkOITMeshBalls balls = ofBox;
  vtkOITFindMeshShape(plane->GetOutput(), balls);
  report.Check(balls.Inner == 0.0 && std::isinf(balls.Outer), "a plane has balls");
  return report.GetExitStatus();
}
