// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Sphere and stick impostors write gl_FragDepth: as opaque occluders and as translucent props
// their own depth counts, not the one of the face that they are drawn on.

#include "Oracle/SingleLayer.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <string>
#include <utility>

using namespace vtkOITTest;

namespace
{
const glm::vec4 Orange(0.9f, 0.5f, 0.1f, 0.375f);

/// A vertex at each point, of the given colour: mappers take the bounds from the cells, and these
/// mappers would mix the property's opacity into colours that are the property's.
void AddVertices(vtkPolyData* polydata, unsigned char r, unsigned char g, unsigned char b)
{
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < polydata->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(1);
    vertices->InsertCellPoint(i);
    colors->InsertNextTuple3(r, g, b);
  }
  polydata->SetVerts(vertices);
  polydata->GetPointData()->SetScalars(colors);
}

/// Three spheres side by side, lit. Their centres are behind the ramps of the test: VTK also draws
/// the inner sides of translucent impostors, which an opaque ramp must hide here.
vtkActor* AddSpheres(Rig& rig)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-0.8, 0.0, -0.28);
  points->InsertNextPoint(0.0, 0.3, -0.12);
  points->InsertNextPoint(0.8, -0.2, 0.04);
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  AddVertices(polydata, 50, 150, 230);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(polydata);
  mapper->SetRadius(0.35f);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  rig.Renderer->AddActor(actor);
  return actor;
}

/// Two sticks side by side, inclined towards the camera.
vtkActor* AddSticks(Rig& rig)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-0.5, 0.0, 0.0);
  points->InsertNextPoint(0.5, 0.0, 0.0);
  vtkNew<vtkFloatArray> orientations;
  orientations->SetName("orientations");
  orientations->SetNumberOfComponents(3);
  orientations->InsertNextTuple3(0.48, 0.64, 0.6);
  orientations->InsertNextTuple3(-0.6, 0.0, 0.8);
  vtkNew<vtkFloatArray> scales;
  scales->SetName("scales");
  scales->SetNumberOfComponents(3);
  scales->InsertNextTuple3(0.9, 0.2, 0.2);
  scales->InsertNextTuple3(0.7, 0.15, 0.15);
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  AddVertices(polydata, 80, 200, 80);
  polydata->GetPointData()->AddArray(orientations);
  polydata->GetPointData()->AddArray(scales);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(polydata);
  mapper->SetOrientationArray("orientations");
  mapper->SetScaleArray("scales");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  rig.Renderer->AddActor(actor);
  return actor;
}
}

int TestImpostors(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(25);
      Rig rig(setup, 96, 64);
      using AddProp = vtkActor* (*)(Rig&);
      const std::pair<std::string, AddProp> props[] = { { "spheres", AddSpheres },
        { "sticks", AddSticks } };
      for (const auto& prop : props)
      {
        rig.RemoveProps();
        prop.second(rig);
        CheckSingleLayer(report, rig, setup, "ramp through opaque " + prop.first,
          rig.AddRamp(0.65, 0.35, Orange), Orange.a, 400, 400);
        rig.RemoveProps();
        rig.AddRamp(0.65, 0.35, { 0.6f, 0.6f, 0.1f, 1.0f });
        CheckSingleLayer(report, rig, setup, "translucent " + prop.first + " through a ramp",
          prop.second(rig), 0.625f, 200, 400);
      }
    });
}
