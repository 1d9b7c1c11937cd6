// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/ShapeMeshes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <cmath>

namespace vtkOITTest
{
namespace
{
const double Pi = std::acos(-1.0);
}

const std::vector<glm::dvec3> CubePoints{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
  { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
const std::vector<Corners> CubeFaces{ { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
  { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };

//------------------------------------------------------------------------------
MeshPointer MakeMesh(const std::vector<glm::dvec3>& points, const std::vector<Corners>& polygons)
{
  vtkNew<vtkPoints> meshPoints;
  meshPoints->SetDataTypeToDouble();
  for (const glm::dvec3& p : points)
  {
    meshPoints->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> cells;
  for (const Corners& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto mesh = MeshPointer::New();
  mesh->SetPoints(meshPoints);
  mesh->SetPolys(cells);
  return mesh;
}

//------------------------------------------------------------------------------
MeshPointer MakeFlat(const std::vector<glm::dvec2>& outline)
{
  std::vector<glm::dvec3> points;
  Corners polygon;
  for (const glm::dvec2& p : outline)
  {
    polygon.push_back(static_cast<vtkIdType>(points.size()));
    points.emplace_back(p.x, p.y, 0.25);
  }
  return MakeMesh(points, { polygon });
}

//------------------------------------------------------------------------------
MeshPointer MakeTorus(int nu, int nv)
{
  std::vector<glm::dvec3> points;
  std::vector<Corners> quads;
  for (int u = 0; u < nu; ++u)
  {
    for (int v = 0; v < nv; ++v)
    {
      const double a = 2.0 * Pi * u / nu;
      const double b = 2.0 * Pi * v / nv;
      points.emplace_back((1.0 + 0.4 * std::cos(b)) * std::cos(a),
        (1.0 + 0.4 * std::cos(b)) * std::sin(a), 0.4 * std::sin(b));
      const auto at = [nu, nv](int i, int j) { return vtkIdType(i % nu) * nv + j % nv; };
      quads.push_back({ at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1) });
    }
  }
  return MakeMesh(points, quads);
}

//------------------------------------------------------------------------------
MeshPointer MakeCubes(const std::vector<glm::dvec3>& offsets)
{
  std::vector<glm::dvec3> points;
  std::vector<Corners> faces;
  for (const glm::dvec3& offset : offsets)
  {
    const auto first = static_cast<vtkIdType>(points.size());
    for (const glm::dvec3& p : CubePoints)
    {
      points.push_back(p + offset);
    }
    for (Corners face : CubeFaces)
    {
      for (vtkIdType& corner : face)
      {
        corner += first;
      }
      faces.push_back(face);
    }
  }
  return MakeMesh(points, faces);
}

//------------------------------------------------------------------------------
MeshPointer MakeCubeWithTop(int count, const std::function<double(double, double)>& getHeight)
{
  std::vector<glm::dvec3> points;
  std::vector<Corners> faces;
  const auto at = [count](int i, int j) { return vtkIdType(j) * (count + 1) + i; };
  for (int j = 0; j <= count; ++j)
  {
    for (int i = 0; i <= count; ++i)
    {
      const double x = 2.0 * i / count - 1.0;
      const double y = 2.0 * j / count - 1.0;
      points.emplace_back(x, y, getHeight(x, y));
      if (i < count && j < count)
      {
        faces.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
        faces.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
      }
    }
  }
  // A wall below each side of the grid, each one polygon, and the floor.
  const auto bottom = static_cast<vtkIdType>(points.size());
  points.insert(points.end(), { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 } });
  Corners walls[4] = { { bottom, bottom + 1 }, { bottom + 1, bottom + 2 },
    { bottom + 2, bottom + 3 }, { bottom + 3, bottom } };
  for (int i = count; i >= 0; --i)
  {
    walls[0].push_back(at(i, 0));
    walls[1].push_back(at(count, i));
    walls[2].push_back(at(count - i, count));
    walls[3].push_back(at(0, count - i));
  }
  faces.insert(faces.end(), std::begin(walls), std::end(walls));
  faces.push_back({ bottom + 3, bottom + 2, bottom + 1, bottom });
  return MakeMesh(points, faces);
}

//------------------------------------------------------------------------------
MeshPointer MakeCubeWithBowl(int count, double depth)
{
  return MakeCubeWithTop(
    count, [depth](double x, double y) { return 1.0 - depth * (1.0 - x * x) * (1.0 - y * y); });
}

//------------------------------------------------------------------------------
MeshPointer MakeCubeWithBump(int count, double height)
{
  return MakeCubeWithTop(
    count, [height](double x, double y) { return 1.0 + height * (2.0 - x * x - y * y); });
}

//------------------------------------------------------------------------------
MeshPointer MakeHollowBlock(int count, double depth)
{
  std::vector<glm::dvec3> points;
  std::vector<Corners> faces;
  Corners bottom;
  Corners top;
  const auto add = [&](double x, double y)
  {
    for (const double z : { -1.0, 1.0 })
    {
      (z < 0.0 ? bottom : top).push_back(static_cast<vtkIdType>(points.size()));
      points.emplace_back(x, y, z);
    }
  };
  add(1.0, -1.0);
  for (int i = 0; i <= count; ++i)
  {
    const double x = 1.0 - 2.0 * i / count;
    add(x, 1.0 - depth * (1.0 - x * x));
  }
  add(-1.0, -1.0);
  for (std::size_t i = 0; i < top.size(); ++i)
  {
    const std::size_t next = (i + 1) % top.size();
    faces.push_back({ bottom[i], bottom[next], top[next], top[i] });
  }
  faces.push_back(top);
  faces.emplace_back(bottom.rbegin(), bottom.rend());
  return MakeMesh(points, faces);
}

//------------------------------------------------------------------------------
MeshPointer Transform(vtkPolyData* mesh, double x, double y, double z, bool turn)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(x, y, z);
  if (turn)
  {
    transform->RotateWXYZ(37.0, 1.0, 2.0, 3.0);
  }
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}
}
