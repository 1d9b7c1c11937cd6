// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITMeshShape_h
#define vtkOITMeshShape_h

#include <array>
#include <limits>

class vtkPolyData;

/// What is proven of a mesh, and so of the fragments that it can have at a pixel.
enum class vtkOITMeshShape
{
  Unknown,           // nothing
  FlatConvex,        // one flat patch with a convex outline: one fragment
  ClosedConvex,      // the surface of a convex body: one front face before one back face
  ClosedConvexInside // the same, with faces that point inwards
};

/// Two balls around one point: nothing of a closed mesh is in the inner one, which lies inside of
/// it, nor outside of the outer one. An inner radius of 0 and an infinite outer one say nothing.
struct vtkOITMeshBalls
{
  std::array<double, 3> Center{};
  double Inner = 0.0;
  double Outer = std::numeric_limits<double>::infinity();
};

/**
 * Proves a mesh to be convex, in time that grows linearly with its triangles; vertices at one
 * place count as one. The proof:
 *
 * 1. Every edge belongs to one triangle in each direction, so that orientation is consistent, and
 *    the triangles are connected.
 * 2. Closed: no edge has an open side, the triangles around every vertex form one fan, and the
 *    Euler characteristic is 2. All edges are convex, and the angles around every vertex sum up to
 *    less than 2 pi, so the surface is locally convex everywhere; then it is the boundary of a
 *    convex body (van Heijenoort, On locally convex manifolds, Comm. Pure Appl. Math. 1952).
 * 3. Flat: all triangles lie in one plane and face one way, and the open edges form one convex
 *    polygon that turns around once: it winds once around each inner point.
 *
 * Coordinates are floats, so "convex" and "flat" are meant up to 4e-7 of the largest coordinate. So
 * that many such errors do not add up to a hollow, all vertices of closed meshes must also be
 * behind the planes of up to 400 of their triangles. Closed meshes with triangles that are but
 * lines are Unknown.
 */
vtkOITMeshShape vtkOITFindMeshShape(vtkPolyData* mesh);

/// The same with the balls of closed convex meshes.
vtkOITMeshShape vtkOITFindMeshShape(vtkPolyData* mesh, vtkOITMeshBalls& balls);

#endif
