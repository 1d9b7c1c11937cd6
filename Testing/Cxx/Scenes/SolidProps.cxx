// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/SolidProps.h"

#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

namespace vtkOITTest
{
//------------------------------------------------------------------------------
void PaintSides(vtkPolyData* mesh, const glm::vec4& color)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* n = normals->GetTuple3(i);
    const double brightness = 255.0 * (0.5 + 0.25 * n[2] + 0.15 * n[0] + 0.1 * n[1]);
    colors->InsertNextTuple3(brightness * color.r, brightness * color.g, brightness * color.b);
  }
  mesh->GetPointData()->SetScalars(colors);
}

//------------------------------------------------------------------------------
vtkActor* AddSphere(Rig& rig, const glm::vec4& color, const glm::dvec3& center, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(17);
  sphere->SetPhiResolution(13);
  sphere->Update();
  PaintSides(sphere->GetOutput(), color);
  vtkActor* actor = rig.AddPolyData(sphere->GetOutput(), color);
  actor->SetPosition(center.x, center.y, center.z);
  actor->GetProperty()->LightingOn(); // so that fragments of one prop have different colours
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* AddBox(Rig& rig, const glm::vec4& color, const glm::dvec3& lower, const glm::dvec3& upper)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(lower.x, upper.x, lower.y, upper.y, lower.z, upper.z);
  cube->Update();
  PaintSides(cube->GetOutput(), color);
  vtkActor* actor = rig.AddPolyData(cube->GetOutput(), color);
  actor->GetProperty()->LightingOn();
  return actor;
}

//------------------------------------------------------------------------------
void LookInPerspective(Rig& rig, const glm::dvec3& from, double nearest)
{
  vtkCamera* camera = rig.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(from.x, from.y, from.z);
  camera->SetClippingRange(nearest, 20.0);
}
}
