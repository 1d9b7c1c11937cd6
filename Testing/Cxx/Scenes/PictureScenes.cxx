// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/PictureScenes.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkContourFilter.h"
#include "vtkCylinderSource.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <map>

namespace vtkOITTest
{
namespace
{
vtkSmartPointer<vtkRenderer> AddRenderer(vtkRenderWindow* window, double x0, double x1)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(0.95, 0.95, 0.9);
  renderer->SetBackgroundAlpha(1.0);
  window->AddRenderer(renderer);
  // VTK 9.1 remembers for which viewport the aspect was computed in members that it does not
  // initialize: in the memory of a renderer that is gone, it takes 1 for the aspect of the same
  // viewport, and ResetCamera() goes wrong.
  renderer->SetViewport(0.125, 0.25, 0.5, 0.75);
  renderer->ComputeAspect();
  renderer->SetViewport(x0, 0.0, x1, 1.0);
  return renderer;
}

/// A colour of a rainbow; t in [0,1].
void SetColor(vtkActor* actor, double t, double opacity)
{
  const double pi = std::acos(-1.0);
  actor->GetProperty()->SetColor(0.5 + 0.4 * std::cos(2.0 * pi * t),
    0.5 + 0.4 * std::cos(2.0 * pi * (t - 1.0 / 3.0)),
    0.5 + 0.4 * std::cos(2.0 * pi * (t - 2.0 / 3.0)));
  actor->GetProperty()->SetOpacity(opacity);
}

vtkSmartPointer<vtkActor> AddSource(vtkRenderer* renderer, vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

void AddSpheres(vtkRenderer* renderer, int count, double opacity)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(32);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.4 * i; // the golden angle: evenly spread, nothing coincides
    const auto actor = AddSource(renderer, sphere);
    actor->SetPosition(
      0.4 * std::cos(angle), 0.4 * std::sin(angle), 0.25 * std::sin(1.7 * i) + 0.01 * i);
    SetColor(actor, double(i) / count, opacity);
  }
}

void Frame(vtkRenderer* renderer, double azimuth, double elevation)
{
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Azimuth(azimuth);
  renderer->GetActiveCamera()->Elevation(elevation);
  renderer->GetActiveCamera()->Zoom(1.3);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void BuildNestedIsosurfaces(vtkRenderWindow* window)
{
  const auto renderer = AddRenderer(window, 0.0, 1.0);
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-20, 20, -20, 20, -20, 20);
  for (int i = 0; i < 6; ++i)
  {
    vtkNew<vtkContourFilter> contour;
    contour->SetInputConnection(wavelet->GetOutputPort());
    contour->SetValue(0, 90.0 + 25.0 * i);
    SetColor(AddSource(renderer, contour), i / 6.0, 0.3);
  }
  Frame(renderer, 30.0, 25.0);
}

//------------------------------------------------------------------------------
void BuildOverlappingSpheres(vtkRenderWindow* window)
{
  const auto renderer = AddRenderer(window, 0.0, 1.0);
  AddSpheres(renderer, 10, 0.35);
  renderer->GetActors()->GetLastActor()->GetProperty()->SetOpacity(1.0);
  Frame(renderer, 20.0, 15.0);
}

//------------------------------------------------------------------------------
void BuildImpostors(vtkRenderWindow* window)
{
  const auto renderer = AddRenderer(window, 0.0, 1.0);
  for (int part = 0; part < 2; ++part)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> vertices; // for the bounds
    for (int i = 0; i < 9; ++i)
    {
      const int row = i / 3;
      vertices->InsertNextCell(1);
      vertices->InsertCellPoint(
        points->InsertNextPoint(i % 3 - 1.0 + 0.5 * part, row - 1.0, 0.3 * std::sin(5.0 * i)));
    }
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points);
    cloud->SetVerts(vertices);
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(cloud);
    mapper->SetRadius(part ? 0.35f : 0.6f);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    SetColor(actor, 0.4 * part + 0.1, part ? 1.0 : 0.4);
    renderer->AddActor(actor);
  }
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.8, -1.8, 0.1);
  plane->SetPoint1(1.8, -1.8, 0.1);
  plane->SetPoint2(-1.8, 1.8, 0.1);
  SetColor(AddSource(renderer, plane), 0.8, 0.5);
  Frame(renderer, 35.0, 20.0);
}

//------------------------------------------------------------------------------
void BuildClippingPlanes(vtkRenderWindow* window)
{
  const auto renderer = AddRenderer(window, 0.0, 1.0);
  for (int i = 0; i < 4; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0 - 0.2 * i);
    sphere->SetThetaResolution(64);
    sphere->SetPhiResolution(64);
    const auto actor = AddSource(renderer, sphere);
    SetColor(actor, i / 4.0, i == 3 ? 1.0 : 0.4);
    vtkNew<vtkPlane> plane;
    plane->SetNormal(-0.6, -0.3 * i, -0.5);
    plane->SetOrigin(0.3 - 0.05 * i, 0.0, 0.2);
    actor->GetMapper()->AddClippingPlane(plane);
  }
  Frame(renderer, 40.0, 20.0);
}

//------------------------------------------------------------------------------
void BuildTextures(vtkRenderWindow* window)
{
  const auto renderer = AddRenderer(window, 0.0, 1.0);
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(16, 16, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    for (int y = 0; y < 16; ++y)
    {
      for (int x = 0; x < 16; ++x)
      {
        const bool isHole = (x / 4 + y / 4) % 2 == 0;
        auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
        texel[0] = static_cast<unsigned char>(i == 0 ? 230 : 16 * x);
        texel[1] = static_cast<unsigned char>(i == 1 ? 200 : 12 * y);
        texel[2] = static_cast<unsigned char>(i == 2 ? 240 : 30);
        texel[3] = static_cast<unsigned char>(isHole ? 0 : (x + y) % 5 == 0 ? 255 : 140);
      }
    }
    vtkNew<vtkTexture> texture;
    texture->SetInputData(image);
    texture->InterpolateOff();
    texture->SetColorModeToDirectScalars();
    vtkNew<vtkPlaneSource> plane;
    const auto actor = AddSource(renderer, plane);
    actor->SetTexture(texture);
    actor->RotateY(60.0 * i);
    actor->RotateX(20.0 * i);
    actor->GetProperty()->LightingOff();
  }
  Frame(renderer, 25.0, 20.0);
}

//------------------------------------------------------------------------------
void BuildMultisampling(vtkRenderWindow* window)
{
  window->SetMultiSamples(4);
  const auto renderer = AddRenderer(window, 0.0, 1.0);
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(24);
  cylinder->SetHeight(2.5);
  cylinder->SetRadius(0.25);
  for (int i = 0; i < 6; ++i)
  {
    const auto actor = AddSource(renderer, cylinder);
    actor->RotateZ(30.0 * i + 7.0);
    actor->RotateX(11.0 * i);
    SetColor(actor, i / 6.0, i == 2 ? 1.0 : 0.4);
  }
  Frame(renderer, 10.0, 10.0);
}

//------------------------------------------------------------------------------
void BuildTransparentBackground(vtkRenderWindow* window)
{
  const auto renderer = AddRenderer(window, 0.0, 1.0);
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->SetBackgroundAlpha(0.0);
  AddSpheres(renderer, 5, 0.3);
  Frame(renderer, 0.0, 30.0);
}

//------------------------------------------------------------------------------
void BuildViewports(vtkRenderWindow* window)
{
  window->SetNumberOfLayers(2);
  const auto left = AddRenderer(window, 0.0, 0.45);
  AddSpheres(left, 6, 0.4);
  Frame(left, 0.0, 0.0);
  const auto right = AddRenderer(window, 0.45, 1.0);
  right->SetBackground(0.1, 0.1, 0.3);
  AddSpheres(right, 9, 0.25);
  Frame(right, 50.0, 20.0);
  const auto top = AddRenderer(window, 0.2, 0.8);
  top->SetLayer(1);
  AddSpheres(top, 3, 0.5);
  Frame(top, 0.0, 70.0);
}

const std::map<std::string, void (*)(vtkRenderWindow*)> Builders = {
  { "ClippingPlanes", BuildClippingPlanes },
  { "Impostors", BuildImpostors },
  { "Multisampling", BuildMultisampling },
  { "NestedIsosurfaces", BuildNestedIsosurfaces },
  { "OverlappingSpheres", BuildOverlappingSpheres },
  { "Textures", BuildTextures },
  { "TransparentBackground", BuildTransparentBackground },
  { "Viewports", BuildViewports },
};
}

//------------------------------------------------------------------------------
bool BuildScene(
  const std::string& name, vtkRenderWindow* window, const std::function<void(vtkRenderer*)>& attach)
{
  const auto builder = Builders.find(name);
  if (builder == Builders.end())
  {
    return false;
  }
  builder->second(window);
  vtkCollectionSimpleIterator iterator;
  vtkRendererCollection* renderers = window->GetRenderers();
  renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(iterator))
  {
    attach(renderer);
  }
  return true;
}
}
