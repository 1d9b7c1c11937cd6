// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITMeshShape.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace
{
constexpr int None = -1;

/// Triangles whose planes are compared with all corners.
constexpr int NumberOfPlanes = 200;

/// Triangles as half-edges: half-edge 3 t + i goes from corner i of triangle t to the next one.
class Mesh
{
public:
  explicit Mesh(vtkPolyData* polydata);

  /// Step 1. False when an edge is used twice in one direction, or there are several parts.
  bool Connect();
  bool IsClosed() const { return this->OpenEdges.empty(); }
  vtkOITMeshShape FindClosedShape() const;
  vtkOITMeshShape FindFlatShape() const;
  vtkOITMeshBalls FindBalls(bool isOutward) const; // of closed convex ones

private:
  int GetNumberOfEdges() const { return static_cast<int>(this->Corners.size()); }
  static int Next(int edge) { return edge % 3 == 2 ? edge - 2 : edge + 1; }
  static int Previous(int edge) { return edge % 3 == 0 ? edge + 2 : edge - 1; }
  const glm::dvec3& From(int edge) const { return this->Points[this->Corners[edge]]; }
  glm::dvec3 GetNormal(int edge) const; // of its triangle, not normalized
  bool IsConnected() const;
  bool HasOneFanAtEachVertex() const;
  bool HasVertexAnglesOfConvexBody() const;
  bool IsBehindItsPlanes(bool isOutward) const;

  std::vector<glm::dvec3> Points; // each once
  std::vector<int> Corners;       // where each half-edge starts
  std::vector<int> Twins;         // the half-edge in the other direction, or None
  std::vector<int> OpenEdges;     // those without a twin
  double Tolerance = 0.0;
};

struct PointHash
{
  std::size_t operator()(const std::array<double, 3>& p) const
  {
    const std::hash<double> hash;
    return hash(p[0]) * 73856093u ^ hash(p[1]) * 19349663u ^ hash(p[2]) * 83492791u;
  }
};

Mesh::Mesh(vtkPolyData* polydata)
{
  std::unordered_map<std::array<double, 3>, int, PointHash> indices;
  double largest = 0.0;
  const auto add = [&](vtkIdType id)
  {
    std::array<double, 3> point{};
    polydata->GetPoint(id, point.data());
    const auto added = indices.emplace(point, static_cast<int>(this->Points.size()));
    if (added.second)
    {
      this->Points.emplace_back(point[0], point[1], point[2]);
      largest = std::max({ largest, std::abs(point[0]), std::abs(point[1]), std::abs(point[2]) });
    }
    return added.first->second;
  };
  const auto polys = vtk::TakeSmartPointer(polydata->GetPolys()->NewIterator());
  for (polys->GoToFirstCell(); !polys->IsDoneWithTraversal(); polys->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    polys->GetCurrentCell(size, ids);
    std::vector<int> polygon;
    for (vtkIdType i = 0; i < size; ++i)
    {
      polygon.push_back(add(ids[i]));
    }
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      const std::array<int, 3> t{ polygon[0], polygon[i - 1], polygon[i] };
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) // others cover no pixel
      {
        this->Corners.insert(this->Corners.end(), t.begin(), t.end());
      }
    }
  }
  this->Tolerance = 4e-7 * largest;
}

//------------------------------------------------------------------------------
glm::dvec3 Mesh::GetNormal(int edge) const
{
  const int first = edge / 3 * 3;
  return glm::cross(
    this->From(first + 1) - this->From(first), this->From(first + 2) - this->From(first));
}

//------------------------------------------------------------------------------
bool Mesh::Connect()
{
  if (this->Corners.empty())
  {
    return false;
  }
  std::unordered_map<std::uint64_t, int> edges;
  const auto key = [](int from, int to)
  { return static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint32_t>(to); };
  for (int e = 0; e < this->GetNumberOfEdges(); ++e)
  {
    if (!edges.emplace(key(this->Corners[e], this->Corners[Next(e)]), e).second)
    {
      return false;
    }
  }
  for (int e = 0; e < this->GetNumberOfEdges(); ++e)
  {
    const auto twin = edges.find(key(this->Corners[Next(e)], this->Corners[e]));
    this->Twins.push_back(twin == edges.end() ? None : twin->second);
    if (this->Twins.back() == None)
    {
      this->OpenEdges.push_back(e);
    }
  }
  return this->IsConnected();
}

//------------------------------------------------------------------------------
bool Mesh::IsConnected() const
{
  std::vector<bool> isReached(this->Corners.size() / 3, false);
  std::vector<int> waiting{ 0 };
  isReached[0] = true;
  std::size_t reached = 1;
  while (!waiting.empty())
  {
    const int triangle = waiting.back();
    waiting.pop_back();
    for (int e = 3 * triangle; e < 3 * triangle + 3; ++e)
    {
      const int twin = this->Twins[e];
      if (twin != None && !isReached[twin / 3])
      {
        isReached[twin / 3] = true;
        ++reached;
        waiting.push_back(twin / 3);
      }
    }
  }
  return reached == isReached.size();
}

//------------------------------------------------------------------------------
// Closed meshes: going from corner to corner around a vertex passes all of its corners.
bool Mesh::HasOneFanAtEachVertex() const
{
  std::vector<bool> isSeen(this->Corners.size(), false);
  std::size_t fans = 0;
  for (int start = 0; start < this->GetNumberOfEdges(); ++start)
  {
    fans += isSeen[start] ? 0 : 1;
    for (int e = start; !isSeen[e]; e = this->Twins[Previous(e)])
    {
      isSeen[e] = true;
    }
  }
  std::vector<bool> isUsed(this->Points.size(), false);
  for (const int corner : this->Corners)
  {
    isUsed[corner] = true;
  }
  const auto vertices = static_cast<std::size_t>(std::count(isUsed.begin(), isUsed.end(), true));
  const std::size_t triangles = this->Corners.size() / 3;
  return fans == vertices && vertices + triangles == this->Corners.size() / 2 + 2; // V - E + F = 2
}

//------------------------------------------------------------------------------
bool Mesh::HasVertexAnglesOfConvexBody() const
{
  std::vector<double> angles(this->Points.size(), 0.0);
  for (int e = 0; e < this->GetNumberOfEdges(); ++e)
  {
    const glm::dvec3 a = glm::normalize(this->From(Next(e)) - this->From(e));
    const glm::dvec3 b = glm::normalize(this->From(Previous(e)) - this->From(e));
    angles[this->Corners[e]] += std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
  }
  constexpr double most = glm::two_pi<double>() + 1e-3;
  return std::all_of(angles.begin(), angles.end(), [](double angle) { return angle < most; });
}

//------------------------------------------------------------------------------
// Each edge of a fine mesh can be straight within the tolerance and the whole not be convex.
bool Mesh::IsBehindItsPlanes(bool isOutward) const
{
  const int triangles = this->GetNumberOfEdges() / 3;
  const int step = std::max(1, triangles / NumberOfPlanes);
  for (int e = 0; e < this->GetNumberOfEdges(); e += 3 * step)
  {
    const glm::dvec3 normal = this->GetNormal(e);
    const double length = glm::length(normal);
    double longest = 0.0;
    for (const int side : { e, e + 1, e + 2 })
    {
      longest = std::max(longest, glm::distance(this->From(side), this->From(Next(side))));
    }
    const glm::dvec3 outward = (isOutward ? normal : -normal) / length;
    const double slack = this->Tolerance * longest / length; // of the normal's direction
    for (const glm::dvec3& point : this->Points)
    {
      const glm::dvec3 reach = point - this->From(e);
      if (glm::dot(reach, outward) > this->Tolerance + slack * glm::length(reach))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkOITMeshShape Mesh::FindClosedShape() const
{
  double highest = 0.0; // of the neighbours' corners over the planes of triangles
  double lowest = 0.0;
  for (int e = 0; e < this->GetNumberOfEdges(); ++e)
  {
    const int twin = this->Twins[e];
    const glm::dvec3 normal = this->GetNormal(e);
    const glm::dvec3 edge = this->From(Next(e)) - this->From(e);
    const double length = glm::length(normal);
    // The neighbours of a triangle that is but a line do not see each other across it.
    if (!(length > 10.0 * this->Tolerance * glm::length(edge)))
    {
      return vtkOITMeshShape::Unknown;
    }
    const double height = glm::dot(this->From(Previous(twin)) - this->From(e), normal) / length;
    if (std::abs(height) <= this->Tolerance && glm::dot(normal, this->GetNormal(twin)) < 0.0)
    {
      return vtkOITMeshShape::Unknown; // folded back
    }
    highest = std::max(highest, height);
    lowest = std::min(lowest, height);
  }
  const bool isOutward = highest <= this->Tolerance && lowest < -10.0 * this->Tolerance;
  const bool isInward = lowest >= -this->Tolerance && highest > 10.0 * this->Tolerance;
  if ((!isOutward && !isInward) || !this->HasOneFanAtEachVertex() ||
    !this->HasVertexAnglesOfConvexBody() || !this->IsBehindItsPlanes(isOutward))
  {
    return vtkOITMeshShape::Unknown;
  }
  return isOutward ? vtkOITMeshShape::ClosedConvex : vtkOITMeshShape::ClosedConvexInside;
}

//------------------------------------------------------------------------------
// No triangle is nearer than its plane. Around the mean of the corners, which is inside.
vtkOITMeshBalls Mesh::FindBalls(bool isOutward) const
{
  glm::dvec3 center(0.0);
  for (const glm::dvec3& point : this->Points)
  {
    center += point / static_cast<double>(this->Points.size());
  }
  vtkOITMeshBalls balls;
  balls.Center = { center.x, center.y, center.z };
  balls.Outer = 0.0;
  for (const glm::dvec3& point : this->Points)
  {
    balls.Outer = std::max(balls.Outer, glm::distance(point, center));
  }
  balls.Inner = balls.Outer;
  for (int e = 0; e < this->GetNumberOfEdges(); e += 3)
  {
    const glm::dvec3 normal = glm::normalize(this->GetNormal(e));
    const double depth = glm::dot(this->From(e) - center, isOutward ? normal : -normal);
    balls.Inner = std::min(balls.Inner, depth);
  }
  balls.Inner = std::max(0.0, balls.Inner - this->Tolerance);
  balls.Outer += this->Tolerance;
  return balls;
}

//------------------------------------------------------------------------------
vtkOITMeshShape Mesh::FindFlatShape() const
{
  glm::dvec3 normal(0.0); // the mean: that of one small triangle is not exact enough far from it
  for (int e = 0; e < this->GetNumberOfEdges(); e += 3)
  {
    normal += this->GetNormal(e);
  }
  if (!(glm::length(normal) > 0.0))
  {
    return vtkOITMeshShape::Unknown;
  }
  normal = glm::normalize(normal);
  const glm::dvec3& origin = this->From(0);
  std::vector<int> next(this->Points.size(), None); // along the outline
  bool isFlat = true;
  for (int e = 0; e < this->GetNumberOfEdges(); ++e)
  {
    isFlat = isFlat && glm::dot(this->GetNormal(e), normal) >= 0.0 &&
      std::abs(glm::dot(this->From(e) - origin, normal)) <= this->Tolerance;
  }
  for (const int e : this->OpenEdges)
  {
    isFlat = isFlat && next[this->Corners[e]] == None;
    next[this->Corners[e]] = this->Corners[Next(e)];
  }
  if (!isFlat)
  {
    return vtkOITMeshShape::Unknown;
  }

  const int first = this->Corners[this->OpenEdges.front()];
  std::size_t count = 0;
  double turning = 0.0;
  for (int a = first; count < this->OpenEdges.size(); a = next[a])
  {
    const int b = next[a];
    const int c = b == None ? None : next[b];
    if (c == None || (count > 0 && a == first))
    {
      return vtkOITMeshShape::Unknown; // several outlines
    }
    const glm::dvec3 ab = this->Points[b] - this->Points[a];
    const glm::dvec3 bc = this->Points[c] - this->Points[b];
    const double sine = glm::dot(glm::cross(ab, bc), normal);
    if (sine < -this->Tolerance * std::max(glm::length(ab), glm::length(bc)))
    {
      return vtkOITMeshShape::Unknown;
    }
    turning += std::atan2(std::max(sine, 0.0), glm::dot(ab, bc));
    ++count;
  }
  return std::abs(turning - glm::two_pi<double>()) < 0.1 ? vtkOITMeshShape::FlatConvex
                                                         : vtkOITMeshShape::Unknown;
}
}

//------------------------------------------------------------------------------
vtkOITMeshShape vtkOITFindMeshShape(vtkPolyData* polydata)
{
  vtkOITMeshBalls balls;
  return vtkOITFindMeshShape(polydata, balls);
}

//------------------------------------------------------------------------------
vtkOITMeshShape vtkOITFindMeshShape(vtkPolyData* polydata, vtkOITMeshBalls& balls)
{
  balls = {};
  if (polydata->GetNumberOfPolys() == 0)
  {
    return vtkOITMeshShape::Unknown;
  }
  Mesh mesh(polydata);
  if (!mesh.Connect())
  {
    return vtkOITMeshShape::Unknown;
  }
  if (!mesh.IsClosed())
  {
    return mesh.FindFlatShape();
  }
  const vtkOITMeshShape shape = mesh.FindClosedShape();
  if (shape != vtkOITMeshShape::Unknown)
  {
    balls = mesh.FindBalls(shape == vtkOITMeshShape::ClosedConvex);
  }
  return shape;
}
