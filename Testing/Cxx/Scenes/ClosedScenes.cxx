// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/SkipScenes.h"

#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"

namespace vtkOITTest
{
//------------------------------------------------------------------------------
std::vector<SkipScene> GetClosedScenes()
{
  return {
    { "a sphere",
      [](Rig& rig) {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
      },
      0, 1, 0, 2 },
    { "two spheres beside each other",
      [](Rig& rig)
      {
        AddSphere(rig, Red, { -0.6, 0.0, 0.0 }, 0.4);
        AddSphere(rig, Blue, { 0.6, 0.0, 0.0 }, 0.4);
      },
      0, 2, 0, 2 },
    { "two spheres behind each other",
      [](Rig& rig)
      {
        AddSphere(rig, Red, { 0.1, 0.0, 0.5 }, 0.4);
        AddSphere(rig, Blue, { -0.1, 0.1, -0.5 }, 0.4);
      },
      0, 2, 0, 4 },
    { "a sphere in a sphere",
      [](Rig& rig)
      {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
        AddSphere(rig, Blue, { 0.1, -0.1, 0.1 }, 0.4);
      },
      0, 2, 0, 4 },
    { "spheres, boxes and quads in spheres, given from the inside",
      [](Rig& rig)
      {
        LookInPerspective(rig, { 0.5, 1.0, 4.0 });
        AddBox(rig, Blue, { -0.1, -0.1, -0.3 }, { 0.1, 0.1, -0.1 });
        AddSphere(rig, Green, { 0.0, 0.0, 0.0 }, 0.5);
        rig.AddQuad({ 0.45f, Blue }, { 26, 18, 38, 30 });
        AddSphere(rig, Red, { 0.1, 0.0, 0.0 }, 0.9)->SetScale(-1.0, 1.0, 1.0);
        AddSphere(rig, Blue, { 1.2, 0.0, -2.0 }, 0.5);
      },
      0, 5, 0, 9, 9 },
    { "a sphere in a stretched sphere",
      [](Rig& rig)
      {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.4)->SetScale(2.0, 1.0, 1.0);
        AddSphere(rig, Blue, { 0.5, 0.0, 0.0 }, 0.2);
      },
      0, 0, 2 },
    { "a box whose corners look out of a sphere",
      [](Rig& rig)
      {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.6);
        AddBox(rig, Blue, { -0.4, -0.4, -0.4 }, { 0.4, 0.4, 0.4 });
      },
      0, 0, 2 },
    { "a sphere that touches the one around it",
      [](Rig& rig)
      {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
        AddSphere(rig, Blue, { 0.0, 0.0, 0.4 }, 0.4);
      },
      0, 0, 2 },
    { "crossing spheres",
      [](Rig& rig)
      {
        AddSphere(rig, Red, { 0.2, 0.0, 0.1 }, 0.5);
        AddSphere(rig, Blue, { -0.2, 0.1, -0.1 }, 0.5);
      },
      0, 0, 2 },
    { "boxes beside each other in perspective",
      [](Rig& rig)
      {
        LookInPerspective(rig, { 3.0, 1.0, 4.0 });
        AddBox(rig, Red, { -1.0, -0.5, -0.5 }, { -0.1, 0.5, 0.5 });
        AddBox(rig, Blue, { 0.0, -0.5, -0.5 }, { 0.9, 0.5, 0.5 });
      },
      0, 2, 0, 4 },
    { "boxes beside each other, seen from the other side",
      [](Rig& rig)
      {
        LookInPerspective(rig, { -3.0, 1.0, 4.0 });
        AddBox(rig, Red, { -1.0, -0.5, -0.5 }, { -0.1, 0.5, 0.5 });
        AddBox(rig, Blue, { 0.0, -0.5, -0.5 }, { 0.9, 0.5, 0.5 });
      },
      0, 2, 0, 4 },
    { "crossing boxes",
      [](Rig& rig)
      {
        LookInPerspective(rig, { 3.0, 1.0, 4.0 });
        AddBox(rig, Red, { -1.0, -0.5, -0.5 }, { 0.1, 0.5, 0.5 });
        AddBox(rig, Blue, { 0.0, -0.5, -0.5 }, { 0.9, 0.5, 0.6 });
      },
      0, 0, 2 },
    { "boxes that touch",
      [](Rig& rig)
      {
        LookInPerspective(rig, { 3.0, 1.0, 4.0 });
        AddBox(rig, Red, { -1.0, -0.5, -0.5 }, { 0.0, 0.5, 0.5 });
        AddBox(rig, Blue, { 0.0, -0.5, -0.5 }, { 0.9, 0.5, 0.5 });
      },
      0, 0, 2 },
    { "three bars in a cycle",
      [](Rig& rig)
      {
        // Each is in front of the next one; axis planes tell so, in pairs.
        LookInPerspective(rig, { 3.0, 3.0, 3.0 });
        AddBox(rig, Red, { -1.0, -0.2, 0.0 }, { 1.0, 0.0, 0.2 });
        AddBox(rig, Green, { 0.01, -1.0, -0.2 }, { 0.21, 1.0, -0.01 });
        AddBox(rig, Blue, { -0.2, 0.01, -1.0 }, { 0.0, 0.21, 1.0 });
      },
      0, 0, 3, Any, 6 },
    { "mirrored sphere", [](Rig& rig) { AddSphere(rig, Red, {}, 0.7)->SetScale(-1.0, 0.8, 1.0); },
      0, 1, 0, 2 },
    { "sphere inside out",
      [](Rig& rig)
      {
        vtkNew<vtkSphereSource> sphere;
        vtkNew<vtkReverseSense> reverse;
        reverse->SetInputConnection(sphere->GetOutputPort());
        reverse->ReverseNormalsOff();
        reverse->Update();
        PaintSides(reverse->GetOutput(), Red);
        rig.AddPolyData(reverse->GetOutput(), Red)->GetProperty()->LightingOn();
      },
      0, 1, 0, 2 },
    { "mirrored sphere inside out",
      [](Rig& rig)
      {
        vtkNew<vtkSphereSource> sphere;
        vtkNew<vtkReverseSense> reverse;
        reverse->SetInputConnection(sphere->GetOutputPort());
        reverse->ReverseNormalsOff();
        reverse->Update();
        PaintSides(reverse->GetOutput(), Red);
        vtkActor* actor = rig.AddPolyData(reverse->GetOutput(), Red);
        actor->GetProperty()->LightingOn();
        actor->SetScale(1.0, -1.0, 1.0);
      },
      0, 1, 0, 2 },
    { "spheres with faces culled",
      [](Rig& rig) { AddSphere(rig, Red, {}, 0.7)->GetProperty()->BackfaceCullingOn(); }, 0, 0, 1 },
    { "spheres around and behind something opaque",
      [](Rig& rig)
      {
        AddSphere(rig, { 0.5f, 0.6f, 0.1f, 1.0f }, { 0.0, 0.0, 0.0 }, 0.3);
        AddSphere(rig, Red, { 0.1, 0.0, 0.2 }, 0.5);
        AddSphere(rig, Blue, { -0.1, 0.1, -0.7 }, 0.25);
      },
      0, 2, 0, 4 },
    { "the camera in a sphere",
      [](Rig& rig)
      {
        LookInPerspective(rig, { 0.0, 0.0, 0.5 }, 0.01);
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 1.0);
        AddSphere(rig, Blue, { 0.0, 0.0, -0.4 }, 0.2);
      },
      0, 0, 2 },
    { "clipped spheres",
      [](Rig& rig)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(1.0, 0.3, -0.8);
        AddSphere(rig, Red, { 0.1, 0.0, 0.5 }, 0.4)->GetMapper()->AddClippingPlane(plane);
        AddSphere(rig, Blue, { -0.1, 0.1, -0.5 }, 0.4)->GetMapper()->AddClippingPlane(plane);
      },
      0, 2, 0, 4 },
    { "a sphere and quads before and behind it",
      [](Rig& rig)
      {
        rig.AddQuad({ 0.1f, Green }, { 4, 4, 40, 40 });
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.5);
        rig.AddQuad({ 0.9f, Blue }, { 20, 10, 60, 44 });
      },
      0, 3, 0, 4 },
    { "a camera that turns the scene",
      [](Rig& rig)
      {
        LookInPerspective(rig, { 3.0, 1.0, 4.0 });
        vtkNew<vtkMatrix4x4> matrix; // by half a turn around y
        matrix->SetElement(0, 0, -1.0);
        matrix->SetElement(2, 2, -1.0);
        rig.Renderer->GetActiveCamera()->SetModelTransformMatrix(matrix);
        AddBox(rig, Red, { -1.0, -0.5, -0.5 }, { -0.1, 0.5, 0.5 });
        AddBox(rig, Blue, { 0.0, -0.5, -0.5 }, { 0.9, 0.5, 0.5 });
      },
      0, Any, Any },
    { "a camera that mirrors the scene",
      [](Rig& rig)
      {
        vtkNew<vtkMatrix4x4> matrix;
        matrix->SetElement(0, 0, -1.0);
        rig.Renderer->GetActiveCamera()->SetModelTransformMatrix(matrix);
        AddSphere(rig, Red, { 0.3, 0.0, 0.0 }, 0.6);
      },
      0, Any, Any },
    { "40 boxes behind each other",
      [](Rig& rig)
      {
        for (int i = 0; i < 40; ++i)
        {
          const double z = -0.9 + 0.045 * ((i * 7) % 40);
          AddBox(rig, i % 2 == 0 ? Red : Blue, { -0.7, -0.5, z }, { 0.7, 0.5, z + 0.02 });
        }
      },
      0, 40, 0, 80, 80 },
    { "a sphere that is not convex",
      [](Rig& rig)
      {
        vtkNew<vtkSphereSource> sphere;
        sphere->SetEndPhi(140.0);
        sphere->Update();
        rig.AddPolyData(sphere->GetOutput(), Red)->RotateX(60.0);
      },
      0, 0, 1 },
  };
}
}
