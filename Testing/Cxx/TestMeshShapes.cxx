// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// What the automatic pass proves of meshes: flat and convex, closed and convex, and nothing of what
// only looks like it.

#include "Rig/Report.h"
#include "Scenes/ShapeMeshes.h"

#include "Private/Auto/vtkOITMeshShape.h"
#include "vtkVersionMacros.h"

#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkDiskSource.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPolyData.h"
#include "vtkRegularPolygonSource.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace vtkOITTest;

namespace
{
using Shape = vtkOITMeshShape;

const double Pi = std::acos(-1.0);

class Checker
{
public:
  explicit Checker(Report& report)
    : TheReport(report)
  {
  }

  void Check(const std::string& what, vtkPolyData* mesh, Shape expected)
  {
    const Shape found = vtkOITFindMeshShape(mesh);
    this->TheReport.Check(
      found == expected, what + " is " + Name(found) + ", expected " + Name(expected));
  }

  template <typename Source>
  void CheckSource(const std::string& what, Source* source, Shape expected)
  {
    source->Update();
    this->Check(what, source->GetOutput(), expected);
  }

private:
  static std::string Name(Shape shape)
  {
    switch (shape)
    {
      case Shape::FlatConvex:
        return "flat and convex";
      case Shape::ClosedConvex:
        return "closed and convex";
      case Shape::ClosedConvexInside:
        return "closed, convex and inside out";
      default:
        return "unknown";
    }
  }

  Report& TheReport;
};

void CheckClosed(Checker& checker)
{
  vtkNew<vtkCubeSource> cube;
  checker.CheckSource("cube", cube.Get(), Shape::ClosedConvex);
  checker.Check("cube of shared points", MakeCubes({ { 0, 0, 0 } }), Shape::ClosedConvex);
  for (const int resolution : { 3, 16, 61, 200 })
  {
    const std::string with = " with resolution " + std::to_string(resolution);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(resolution);
    sphere->SetPhiResolution(resolution);
    checker.CheckSource("sphere" + with, sphere.Get(), Shape::ClosedConvex);
    checker.Check("turned sphere" + with, Transform(sphere->GetOutput(), 0.1, 0.2, 0.3, true),
      Shape::ClosedConvex);
    vtkNew<vtkCylinderSource> cylinder;
    cylinder->SetResolution(resolution);
    checker.CheckSource("cylinder" + with, cylinder.Get(), Shape::ClosedConvex);
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(resolution);
    checker.CheckSource("cone" + with, cone.Get(), Shape::ClosedConvex);
    checker.Check(
      "turned cone" + with, Transform(cone->GetOutput(), 0, 0, 0, true), Shape::ClosedConvex);
  }
  for (int solid = 0; solid < 5; ++solid)
  {
    vtkNew<vtkPlatonicSolidSource> platonic;
    platonic->SetSolidType(solid);
    // VTK's tetrahedron and icosahedron were inside out before 9.6.
    const bool isInsideOut =
      VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 6, 0) && (solid == 0 || solid == 3);
    checker.CheckSource("platonic solid " + std::to_string(solid), platonic.Get(),
      isInsideOut ? Shape::ClosedConvexInside : Shape::ClosedConvex);
  }
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputConnection(cube->GetOutputPort());
  reverse->ReverseCellsOn();
  checker.CheckSource("cube inside out", reverse.Get(), Shape::ClosedConvexInside);
  checker.Check("tetrahedron",
    MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
      { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } }),
    Shape::ClosedConvex);
  checker.Check("cube with a bump", MakeCubeWithBump(20, 0.1), Shape::ClosedConvex);
  checker.Check("cube with a grid", MakeCubeWithBump(20, 0.0), Shape::ClosedConvex);

  // Corners that are named twice cover no pixel.
  std::vector<Corners> faces = CubeFaces;
  faces[0] = { 0, 3, 3, 2, 1 };
  faces.push_back({ 0, 0, 1 });
  checker.Check("cube with empty triangles", MakeMesh(CubePoints, faces), Shape::ClosedConvex);
}

void CheckNotClosed(Checker& checker)
{
  checker.Check("torus", MakeTorus(24, 16), Shape::Unknown);
  checker.Check("coarse torus", MakeTorus(3, 3), Shape::Unknown);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(24);
  sphere->Update();
  for (const double factor : { 0.8, 0.99 })
  {
    MeshPointer dented = MeshPointer::New();
    dented->DeepCopy(sphere->GetOutput());
    glm::dvec3 p;
    dented->GetPoint(200, &p.x);
    dented->GetPoints()->SetPoint(200, factor * p.x, factor * p.y, factor * p.z);
    checker.Check("sphere with a dent to " + std::to_string(factor), dented, Shape::Unknown);
  }
  checker.Check("two cubes", MakeCubes({ { 0, 0, 0 }, { 3, 0, 0 } }), Shape::Unknown);
  checker.Check("nested cubes", MakeCubes({ { 0, 0, 0 }, { 0.1, 0.1, 0.1 } }), Shape::Unknown);
  checker.Check("cubes that share a face", MakeCubes({ { 0, 0, 0 }, { 1, 0, 0 } }), Shape::Unknown);
  checker.Check(
    "cubes that share an edge", MakeCubes({ { 0, 0, 0 }, { 1, 1, 0 } }), Shape::Unknown);
  checker.Check(
    "cubes that share a corner", MakeCubes({ { 0, 0, 0 }, { 1, 1, 1 } }), Shape::Unknown);
  sphere->SetEndTheta(270.0);
  checker.CheckSource("open sphere", sphere.Get(), Shape::Unknown);
  sphere->SetEndTheta(360.0);
  sphere->SetEndPhi(90.0);
  checker.CheckSource("half a sphere", sphere.Get(), Shape::Unknown);
  vtkNew<vtkCylinderSource> tube;
  tube->CappingOff();
  checker.CheckSource("cylinder without caps", tube.Get(), Shape::Unknown);

  std::vector<Corners> faces = CubeFaces;
  faces[3] = { 5, 6, 2, 1 };
  checker.Check("cube with a flipped face", MakeMesh(CubePoints, faces), Shape::Unknown);
  faces = CubeFaces;
  faces.push_back(faces[2]);
  checker.Check("cube with a face twice", MakeMesh(CubePoints, faces), Shape::Unknown);
  faces.back() = { 4, 5, 1, 0 };
  checker.Check("cube with a face from both sides", MakeMesh(CubePoints, faces), Shape::Unknown);
  faces = CubeFaces;
  faces.pop_back();
  checker.Check("cube without a face", MakeMesh(CubePoints, faces), Shape::Unknown);
  checker.Check("both sides of a triangle",
    MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 1 } }),
    Shape::Unknown);
  std::vector<glm::dvec3> points = CubePoints;
  points[6] = { 0.3, 0.3, 0.3 };
  checker.Check("cube with a corner pushed in", MakeMesh(points, CubeFaces), Shape::Unknown);
  points[6].z = std::numeric_limits<double>::quiet_NaN();
  checker.Check(
    "cube with a corner that is not a number", MakeMesh(points, CubeFaces), Shape::Unknown);
  points[6].z = std::numeric_limits<double>::infinity();
  checker.Check("cube with a corner at infinity", MakeMesh(points, CubeFaces), Shape::Unknown);

  // A valley from b to d; then with its two sides joined by a triangle without area, so that
  // neither side sees the other one.
  points = { { 1, 0, 0.1 }, { 0, 1, 0 }, { -1, 0, 0.1 }, { 0, -1, 0 }, { 0, 0, -2 } };
  const std::vector<Corners> below{ { 4, 1, 0 }, { 4, 2, 1 }, { 4, 3, 2 }, { 4, 0, 3 } };
  faces = below;
  faces.insert(faces.end(), { { 0, 1, 3 }, { 1, 2, 3 } });
  checker.Check("valley", MakeMesh(points, faces), Shape::Unknown);
  points.emplace_back(0, 0, 0);
  faces = below;
  faces.insert(faces.end(), { { 0, 1, 3 }, { 3, 1, 5 }, { 1, 2, 5 }, { 5, 2, 3 } });
  checker.Check("valley with a triangle without area", MakeMesh(points, faces), Shape::Unknown);
  points.back() = { 0, 0, -1e-9 };
  checker.Check("valley with a sliver", MakeMesh(points, faces), Shape::Unknown);
  points.back() = { 1e-9, 0, 1e-9 };
  checker.Check("valley with a folded sliver", MakeMesh(points, faces), Shape::Unknown);

  // Each edge of fine meshes is straight within the tolerance, but all of them together are not.
  checker.Check("cube with a bowl", MakeCubeWithBowl(20, 0.1), Shape::Unknown);
  checker.Check("cube with a shallow bowl", MakeCubeWithBowl(200, 0.0009), Shape::Unknown);
  checker.Check("hollow block", MakeHollowBlock(10, 0.1), Shape::Unknown);
  checker.Check("hollow block of 4000 strips", MakeHollowBlock(4000, 0.1), Shape::Unknown);
}

void CheckFlat(Checker& checker)
{
  vtkNew<vtkPlaneSource> plane;
  checker.CheckSource("plane", plane.Get(), Shape::FlatConvex);
  plane->SetResolution(30, 20);
  checker.CheckSource("grid", plane.Get(), Shape::FlatConvex);
  checker.Check(
    "turned grid", Transform(plane->GetOutput(), 0.3, 0.1, 0.2, true), Shape::FlatConvex);
  vtkNew<vtkRegularPolygonSource> polygon;
  polygon->GeneratePolylineOff();
  for (const int sides : { 3, 6, 100, 1000 })
  {
    polygon->SetNumberOfSides(sides);
    checker.CheckSource(std::to_string(sides) + " corners", polygon.Get(), Shape::FlatConvex);
  }
  vtkNew<vtkDiskSource> disc;
  disc->SetInnerRadius(0.0);
  disc->SetCircumferentialResolution(40);
  disc->SetRadialResolution(4);
  checker.CheckSource("disc", disc.Get(), Shape::FlatConvex);
  checker.Check("corners on a side", MakeFlat({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } }),
    Shape::FlatConvex);

  vtkNew<vtkDiskSource> ring;
  checker.CheckSource("ring", ring.Get(), Shape::Unknown);
  checker.Check(
    "L", MakeFlat({ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } }), Shape::Unknown);
  checker.Check("arrow", MakeFlat({ { 0, 0 }, { 1, -1 }, { 0, 2 }, { -1, -1 } }), Shape::Unknown);
  checker.Check("bow tie", MakeFlat({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }), Shape::Unknown);
  checker.Check("line", MakeFlat({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 } }), Shape::Unknown);
  checker.Check("point", MakeFlat({ { 1, 0 }, { 1, 0 }, { 1, 0 } }), Shape::Unknown);

  // Around twice: as an outline, and around a point inside, where no edge is used twice.
  std::vector<glm::dvec2> star;
  std::vector<glm::dvec3> points;
  std::vector<Corners> fan;
  for (int i = 0; i < 9; ++i)
  {
    const double angle = 4.0 * Pi * i / 9;
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    fan.push_back({ 9, i, (i + 1) % 9 });
    if (i < 5)
    {
      star.emplace_back(std::cos(4.0 * Pi * i / 5), std::sin(4.0 * Pi * i / 5));
    }
  }
  points.emplace_back(0.0, 0.0, 0.0);
  checker.Check("pentagram", MakeFlat(star), Shape::Unknown);
  checker.Check("fan that goes around twice", MakeMesh(points, fan), Shape::Unknown);

  points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  checker.Check("triangle twice", MakeMesh(points, { { 0, 1, 2 }, { 0, 1, 2 } }), Shape::Unknown);
  checker.Check(
    "one triangle flipped", MakeMesh(points, { { 0, 1, 2 }, { 0, 3, 2 } }), Shape::Unknown);
  checker.Check(
    "two triangles that cross", MakeMesh(points, { { 0, 1, 2 }, { 0, 1, 3 } }), Shape::Unknown);
  points[3].z = 1e-3;
  checker.Check("bent quad", MakeMesh(points, { { 0, 1, 2, 3 } }), Shape::Unknown);
  points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } };
  checker.Check(
    "two triangles at one corner", MakeMesh(points, { { 0, 1, 2 }, { 0, 3, 4 } }), Shape::Unknown);
  checker.Check("nothing", MakeMesh({}, {}), Shape::Unknown);
}

void CheckFarAway(Checker& checker)
{
  constexpr double far = 1e6; // where floats are 1/16 apart
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(far, far, far);
  cube->SetXLength(64.0);
  cube->SetYLength(64.0);
  cube->SetZLength(64.0);
  checker.CheckSource("cube far away", cube.Get(), Shape::ClosedConvex);
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(8, 8);
  plane->SetCenter(far, far, far);
  checker.CheckSource("grid far away", plane.Get(), Shape::FlatConvex);
  for (const double size : { 1.0, 30.0, 1000.0 })
  {
    checker.Check(
      "torus far away", Transform(MakeTorus(12, 12), far / size, 0, 0, false), Shape::Unknown);
  }
  MeshPointer torus = MakeTorus(12, 12);
  checker.Check("torus far away", Transform(torus, far, far, far, false), Shape::Unknown);
  checker.Check(
    "bowl far away", Transform(MakeCubeWithBowl(8, 0.2), far, far, far, false), Shape::Unknown);
}
}

int TestMeshShapes(int, char*[])
{
  Report report;
  report.SetContext("mesh shapes");
  Checker checker(report);
  CheckClosed(checker);
  CheckNotClosed(checker);
  CheckFlat(checker);
  CheckFarAway(checker);
  return report.GetExitStatus();
}
