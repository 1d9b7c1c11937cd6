// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SkipScenes.h"

#include "TestRandom.h"
#include "TestRig.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

namespace vtkOITTest
{
namespace
{
/// Gives each side another brightness, so that the near and the far side are not mixed up unseen.
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

vtkActor* AddBox(
  TestRig& rig, const glm::vec4& color, const glm::dvec3& lower, const glm::dvec3& upper)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(lower.x, upper.x, lower.y, upper.y, lower.z, upper.z);
  cube->Update();
  PaintSides(cube->GetOutput(), color);
  vtkActor* actor = rig.AddPolyData(cube->GetOutput(), color);
  actor->GetProperty()->LightingOn();
  return actor;
}

void LookInPerspective(TestRig& rig, const glm::dvec3& from, double nearest = 0.5)
{
  vtkCamera* camera = rig.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(from.x, from.y, from.z);
  camera->SetClippingRange(nearest, 20.0);
}

void AddTexture(vtkActor* actor)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int i = 0; i < 8; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] =
      static_cast<unsigned char>(30 * i + 20);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOff();
  actor->SetTexture(texture);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const float x : { 0.0f, 1.0f, 1.0f, 0.0f })
  {
    coordinates->InsertNextTuple2(x, 0.5);
  }
  vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0))
    ->GetPointData()
    ->SetTCoords(coordinates);
}

/// Two quads that have a known order.
std::vector<vtkActor*> AddTwoQuads(TestRig& rig)
{
  return { rig.AddQuad({ 0.3f, Red }, { 4, 4, 40, 40 }),
    rig.AddQuad({ 0.6f, Green }, { 20, 10, 60, 44 }) };
}
}

//------------------------------------------------------------------------------
vtkActor* AddSphere(TestRig& rig, const glm::vec4& color, const glm::dvec3& center, double radius)
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

std::vector<Scene> GetInvisibleScenes()
{
  const auto with = [](const std::function<void(TestRig&, vtkActor*)>& change)
  { return [change](TestRig& rig) { change(rig, AddTwoQuads(rig)[0]); }; };
  return {
    { "opacity 0", with([](TestRig&, vtkActor* a) { a->GetProperty()->SetOpacity(0.0); }), 1, 1, 0,
      1 },
    { "opacity 0 of the front only",
      with(
        [](TestRig&, vtkActor* a)
        {
          a->GetProperty()->SetOpacity(0.0);
          vtkNew<vtkProperty> inside;
          inside->SetOpacity(0.5);
          a->SetBackfaceProperty(inside);
          a->RotateY(180.0);
        }),
      0, 2, 0, 1 },
    { "empty data",
      with([](TestRig&, vtkActor* a)
        { vtkPolyData::SafeDownCast(a->GetMapper()->GetInputDataObject(0, 0))->Initialize(); }),
      Any, 1, 0, 1 },
    { "outside of the view", with([](TestRig&, vtkActor* a) { a->SetPosition(5.0, 0.0, 0.0); }),
      Any, 1, 0, 1 }, // mostly VTK leaves it out
    { "before the near plane", with([](TestRig&, vtkActor* a) { a->SetPosition(0.0, 0.0, 0.7); }),
      1, 1, 0, 1 },
    { "behind the far plane", with([](TestRig&, vtkActor* a) { a->SetPosition(0.0, 0.0, -2.0); }),
      1, 1, 0, 1 },
    { "not visible", with([](TestRig&, vtkActor* a) { a->VisibilityOff(); }), 0, 1, 0, 1 },
    { "all of opacity 0",
      with(
        [](TestRig& rig, vtkActor* a)
        {
          a->GetProperty()->SetOpacity(0.0);
          rig.Renderer->GetActors()->GetLastActor()->GetProperty()->SetOpacity(0.0);
        }),
      2, 0, 0, 0 },
    { "behind the camera",
      [](TestRig& rig)
      {
        LookInPerspective(rig, { 0.0, 0.0, 5.0 });
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
        AddSphere(rig, Green, { 0.0, 0.0, 9.0 }, 0.8);
      },
      Any, Any, Any },
    { "beside the near plane, partly behind the camera",
      [](TestRig& rig)
      {
        LookInPerspective(rig, { 0.0, 0.0, 5.0 });
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
        AddBox(rig, Green, { -0.4, -0.4, 1.0 }, { -0.2, 0.4, 7.0 });
      },
      0, 0, 2 },
  };
}

std::vector<Scene> GetFlatScenes()
{
  const auto with = [](const std::function<void(vtkActor*)>& change)
  { return [change](TestRig& rig) { change(AddTwoQuads(rig)[0]); }; };
  return {
    { "disjoint quads",
      [](TestRig& rig)
      {
        rig.AddQuad({ 0.5f, Red }, { 2, 2, 20, 40 });
        rig.AddQuad({ 0.5f, Green }, { 30, 2, 60, 20 });
        rig.AddQuad({ 0.5f, Blue }, { 30, 30, 60, 44 });
      },
      0, 3, 0, 1, 1 },
    { "64 shuffled planes",
      [](TestRig& rig)
      {
        for (const Layer& layer : Random(12).Layers(64))
        {
          rig.AddQuad(layer);
        }
      },
      0, 64, 0, 1, 64 },
    { "two quads", with([](vtkActor*) {}), 0, 2, 0, 1 },
    { "texture", with(AddTexture), 0, 2, 0, 1 },
    { "mirrored quad", with([](vtkActor* a) { a->SetScale(-1.0, 1.0, 1.0); }), 0, 2, 0, 1 },
    { "crossing quads",
      [](TestRig& rig)
      {
        rig.AddRamp(0.2, 0.7, Red);
        rig.AddRamp(0.8, 0.3, Green);
      },
      0, 0, 2 },
    { "tilted quads, one behind the other",
      [](TestRig& rig)
      {
        rig.AddRamp(0.1, 0.4, Red);
        rig.AddRamp(0.9, 0.5, Green);
      },
      0, 2, 0, 1 },
    { "wireframe", with([](vtkActor* a) { a->GetProperty()->SetRepresentationToWireframe(); }), 0,
      0, 2 },
    { "edges", with([](vtkActor* a) { a->GetProperty()->EdgeVisibilityOn(); }), 0, 0, 2 },
    { "points", with([](vtkActor* a) { a->GetProperty()->SetRepresentationToPoints(); }), 0, 0, 2 },
    { "equal depths",
      [](TestRig& rig)
      {
        rig.AddQuad({ 0.5f, Red }, { 4, 4, 40, 40 });
        rig.AddQuad({ 0.5f, Green }, { 20, 10, 60, 44 });
      },
      0, 0, 2 },
    { "the same actor twice",
      [](TestRig& rig)
      {
        vtkActor* actor = AddTwoQuads(rig)[0];
        vtkNew<vtkActor> copy;
        copy->ShallowCopy(actor);
        rig.Renderer->AddActor(copy);
      },
      0, 0, 3 },
    { "polygon offset",
      [](TestRig& rig)
      {
        AddTwoQuads(rig);
        vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
      },
      0, 0, 2 },
    { "clipped quads",
      [](TestRig& rig)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(1.0, 0.7, 0.0);
        plane->SetOrigin(0.0123, 0.0, 0.0); // through no centre of a pixel
        for (vtkActor* actor : AddTwoQuads(rig))
        {
          actor->GetMapper()->AddClippingPlane(plane);
        }
      },
      0, 2, 0, 1 },
    { "quads and a sphere elsewhere on the screen",
      [](TestRig& rig)
      {
        rig.AddQuad({ 0.3f, Red }, { 2, 4, 24, 40 });
        rig.AddQuad({ 0.6f, Green }, { 8, 10, 28, 44 });
        AddSphere(rig, Blue, { 0.7, 0.2, 0.0 }, 0.3);
        AddSphere(rig, Red, { 0.8, -0.2, 0.0 }, 0.3);
      },
      0, 2, 2 },
  };
}

std::vector<Scene> GetClosedScenes()
{
  return {
    { "a sphere",
      [](TestRig& rig) {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
      },
      0, 1, 0, 2 },
    { "two spheres beside each other",
      [](TestRig& rig)
      {
        AddSphere(rig, Red, { -0.6, 0.0, 0.0 }, 0.4);
        AddSphere(rig, Blue, { 0.6, 0.0, 0.0 }, 0.4);
      },
      0, 2, 0, 2 },
    { "two spheres behind each other",
      [](TestRig& rig)
      {
        AddSphere(rig, Red, { 0.1, 0.0, 0.5 }, 0.4);
        AddSphere(rig, Blue, { -0.1, 0.1, -0.5 }, 0.4);
      },
      0, 2, 0, 4 },
    { "a sphere in a sphere",
      [](TestRig& rig)
      {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
        AddSphere(rig, Blue, { 0.1, -0.1, 0.1 }, 0.4);
      },
      0, 2, 0, 4 },
    { "spheres, boxes and quads in spheres, given from the inside",
      [](TestRig& rig)
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
      [](TestRig& rig)
      {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.4)->SetScale(2.0, 1.0, 1.0);
        AddSphere(rig, Blue, { 0.5, 0.0, 0.0 }, 0.2);
      },
      0, 0, 2 },
    { "a box whose corners look out of a sphere",
      [](TestRig& rig)
      {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.6);
        AddBox(rig, Blue, { -0.4, -0.4, -0.4 }, { 0.4, 0.4, 0.4 });
      },
      0, 0, 2 },
    { "a sphere that touches the one around it",
      [](TestRig& rig)
      {
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.8);
        AddSphere(rig, Blue, { 0.0, 0.0, 0.4 }, 0.4);
      },
      0, 0, 2 },
    { "crossing spheres",
      [](TestRig& rig)
      {
        AddSphere(rig, Red, { 0.2, 0.0, 0.1 }, 0.5);
        AddSphere(rig, Blue, { -0.2, 0.1, -0.1 }, 0.5);
      },
      0, 0, 2 },
    { "boxes beside each other in perspective",
      [](TestRig& rig)
      {
        LookInPerspective(rig, { 3.0, 1.0, 4.0 });
        AddBox(rig, Red, { -1.0, -0.5, -0.5 }, { -0.1, 0.5, 0.5 });
        AddBox(rig, Blue, { 0.0, -0.5, -0.5 }, { 0.9, 0.5, 0.5 });
      },
      0, 2, 0, 4 },
    { "boxes beside each other, seen from the other side",
      [](TestRig& rig)
      {
        LookInPerspective(rig, { -3.0, 1.0, 4.0 });
        AddBox(rig, Red, { -1.0, -0.5, -0.5 }, { -0.1, 0.5, 0.5 });
        AddBox(rig, Blue, { 0.0, -0.5, -0.5 }, { 0.9, 0.5, 0.5 });
      },
      0, 2, 0, 4 },
    { "crossing boxes",
      [](TestRig& rig)
      {
        LookInPerspective(rig, { 3.0, 1.0, 4.0 });
        AddBox(rig, Red, { -1.0, -0.5, -0.5 }, { 0.1, 0.5, 0.5 });
        AddBox(rig, Blue, { 0.0, -0.5, -0.5 }, { 0.9, 0.5, 0.6 });
      },
      0, 0, 2 },
    { "boxes that touch",
      [](TestRig& rig)
      {
        LookInPerspective(rig, { 3.0, 1.0, 4.0 });
        AddBox(rig, Red, { -1.0, -0.5, -0.5 }, { 0.0, 0.5, 0.5 });
        AddBox(rig, Blue, { 0.0, -0.5, -0.5 }, { 0.9, 0.5, 0.5 });
      },
      0, 0, 2 },
    { "three bars in a cycle",
      [](TestRig& rig)
      {
        // Each is in front of the next one; axis planes tell so, in pairs.
        LookInPerspective(rig, { 3.0, 3.0, 3.0 });
        AddBox(rig, Red, { -1.0, -0.2, 0.0 }, { 1.0, 0.0, 0.2 });
        AddBox(rig, Green, { 0.01, -1.0, -0.2 }, { 0.21, 1.0, -0.01 });
        AddBox(rig, Blue, { -0.2, 0.01, -1.0 }, { 0.0, 0.21, 1.0 });
      },
      0, 0, 3, Any, 6 },
    { "mirrored sphere",
      [](TestRig& rig) { AddSphere(rig, Red, {}, 0.7)->SetScale(-1.0, 0.8, 1.0); }, 0, 1, 0, 2 },
    { "sphere inside out",
      [](TestRig& rig)
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
      [](TestRig& rig)
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
      [](TestRig& rig) { AddSphere(rig, Red, {}, 0.7)->GetProperty()->BackfaceCullingOn(); }, 0, 0,
      1 },
    { "spheres around and behind something opaque",
      [](TestRig& rig)
      {
        AddSphere(rig, { 0.5f, 0.6f, 0.1f, 1.0f }, { 0.0, 0.0, 0.0 }, 0.3);
        AddSphere(rig, Red, { 0.1, 0.0, 0.2 }, 0.5);
        AddSphere(rig, Blue, { -0.1, 0.1, -0.7 }, 0.25);
      },
      0, 2, 0, 4 },
    { "the camera in a sphere",
      [](TestRig& rig)
      {
        LookInPerspective(rig, { 0.0, 0.0, 0.5 }, 0.01);
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 1.0);
        AddSphere(rig, Blue, { 0.0, 0.0, -0.4 }, 0.2);
      },
      0, 0, 2 },
    { "clipped spheres",
      [](TestRig& rig)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(1.0, 0.3, -0.8);
        AddSphere(rig, Red, { 0.1, 0.0, 0.5 }, 0.4)->GetMapper()->AddClippingPlane(plane);
        AddSphere(rig, Blue, { -0.1, 0.1, -0.5 }, 0.4)->GetMapper()->AddClippingPlane(plane);
      },
      0, 2, 0, 4 },
    { "a sphere and quads before and behind it",
      [](TestRig& rig)
      {
        rig.AddQuad({ 0.1f, Green }, { 4, 4, 40, 40 });
        AddSphere(rig, Red, { 0.0, 0.0, 0.0 }, 0.5);
        rig.AddQuad({ 0.9f, Blue }, { 20, 10, 60, 44 });
      },
      0, 3, 0, 4 },
    { "a camera that turns the scene",
      [](TestRig& rig)
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
      [](TestRig& rig)
      {
        vtkNew<vtkMatrix4x4> matrix;
        matrix->SetElement(0, 0, -1.0);
        rig.Renderer->GetActiveCamera()->SetModelTransformMatrix(matrix);
        AddSphere(rig, Red, { 0.3, 0.0, 0.0 }, 0.6);
      },
      0, Any, Any },
    { "40 boxes behind each other",
      [](TestRig& rig)
      {
        for (int i = 0; i < 40; ++i)
        {
          const double z = -0.9 + 0.045 * ((i * 7) % 40);
          AddBox(rig, i % 2 == 0 ? Red : Blue, { -0.7, -0.5, z }, { 0.7, 0.5, z + 0.02 });
        }
      },
      0, 40, 0, 80, 80 },
    { "a sphere that is not convex",
      [](TestRig& rig)
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
