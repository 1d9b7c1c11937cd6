// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Scenes of which it is known what needs no sorting.
 */

#ifndef SkipScenes_h
#define SkipScenes_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <functional>
#include <string>
#include <vector>

class vtkActor;

namespace vtkOITTest
{
class TestRig;

constexpr int Any = -1;

struct Scene
{
  std::string Name;
  std::function<void(TestRig&)> Build;
  int Invisible = 0; // props that are left out
  int Blended = 0;
  int Sorted = 0;
  int Passes = Any; // of frames without sorted props
  int Layers = 4;   // at most, at a pixel
};

inline const glm::vec4 Red(0.9f, 0.3f, 0.2f, 0.4f);
inline const glm::vec4 Green(0.2f, 0.8f, 0.3f, 0.6f);
inline const glm::vec4 Blue(0.1f, 0.3f, 0.9f, 0.5f);

/// A sphere whose sides have different brightness.
vtkActor* AddSphere(TestRig& rig, const glm::vec4& color, const glm::dvec3& center, double radius);

std::vector<Scene> GetInvisibleScenes();
std::vector<Scene> GetFlatScenes();
std::vector<Scene> GetClosedScenes();
}

#endif
