// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The right picture of translucent triangles, by casting a ray through the centre of each pixel,
 * in double precision. Written from the definitions; it shares no code with the passes, with the
 * rasteriser or with VTK's matrices.
 *
 * A rasteriser moves corners to a grid of 1/256 pixel and rounds depths to float32. So there are
 * pixels that it may draw either way, and they are marked as excluded: those within
 * RayCaster::EdgeMargin of an edge where the surface ends or turns away (the edges inside of a
 * surface are safe: exactly one of the triangles that share it is hit), and those where two layers
 * of different colours have depths that shifting the ray by that margin could swap.
 */

#ifndef RayCaster_h
#define RayCaster_h

#include "Oracle/ReferenceCompositor.h"
#include "Scenes/Meshes.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace vtkOITTest
{
/// A camera as vtkCamera describes it: world units, degrees.
struct CastCamera
{
  bool IsParallel = true;
  glm::dvec3 Position{ 0.0, 0.0, 2.0 };
  glm::dvec3 FocalPoint{ 0.0, 0.0, 0.0 };
  glm::dvec3 ViewUp{ 0.0, 1.0, 0.0 };
  double ParallelScale = 1.0; // half of the height of the viewport
  double ViewAngle = 30.0;    // of the height of the viewport
  double Near = 1.0;
  double Far = 3.0;
};

class RayCaster
{
public:
  struct Hit
  {
    double Depth = 0.0;  // window depth, 0 near, 1 far
    double Margin = 0.0; // how much a shift of the ray by EdgeMargin can change it
    glm::dvec4 Color{ 0.0 };
  };
  struct Pixel
  {
    std::vector<Hit> Hits; // from near to far
    bool IsExcluded = false;
  };

  /// In pixels.
  static constexpr double EdgeMargin = 1.0 / 64;

  RayCaster(const CastCamera& camera, int width, int height);

  /// All meshes in front of the near plane; each may be open.
  void Add(const Mesh& mesh);

  /// What the ray through the centre of a pixel meets.
  Pixel Cast(int x, int y) const;

  /// What the hits give over the background.
  static glm::dvec4 Blend(const Pixel& pixel, const glm::dvec4& background);

private:
  struct Triangle
  {
    std::array<glm::dvec3, 3> Corners;
    std::array<glm::dvec2, 3> Projected; // in pixels
    std::array<bool, 3> IsBorder{};      // the edge that starts at this corner
    glm::dvec4 Color{ 0.0 };
  };
  struct Ray
  {
    glm::dvec3 Origin;
    glm::dvec3 Direction;
  };

  Ray MakeRay(double x, double y) const;
  glm::dvec2 Project(const glm::dvec3& point) const;
  double ToWindowDepth(const glm::dvec3& point) const;
  bool FacesCamera(const std::array<glm::dvec3, 3>& corners) const;
  double DepthOnPlane(const Triangle& triangle, double x, double y) const;

  CastCamera Camera;
  glm::dvec3 Forward;
  glm::dvec3 Right;
  glm::dvec3 Up;
  int Width;
  int Height;
  std::vector<Triangle> Triangles;
};
}

#endif
