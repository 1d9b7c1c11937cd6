// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// The ray caster itself, against answers that are known without it.

#include "Oracle/RayCaster.h"
#include "Rig/Report.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace vtkOITTest;

namespace
{
const glm::dvec4 Background(0.2, 0.4, 0.6, 0.4);

bool IsNear(double a, double b)
{
  return std::abs(a - b) < 1e-12;
}

/// The square of side 1 around the origin at z, of two triangles.
Mesh MakeSquare(double z, const glm::vec4& color)
{
  Mesh mesh;
  mesh.Points = { { -0.5f, -0.5f, z }, { 0.5f, -0.5f, z }, { 0.5f, 0.5f, z }, { -0.5f, 0.5f, z } };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  mesh.Color = color;
  return mesh;
}

/// 16 pixels a unit, borders of the square on borders of pixels, its diagonal between centres.
void CheckParallel(Report& report)
{
  RayCaster caster(CastCamera(), 32, 32);
  caster.Add(MakeSquare(0.5, { 1.0f, 0.0f, 0.0f, 0.5f }));
  caster.Add(MakeSquare(-0.25, { 0.0f, 1.0f, 0.0f, 0.25f }));
  int covered = 0;
  int excluded = 0;
  for (int y = 0; y < 32; ++y)
  {
    for (int x = 0; x < 32; ++x)
    {
      const RayCaster::Pixel pixel = caster.Cast(x, y);
      excluded += pixel.IsExcluded;
      const bool inside = x >= 8 && x < 24 && y >= 8 && y < 24;
      if (pixel.IsExcluded)
      {
        report.Check(x == y && inside, "a pixel off the diagonal is excluded");
        continue;
      }
      covered += !pixel.Hits.empty();
      report.Check(pixel.Hits.size() == (inside ? 2u : 0u), "wrong number of hits");
      if (inside && pixel.Hits.size() == 2)
      {
        report.Check(
          IsNear(pixel.Hits[0].Depth, 0.25) && IsNear(pixel.Hits[1].Depth, 0.625), "wrong depths");
        const glm::dvec4 expected = 0.5 * glm::dvec4(1.0, 0.0, 0.0, 1.0) +
          0.5 * (0.25 * glm::dvec4(0.0, 1.0, 0.0, 1.0) + 0.75 * Background);
        report.Check(
          glm::length(RayCaster::Blend(pixel, Background) - expected) < 1e-12, "wrong colour");
      }
    }
  }
  report.Check(covered + excluded == 256 && excluded == 16,
    std::to_string(covered) + " covered, " + std::to_string(excluded) + " excluded");
}

/// A square at the eye distance where it fills half of the height; the depth by its definition.
void CheckPerspective(Report& report)
{
  CastCamera camera;
  camera.IsParallel = false;
  camera.ViewAngle = 90.0; // half of the height is the distance
  camera.Position = { 0.0, 0.0, 1.25 };
  camera.Near = 0.5;
  camera.Far = 2.0;
  RayCaster caster(camera, 34, 34);
  caster.Add(MakeSquare(0.25, { 1.0f, 0.0f, 0.0f, 0.5f }));
  const RayCaster::Pixel pixel = caster.Cast(18, 10);
  report.Check(pixel.Hits.size() == 1 && !pixel.IsExcluded, "perspective: no hit");
  // At the eye distance 1: f / (f - n) (1 - n / 1).
  report.Check(!pixel.Hits.empty() && IsNear(pixel.Hits[0].Depth, 2.0 / 1.5 * 0.5),
    "perspective: wrong depth");
  report.Check(caster.Cast(8, 18).IsExcluded, "perspective: the border at 8.5 is not excluded");
  report.Check(caster.Cast(7, 18).Hits.empty(), "perspective: the square is too large");
}

/// A closed mesh is entered and left, and only pixels at its outline are excluded.
void CheckClosed(Report& report)
{
  for (Mesh mesh : { MakeSphere({ 0.1, 0.0, 0.0 }, 0.7, 14, glm::vec4(0.5f)),
         MakeTorus(glm::vec4(0.5f)), MakeKnot(glm::vec4(0.5f)) })
  {
    Rotate(mesh, { 1.0, 2.0, 0.5 }, 40.0);
    RayCaster caster(CastCamera(), 64, 48);
    caster.Add(mesh);
    int excluded = 0;
    std::size_t largest = 0;
    for (int i = 0; i < 64 * 48; ++i)
    {
      const RayCaster::Pixel pixel = caster.Cast(i % 64, i / 64);
      excluded += pixel.IsExcluded;
      largest = std::max(largest, pixel.Hits.size());
      report.Check(pixel.IsExcluded || pixel.Hits.size() % 2 == 0, "an odd number of hits");
    }
    report.Check(largest >= 2 && largest <= 12 && excluded < 64 * 48 / 50,
      std::to_string(largest) + " layers, " + std::to_string(excluded) + " pixels excluded");
  }
}

/// Where two triangles cross only the pixels at the crossing are excluded.
void CheckCrossing(Report& report)
{
  Mesh left;
  left.Points = { { -3.0f, -3.0f, -0.5f }, { 3.0f, -3.0f, 0.5f }, { 0.0f, 5.0f, 0.0f } };
  left.Triangles = { { 0, 1, 2 } };
  Mesh right = left;
  for (glm::vec3& point : right.Points)
  {
    point.z = -point.z;
  }
  right.Color = { 0.0f, 1.0f, 0.0f, 0.5f };
  RayCaster caster(CastCamera(), 33, 33);
  caster.Add(left);
  caster.Add(right);
  for (int x = 0; x < 33; ++x)
  {
    report.Check(
      caster.Cast(x, 8).IsExcluded == (x == 16), "crossing: column " + std::to_string(x));
  }
  report.Check(caster.Cast(2, 8).Hits.front().Color.r == 0.0, "crossing: wrong order on the left");
  report.Check(
    caster.Cast(30, 8).Hits.front().Color.r == 1.0, "crossing: wrong order on the right");
}
}

int TestRayCaster(int, char*[])
{
  Report report;
  report.SetContext("ray caster");
  CheckParallel(report);
  CheckPerspective(report);
  CheckClosed(report);
  CheckCrossing(report);
  return report.GetExitStatus();
}
