// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/Light.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace vtkOITTest
{
//------------------------------------------------------------------------------
vtkActor* AddLight(
  Rig& rig, const std::vector<glm::dvec3>& at, const glm::vec4& color, double radius)
{
  vtkNew<vtkPoints> points;
  for (const glm::dvec3& point : at)
  {
    points->InsertNextPoint(point.x, point.y, point.z);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleFactor(radius * 2.0 / rig.GetWidth());
  mapper->EmissiveOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  actor->GetProperty()->SetOpacity(color.a);
  actor->GetProperty()->SetPointSize(60.0);
  actor->ForceTranslucentOn(); // VTK draws it with the opaque geometry where its opacity is 1
  rig.Renderer->AddActor(actor);
  return actor;
}
}
