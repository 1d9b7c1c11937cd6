// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Meshes that are convex or closed, and such as only look like it.
 */

#ifndef ShapeMeshes_h
#define ShapeMeshes_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <vector>

class vtkPolyData;

namespace vtkOITTest
{
using MeshPointer = vtkSmartPointer<vtkPolyData>;
using Corners = std::vector<vtkIdType>;

/// A cube of size 1.
///@{
extern const std::vector<glm::dvec3> CubePoints;
extern const std::vector<Corners> CubeFaces;
///@}

MeshPointer MakeMesh(const std::vector<glm::dvec3>& points, const std::vector<Corners>& polygons);

/// One polygon.
MeshPointer MakeFlat(const std::vector<glm::dvec2>& outline);

/// A closed grid of quads, nu x nv, that closes in both directions.
MeshPointer MakeTorus(int nu, int nv);

/// A cube at each offset.
MeshPointer MakeCubes(const std::vector<glm::dvec3>& offsets);

/// A cube of size 2 whose upper face is a grid of this height.
MeshPointer MakeCubeWithTop(int count, const std::function<double(double, double)>& getHeight);

/// Down by `depth` in the middle of the upper face, like a bowl.
MeshPointer MakeCubeWithBowl(int count, double depth);
MeshPointer MakeCubeWithBump(int count, double height);

/// A block of which one side of `count` strips goes in by `depth`, as part of a circle does.
MeshPointer MakeHollowBlock(int count, double depth);

/// Moved, and turned about an axis of no mesh.
MeshPointer Transform(vtkPolyData* mesh, double x, double y, double z, bool turn);
}

#endif
