// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Triangle meshes as plain arrays, for the ray caster and for VTK alike. Closed meshes have no
 * seams: neighbours share their points.
 */

#ifndef Meshes_h
#define Meshes_h

#include "Scenes/Random.h"

#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <functional>
#include <vector>

class vtkPolyData;

namespace vtkOITTest
{
struct Mesh
{
  std::vector<glm::vec3> Points;
  std::vector<std::array<int, 3>> Triangles;
  glm::vec4 Color{ 1.0f, 1.0f, 1.0f, 0.5f };
};

vtkSmartPointer<vtkPolyData> MakePolyData(const Mesh& mesh);

/// A closed sphere of rings between two poles.
Mesh MakeSphere(const glm::dvec3& center, double radius, int rings, const glm::vec4& color);

/// A closed tube around a closed curve, given for t in [0, 1].
Mesh MakeTube(const std::function<glm::dvec3(double)>& curve, double radius, int segments,
  int sides, const glm::vec4& color);

/// A torus around the axis, and the (2, 3) torus knot; both of size about 1.
Mesh MakeTorus(const glm::vec4& color);
Mesh MakeKnot(const glm::vec4& color);

/// Triangles that cross each other, each in a mesh of its own, within [-extent, extent]^3.
std::vector<Mesh> MakeSoup(Random& random, int count, double extent);

/// All points turned by degrees about an axis through the origin.
void Rotate(Mesh& mesh, const glm::dvec3& axis, double degrees);
}

#endif
