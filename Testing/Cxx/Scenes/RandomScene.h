// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Random scenes of a few props, which can be written to a text file and read back. A line is a
 * prop: its kind, colour and opacity, and its numbers.
 *
 *     seed 17
 *     relation draw order
 *     quad r g b a x0 y0 x1 y1 depth
 *     triangle r g b a x y depth x y depth x y depth
 *     sphere r g b a x y depth radius
 *     empty r g b a
 *
 * Positions and radii are in pixels of a viewport of SceneWidth x SceneHeight; depths are window
 * depths of Rig's camera.
 */

#ifndef RandomScene_h
#define RandomScene_h

#include "Rig/Rig.h"

#include <string>
#include <vector>

namespace vtkOITTest
{
constexpr int SceneWidth = 40;
constexpr int SceneHeight = 32;

struct SceneProp
{
  std::string Kind;
  glm::vec4 Color{ 0.0f };
  std::vector<double> Numbers;

  bool operator==(const SceneProp& other) const
  {
    return this->Kind == other.Kind && this->Color == other.Color && this->Numbers == other.Numbers;
  }
};

struct Scene
{
  unsigned int Seed = 0;
  std::string Relation; // what did not hold for it
  std::vector<SceneProp> Props;
};

enum class SceneKind
{
  Aligned, // quads on borders of pixels; some are coincident
  General  // quads, triangles and spheres that cross, no coincident faces
};
Scene MakeScene(unsigned int seed, SceneKind kind);

/// False when the file cannot be written, or read, or has something else in it.
///@{
bool SaveScene(const Scene& scene, const std::string& fileName);
bool LoadScene(Scene& scene, const std::string& fileName);
///@}

/// Puts the prop into the rig, whose viewport shows the scene whatever its size is. Opaque ones
/// have opacity 1.
void AddProp(Rig& rig, const SceneProp& prop);

/// The rig with these props only.
Image RenderProps(Rig& rig, const std::vector<SceneProp>& props);
}

#endif
