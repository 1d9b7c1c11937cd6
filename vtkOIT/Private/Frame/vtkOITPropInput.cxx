// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Frame/vtkOITPropInput.h"

#include "Private/Frame/vtkOITIsCalled.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <limits>

namespace
{
bool HasInput(vtkMapper* mapper)
{
  return mapper->GetNumberOfInputPorts() > 0 && mapper->GetNumberOfInputConnections(0) > 0;
}

bool HasPipeline(vtkMapper* mapper)
{
  return !mapper->GetStatic() && HasInput(mapper) &&
    !vtkOITIsCalled(mapper->GetInputAlgorithm(0, 0), "vtkTrivialProducer");
}

/// The mesh that the mapper of an actor draws as it is, or nullptr.
vtkPolyData* FindMesh(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  const bool isPlain = vtkOITIsCalled(actor, "vtkOpenGLActor") &&
    vtkOITIsCalled(mapper, "vtkOpenGLPolyDataMapper") && HasInput(mapper) && !HasPipeline(mapper);
  vtkDataObject* data = isPlain ? mapper->GetInputDataObject(0, 0) : nullptr;
  return vtkOITIsCalled(data, "vtkPolyData") ? static_cast<vtkPolyData*>(data) : nullptr;
}

/// The box around a box under an affine transformation.
void Transform(vtkMatrix4x4* matrix, double bounds[6])
{
  const double* m = matrix->GetData();
  glm::dvec3 lower(std::numeric_limits<double>::max());
  glm::dvec3 upper(std::numeric_limits<double>::lowest());
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 point(
      bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + (corner >> 2)]);
    const auto row = [&](int r)
    { return m[4 * r] * point.x + m[4 * r + 1] * point.y + m[4 * r + 2] * point.z + m[4 * r + 3]; };
    const glm::dvec3 moved(row(0), row(1), row(2));
    lower = glm::min(lower, moved);
    upper = glm::max(upper, moved);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = lower[axis];
    bounds[2 * axis + 1] = upper[axis];
  }
}
}

//------------------------------------------------------------------------------
void vtkOITUpdateInput(vtkMapper* mapper)
{
  if (HasPipeline(mapper))
  {
    mapper->GetInputAlgorithm(0, 0)->Update();
  }
}

//------------------------------------------------------------------------------
bool vtkOITGetBounds(vtkProp* prop, double bounds[6])
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkPolyData* mesh = actor && actor->GetMapper() ? FindMesh(actor) : nullptr;
  if (!mesh)
  {
    const double* found = prop->GetBounds();
    if (found)
    {
      std::copy_n(found, 6, bounds);
    }
    return found != nullptr;
  }
  mesh->GetCellsBounds(bounds);
  vtkMatrix4x4* matrix = actor->GetMatrix();
  if (bounds[0] <= bounds[1] && !actor->GetIsIdentity())
  {
    Transform(matrix, bounds);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkOITGetRedrawMTime(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (HasPipeline(mapper))
  {
    return actor->GetRedrawMTime();
  }
  vtkDataObject* data = HasInput(mapper) ? mapper->GetInputDataObject(0, 0) : nullptr;
  return std::max({ actor->GetMTime(), mapper->GetMTime(), data ? data->GetMTime() : 0 });
}
