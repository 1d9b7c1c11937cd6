// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Frame/vtkOITEyeDepthInterval.h"

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITPropInput.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

//------------------------------------------------------------------------------
vtkOITEyeDepthInterval vtkOITEyeDepthInterval::Find(const vtkOITFrame& frame)
{
  vtkCamera* camera = frame.Renderer->GetActiveCamera();
  vtkOITEyeDepthInterval interval;
  const double* range = camera->GetClippingRange();
  interval.Near = interval.Nearest = range[0];
  interval.Far = interval.Farthest = range[1];
  interval.IsParallel = camera->GetParallelProjection() != 0;

  glm::dvec3 position;
  glm::dvec3 direction;
  camera->GetPosition(position.x, position.y, position.z);
  camera->GetDirectionOfProjection(direction.x, direction.y, direction.z);
  double nearest = interval.Far;
  double farthest = interval.Near;
  for (vtkProp* prop : frame.Props)
  {
    auto* prop3D = vtkProp3D::SafeDownCast(prop);
    double bounds[6];
    if (!prop3D || !vtkOITIsInWorldCoordinates(prop3D) || !vtkOITGetBounds(prop, bounds))
    {
      return interval;
    }
    if (!vtkBoundingBox::IsValid(bounds))
    {
      continue; // empty data
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 point(
        bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + (corner >> 2)]);
      const double depth = glm::dot(point - position, direction);
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  }
  nearest = std::max(nearest, interval.Near);
  farthest = std::min(farthest, interval.Far);
  if (nearest < farthest)
  {
    interval.Nearest = nearest;
    interval.Farthest = farthest;
  }
  return interval;
}

//------------------------------------------------------------------------------
void vtkOITEyeDepthInterval::SetUniforms(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("oitClippingRange"))
  {
    const float range[2] = { static_cast<float>(this->Near), static_cast<float>(this->Far) };
    const float interval[2] = { static_cast<float>(this->Nearest),
      static_cast<float>(this->Farthest) };
    program->SetUniform2f("oitClippingRange", range);
    program->SetUniform2f("oitInterval", interval);
    program->SetUniformi("oitIsParallel", this->IsParallel ? 1 : 0);
  }
}
