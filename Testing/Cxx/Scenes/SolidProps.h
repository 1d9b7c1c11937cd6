// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Closed props whose sides have different brightness, so that the near and the far side are not
 * mixed up unseen.
 */

#ifndef SolidProps_h
#define SolidProps_h

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

class vtkActor;
class vtkPolyData;

namespace vtkOITTest
{
class Rig;

inline const glm::vec4 Red(0.9f, 0.3f, 0.2f, 0.4f);
inline const glm::vec4 Green(0.2f, 0.8f, 0.3f, 0.6f);
inline const glm::vec4 Blue(0.1f, 0.3f, 0.9f, 0.5f);

/// Gives each side of a mesh with normals another brightness.
void PaintSides(vtkPolyData* mesh, const glm::vec4& color);

vtkActor* AddSphere(Rig& rig, const glm::vec4& color, const glm::dvec3& center, double radius);
vtkActor* AddBox(
  Rig& rig, const glm::vec4& color, const glm::dvec3& lower, const glm::dvec3& upper);

/// Towards the origin.
void LookInPerspective(Rig& rig, const glm::dvec3& from, double nearest = 0.5);
}

#endif
