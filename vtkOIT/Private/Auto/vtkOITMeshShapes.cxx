// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITMeshShapes.h"

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITIsCalled.h"
#include "Private/Frame/vtkOITPropInput.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>

namespace
{
/// Its mesh when only polygons of that are drawn, at their own depth; or nullptr.
vtkPolyData* FindPlainSurface(vtkActor* actor)
{
  if (!actor || actor->GetMapper()->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  vtkOITUpdateInput(actor->GetMapper());
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  vtkProperty* property = actor->GetProperty();
  const bool isPlain = mesh && !vtkOITDrawsSelection(actor->GetMapper(), 0) &&
    property->GetRepresentation() == VTK_SURFACE && !property->GetEdgeVisibility() &&
    !property->GetVertexVisibility() && mesh->GetNumberOfVerts() == 0 &&
    mesh->GetNumberOfLines() == 0 && mesh->GetNumberOfStrips() == 0;
  return isPlain ? mesh : nullptr;
}

/// Of the points and cells, not of what the points have.
vtkMTimeType FindShapeTime(vtkPolyData* mesh)
{
  return std::max(mesh->GetMeshMTime(), mesh->vtkObject::GetMTime());
}

bool DrawsAllFaces(vtkProperty* property)
{
  return !property->GetBackfaceCulling() && !property->GetFrontfaceCulling();
}

/// Nothing is said for a transformation that does not keep balls what they are.
vtkOITMeshBalls Transform(const vtkOITMeshBalls& balls, vtkMatrix4x4* matrix)
{
  vtkOITMeshBalls result;
  const double scale = std::cbrt(std::abs(matrix->Determinant()));
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      double product = 0.0; // of columns
      for (int row = 0; row < 3; ++row)
      {
        product += matrix->GetElement(row, i) * matrix->GetElement(row, j);
      }
      if (!(std::abs(product - (i == j ? scale * scale : 0.0)) <= 1e-9 * scale * scale))
      {
        return result;
      }
    }
    if (matrix->GetElement(3, i) != 0.0 || matrix->GetElement(3, 3) != 1.0)
    {
      return result;
    }
    result.Center[i] = matrix->GetElement(i, 3);
    for (int j = 0; j < 3; ++j)
    {
      result.Center[i] += matrix->GetElement(i, j) * balls.Center[j];
    }
  }
  result.Inner = scale * balls.Inner;
  result.Outer = scale * balls.Outer;
  return result;
}

/// The actor with a mapper of one of these classes and VTK's shaders.
vtkActor* FindActor(vtkProp* prop, std::initializer_list<const char*> mappers)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper || !vtkOITIsCalled(actor, "vtkOpenGLActor"))
  {
    return nullptr;
  }
  vtkShaderProperty* shader = actor->GetShaderProperty();
  const bool isPlain = vtkOITIsCalledOneOf(mapper, mappers) && !shader->HasVertexShaderCode() &&
    !shader->HasFragmentShaderCode() && !shader->HasGeometryShaderCode() &&
    shader->GetNumberOfShaderReplacements() == 0;
  return isPlain ? actor : nullptr;
}
}

//------------------------------------------------------------------------------
vtkActor* vtkOITFindPlainActor(vtkProp* prop)
{
  return FindActor(prop, { "vtkOpenGLPolyDataMapper", "vtkDataSetMapper" });
}

//------------------------------------------------------------------------------
vtkActor* vtkOITFindCompositeActor(vtkProp* prop)
{
  return FindActor(prop, { "vtkCompositePolyDataMapper", "vtkCompositePolyDataMapper2" });
}

//------------------------------------------------------------------------------
bool vtkOITMeshShapes::IsSurface(vtkProp* prop)
{
  return FindPlainSurface(vtkOITFindPlainActor(prop)) != nullptr;
}

//------------------------------------------------------------------------------
vtkOITMeshShape vtkOITMeshShapes::Find(vtkProp* prop, vtkOITMeshBalls& balls)
{
  balls = {};
  vtkActor* actor = vtkOITFindPlainActor(prop);
  vtkPolyData* mesh = FindPlainSurface(actor);
  if (!mesh || mesh->GetNumberOfPolys() > LargestMesh || !DrawsAllFaces(actor->GetProperty()))
  {
    return vtkOITMeshShape::Unknown;
  }
  const double determinant = actor->GetMatrix()->Determinant();
  if (!(std::abs(determinant) > 0.0))
  {
    return vtkOITMeshShape::Unknown;
  }
  Entry& entry = this->Entries[mesh];
  entry.Rest = 0;
  const vtkMTimeType time = FindShapeTime(mesh);
  const bool isNew = entry.Time == 0;
  this->HasNew = this->HasNew || isNew;
  const bool hasChanged = entry.Time != time;
  const bool isCheap = mesh->GetNumberOfPolys() <= CheapMesh;
  const bool isWorthIt = isNew ? isCheap || this->FramesWithNew < LongestSeries
    : hasChanged ? entry.Shape != vtkOITMeshShape::Unknown && (isCheap || !entry.HasChanged)
                 : !entry.IsTried;
  entry.Time = time;
  entry.HasChanged = hasChanged;
  if (isWorthIt)
  {
    entry.Shape = vtkOITFindMeshShape(mesh, entry.Balls);
    ++this->NumberOfProofs;
  }
  else if (hasChanged)
  {
    entry.Shape = vtkOITMeshShape::Unknown;
  }
  entry.IsTried = isWorthIt || (entry.IsTried && !hasChanged);
  balls = Transform(entry.Balls, actor->GetMatrix());
  if (determinant < 0.0 && entry.Shape == vtkOITMeshShape::ClosedConvex)
  {
    return vtkOITMeshShape::ClosedConvexInside;
  }
  if (determinant < 0.0 && entry.Shape == vtkOITMeshShape::ClosedConvexInside)
  {
    return vtkOITMeshShape::ClosedConvex;
  }
  return entry.Shape;
}

//------------------------------------------------------------------------------
void vtkOITMeshShapes::Prune()
{
  this->FramesWithNew = this->HasNew ? this->FramesWithNew + 1 : 0;
  this->HasNew = false;
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    it = ++it->second.Rest > LongestRest ? this->Entries.erase(it) : std::next(it);
  }
}
