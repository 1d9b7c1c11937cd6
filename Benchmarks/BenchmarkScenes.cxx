// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkScenes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFlyingEdges3D.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <random>

namespace
{
void AddActor(
  vtkRenderer* renderer, vtkPolyDataAlgorithm* source, const double color[3], double opacity)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
}

void SetRainbow(double t, double color[3])
{
  for (int i = 0; i < 3; ++i)
  {
    color[i] = 0.55 + 0.45 * std::cos(6.2831853 * (t - i / 3.0));
  }
}

// 127 k triangles, about 4 fragments a pixel of the window.
void FillSpheres(vtkRenderer* renderer)
{
  constexpr int count = 16;
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> position(-0.5, 0.5);
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(64);
    sphere->SetPhiResolution(64);
    sphere->SetRadius(0.55);
    const double x = position(generator);
    const double y = position(generator);
    sphere->SetCenter(x, y, position(generator));
    double color[3];
    SetRainbow(i / double(count), color);
    AddActor(renderer, sphere, color, 0.4);
  }
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.3);
}

// 1.2 M triangles, up to 20 fragments a pixel.
void FillIsosurfaces(vtkRenderer* renderer)
{
  constexpr int count = 10;
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-50, 50, -50, 50, -50, 50);
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkFlyingEdges3D> surface;
    surface->SetInputConnection(wavelet->GetOutputPort());
    surface->SetValue(0, 60.0 + 20.0 * i);
    double color[3];
    SetRainbow(i / double(count), color);
    AddActor(renderer, surface, color, 0.3);
  }
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Azimuth(30.0);
  renderer->GetActiveCamera()->Elevation(20.0);
  renderer->GetActiveCamera()->Zoom(1.4);
  renderer->ResetCameraClippingRange();
}

// Few triangles, 64 fragments at every pixel of the middle.
void FillDeepStack(vtkRenderer* renderer)
{
  constexpr int count = 64;
  std::vector<int> order(count);
  for (int i = 0; i < count; ++i)
  {
    order[i] = (i * 37) % count; // neither front to back nor back to front
  }
  for (int i : order)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-1.0, -1.0, 0.02 * i);
    plane->SetPoint1(1.0, -1.0, 0.02 * i);
    plane->SetPoint2(-1.0, 1.0, 0.02 * i);
    double color[3];
    SetRainbow(i / double(count), color);
    AddActor(renderer, plane, color, 0.05);
  }
  renderer->ResetCamera();
}
}

//------------------------------------------------------------------------------
const std::vector<BenchmarkScene>& GetBenchmarkScenes()
{
  static const std::vector<BenchmarkScene> scenes = {
    { "spheres", "16 overlapping spheres", FillSpheres },
    { "isosurfaces", "10 nested isosurfaces of vtkRTAnalyticSource", FillIsosurfaces },
    { "deep", "64 planes behind each other", FillDeepStack },
  };
  return scenes;
}
