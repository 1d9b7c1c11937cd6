// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Light_h
#define Light_h

#include "Rig/Rig.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkActor;

namespace vtkOITTest
{
/// Emissive Gaussians at the points: splats of this radius in pixels, or with a radius of 0 one large
/// point each that covers the picture evenly.
vtkActor* AddLight(
  Rig& rig, const std::vector<glm::dvec3>& at, const glm::vec4& color, double radius);
}

#endif
