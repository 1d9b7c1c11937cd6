// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/Meshes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace vtkOITTest
{
namespace
{
const double Pi = std::acos(-1.0);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakePolyData(const Mesh& mesh)
{
  vtkNew<vtkPoints> points;
  for (const glm::vec3& point : mesh.Points)
  {
    points->InsertNextPoint(point.x, point.y, point.z);
  }
  vtkNew<vtkCellArray> triangles;
  for (const std::array<int, 3>& corners : mesh.Triangles)
  {
    triangles->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  auto polydata = vtkSmartPointer<vtkPolyData>::New();
  polydata->SetPoints(points);
  polydata->SetPolys(triangles);
  return polydata;
}

//------------------------------------------------------------------------------
Mesh MakeSphere(const glm::dvec3& center, double radius, int rings, const glm::vec4& color)
{
  Mesh mesh;
  mesh.Color = color;
  const int sides = 2 * rings;
  const auto add = [&](const glm::dvec3& direction)
  { mesh.Points.emplace_back(center + radius * direction); };
  add({ 0.0, 0.0, 1.0 });
  for (int ring = 0; ring < rings; ++ring)
  {
    const double polar = Pi * (ring + 1) / (rings + 1);
    for (int side = 0; side < sides; ++side)
    {
      const double azimuth = 2.0 * Pi * side / sides;
      add({ std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
        std::cos(polar) });
    }
  }
  add({ 0.0, 0.0, -1.0 });
  const int last = static_cast<int>(mesh.Points.size()) - 1;
  for (int side = 0; side < sides; ++side)
  {
    const int next = (side + 1) % sides;
    mesh.Triangles.push_back({ 0, 1 + side, 1 + next });
    mesh.Triangles.push_back({ last, last - sides + next, last - sides + side });
    for (int ring = 0; ring + 1 < rings; ++ring)
    {
      const int upper = 1 + ring * sides;
      const int lower = upper + sides;
      mesh.Triangles.push_back({ upper + side, lower + side, lower + next });
      mesh.Triangles.push_back({ upper + side, lower + next, upper + next });
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
Mesh MakeTube(const std::function<glm::dvec3(double)>& curve, double radius, int segments,
  int sides, const glm::vec4& color)
{
  Mesh mesh;
  mesh.Color = color;
  for (int i = 0; i < segments; ++i)
  {
    const double t = double(i) / segments;
    const glm::dvec3 center = curve(t);
    const glm::dvec3 tangent = glm::normalize(curve(t + 1e-4) - curve(t - 1e-4));
    // Any frame that goes on smoothly, also from the end to the start.
    const glm::dvec3 normal = glm::normalize(glm::cross(tangent, glm::cross(center, tangent)));
    const glm::dvec3 binormal = glm::cross(tangent, normal);
    for (int j = 0; j < sides; ++j)
    {
      const double angle = 2.0 * Pi * j / sides;
      mesh.Points.emplace_back(
        center + radius * (std::cos(angle) * normal + std::sin(angle) * binormal));
    }
  }
  for (int i = 0; i < segments; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const int a = i * sides + j;
      const int b = i * sides + (j + 1) % sides;
      const int c = (i + 1) % segments * sides + j;
      const int d = (i + 1) % segments * sides + (j + 1) % sides;
      mesh.Triangles.push_back({ a, b, d });
      mesh.Triangles.push_back({ a, d, c });
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
Mesh MakeTorus(const glm::vec4& color)
{
  return MakeTube([](double t)
    { return 0.6 * glm::dvec3(std::cos(2.0 * Pi * t), std::sin(2.0 * Pi * t), 0.0); },
    0.25, 24, 14, color);
}

//------------------------------------------------------------------------------
Mesh MakeKnot(const glm::vec4& color)
{
  return MakeTube(
    [](double t)
    {
      const double angle = 4.0 * Pi * t;
      const double distance = 0.5 + 0.2 * std::cos(6.0 * Pi * t);
      return glm::dvec3(
        distance * std::cos(angle), distance * std::sin(angle), 0.25 * std::sin(6.0 * Pi * t));
    },
    0.09, 90, 10, color);
}

//------------------------------------------------------------------------------
std::vector<Mesh> MakeSoup(Random& random, int count, double extent)
{
  std::vector<Mesh> soup;
  for (int i = 0; i < count; ++i)
  {
    Mesh mesh;
    for (int corner = 0; corner < 3; ++corner)
    {
      const double x = random.Uniform();
      const double y = random.Uniform();
      const double z = random.Uniform();
      mesh.Points.emplace_back(extent * (2.0 * glm::dvec3(x, y, z) - 1.0));
    }
    mesh.Triangles.push_back({ 0, 1, 2 });
    const double r = random.Uniform();
    const double g = random.Uniform();
    mesh.Color = { r, g, 1.0 - r, 0.1 + 0.7 * random.Uniform() };
    soup.push_back(mesh);
  }
  return soup;
}

//------------------------------------------------------------------------------
void Rotate(Mesh& mesh, const glm::dvec3& axis, double degrees)
{
  const glm::dvec3 n = glm::normalize(axis);
  const double c = std::cos(degrees * Pi / 180.0);
  const double s = std::sin(degrees * Pi / 180.0);
  for (glm::vec3& point : mesh.Points)
  {
    const glm::dvec3 p(point);
    point = glm::vec3(c * p + s * glm::cross(n, p) + (1.0 - c) * glm::dot(n, p) * n);
  }
}
}
