// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Oracle/RayCaster.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace vtkOITTest
{
namespace
{
using Key = std::tuple<double, double, double>;

Key MakeKey(const glm::dvec3& point)
{
  return Key(point.x, point.y, point.z);
}

using Edge = std::pair<Key, Key>;

/// The same for both directions of an edge.
Edge MakeEdge(const glm::dvec3& a, const glm::dvec3& b)
{
  return MakeKey(a) < MakeKey(b) ? Edge(MakeKey(a), MakeKey(b)) : Edge(MakeKey(b), MakeKey(a));
}

/// The triple product direction . (a x b): on which side of the line from a to b the ray passes.
/// The two triangles at an edge get the same number with opposite signs, to the bit.
double Side(
  const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& a, const glm::dvec3& b)
{
  if (MakeKey(b) < MakeKey(a))
  {
    return -Side(origin, direction, b, a);
  }
  return glm::dot(direction, glm::cross(a - origin, b - origin));
}

double DistanceToSegment(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b)
{
  const glm::dvec2 edge = b - a;
  const double squared = glm::dot(edge, edge);
  const double t = squared > 0.0 ? glm::dot(point - a, edge) / squared : 0.0;
  return glm::length(point - a - std::min(std::max(t, 0.0), 1.0) * edge);
}
}

//------------------------------------------------------------------------------
RayCaster::RayCaster(const CastCamera& camera, int width, int height)
  : Camera(camera)
  , Forward(glm::normalize(camera.FocalPoint - camera.Position))
  , Right(glm::normalize(glm::cross(Forward, camera.ViewUp)))
  , Up(glm::cross(Right, Forward))
  , Width(width)
  , Height(height)
{
}

//------------------------------------------------------------------------------
RayCaster::Ray RayCaster::MakeRay(double x, double y) const
{
  // In units of half of the height of the viewport.
  const glm::dvec3 offset =
    ((2.0 * x - this->Width) * this->Right + (2.0 * y - this->Height) * this->Up) /
    double(this->Height);
  if (this->Camera.IsParallel)
  {
    return { this->Camera.Position + this->Camera.ParallelScale * offset, this->Forward };
  }
  const double slope = std::tan(0.5 * this->Camera.ViewAngle * std::acos(-1.0) / 180.0);
  return { this->Camera.Position, this->Forward + slope * offset };
}

//------------------------------------------------------------------------------
glm::dvec2 RayCaster::Project(const glm::dvec3& point) const
{
  const glm::dvec3 eye = point - this->Camera.Position;
  const double slope = std::tan(0.5 * this->Camera.ViewAngle * std::acos(-1.0) / 180.0);
  const double half =
    this->Camera.IsParallel ? this->Camera.ParallelScale : slope * glm::dot(eye, this->Forward);
  return 0.5 *
    (glm::dvec2(this->Width, this->Height) +
      this->Height / half * glm::dvec2(glm::dot(eye, this->Right), glm::dot(eye, this->Up)));
}

//------------------------------------------------------------------------------
double RayCaster::ToWindowDepth(const glm::dvec3& point) const
{
  const double eye = glm::dot(point - this->Camera.Position, this->Forward);
  const double near = this->Camera.Near;
  const double far = this->Camera.Far;
  return this->Camera.IsParallel ? (eye - near) / (far - near)
                                 : far / (far - near) * (1.0 - near / eye);
}

//------------------------------------------------------------------------------
bool RayCaster::FacesCamera(const std::array<glm::dvec3, 3>& corners) const
{
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const glm::dvec3 view =
    this->Camera.IsParallel ? this->Forward : corners[0] - this->Camera.Position;
  return glm::dot(normal, view) < 0.0;
}

//------------------------------------------------------------------------------
void RayCaster::Add(const Mesh& mesh)
{
  // How often a triangle of each facing uses an edge.
  std::map<Edge, std::array<int, 2>> uses;
  const std::size_t first = this->Triangles.size();
  for (const std::array<int, 3>& corners : mesh.Triangles)
  {
    Triangle triangle;
    for (int i = 0; i < 3; ++i)
    {
      triangle.Corners[i] = glm::dvec3(mesh.Points[corners[i]]);
      triangle.Projected[i] = this->Project(triangle.Corners[i]);
    }
    triangle.Color = glm::dvec4(mesh.Color);
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge = MakeEdge(triangle.Corners[i], triangle.Corners[(i + 1) % 3]);
      ++uses[edge][this->FacesCamera(triangle.Corners) ? 1 : 0];
    }
    this->Triangles.push_back(triangle);
  }
  for (std::size_t t = first; t < this->Triangles.size(); ++t)
  {
    Triangle& triangle = this->Triangles[t];
    for (int i = 0; i < 3; ++i)
    {
      const std::array<int, 2>& use =
        uses[MakeEdge(triangle.Corners[i], triangle.Corners[(i + 1) % 3])];
      triangle.IsBorder[i] = std::max(use[0], use[1]) != 2 || std::min(use[0], use[1]) != 0;
    }
  }
}

//------------------------------------------------------------------------------
double RayCaster::DepthOnPlane(const Triangle& triangle, double x, double y) const
{
  const Ray ray = this->MakeRay(x, y);
  const auto& p = triangle.Corners;
  const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double t = glm::dot(normal, p[0] - ray.Origin) / glm::dot(normal, ray.Direction);
  return this->ToWindowDepth(ray.Origin + t * ray.Direction);
}

//------------------------------------------------------------------------------
RayCaster::Pixel RayCaster::Cast(int x, int y) const
{
  const glm::dvec2 center(x + 0.5, y + 0.5);
  const Ray ray = this->MakeRay(center.x, center.y);
  Pixel pixel;
  for (const Triangle& triangle : this->Triangles)
  {
    const auto& projected = triangle.Projected;
    bool isNear = true;
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto range =
        std::minmax({ projected[0][axis], projected[1][axis], projected[2][axis] });
      isNear = isNear && center[axis] >= range.first - EdgeMargin &&
        center[axis] <= range.second + EdgeMargin;
    }
    if (!isNear)
    {
      continue;
    }
    int positive = 0;
    int negative = 0;
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      const double side =
        Side(ray.Origin, ray.Direction, triangle.Corners[i], triangle.Corners[next]);
      positive += side > 0.0;
      negative += side < 0.0;
      pixel.IsExcluded = pixel.IsExcluded ||
        (triangle.IsBorder[i] &&
          DistanceToSegment(center, projected[i], projected[next]) < EdgeMargin);
    }
    if (positive != 3 && negative != 3)
    {
      // A ray through an edge itself belongs to one of its triangles; which one is not known here.
      pixel.IsExcluded = pixel.IsExcluded || positive == 0 || negative == 0;
      continue;
    }
    Hit hit;
    hit.Color = triangle.Color;
    hit.Depth = this->DepthOnPlane(triangle, center.x, center.y);
    hit.Margin = std::ldexp(1.0, -22);
    for (int axis = 0; axis < 2; ++axis)
    {
      glm::dvec2 shifted = center;
      shifted[axis] += EdgeMargin;
      hit.Margin += std::abs(this->DepthOnPlane(triangle, shifted.x, shifted.y) - hit.Depth);
    }
    pixel.Hits.push_back(hit);
  }
  std::sort(pixel.Hits.begin(), pixel.Hits.end(),
    [](const Hit& a, const Hit& b) { return a.Depth < b.Depth; });
  for (std::size_t i = 1; i < pixel.Hits.size(); ++i)
  {
    const Hit& a = pixel.Hits[i - 1];
    const Hit& b = pixel.Hits[i];
    pixel.IsExcluded =
      pixel.IsExcluded || (a.Color != b.Color && b.Depth - a.Depth < a.Margin + b.Margin);
  }
  return pixel;
}

//------------------------------------------------------------------------------
glm::dvec4 RayCaster::Blend(const Pixel& pixel, const glm::dvec4& background)
{
  std::vector<Layer> layers;
  for (const Hit& hit : pixel.Hits)
  {
    layers.push_back({ static_cast<float>(hit.Depth), glm::vec4(hit.Color) });
  }
  return ReferenceCompositor::Composite(layers, background);
}
}
