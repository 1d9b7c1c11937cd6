// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 11: a perspective camera with clipping planes at 1e-3 and 1e6. Layers are in the
// right order as long as the float32 window depth tells them apart, and where it does not they
// count as coincident.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <glm/vec2.hpp>

#include <cmath>

using namespace vtkOITTest;

namespace
{
constexpr double Near = 1e-3;
constexpr double Far = 1e6;

double ToWindowDepth(double distance)
{
  return Far / (Far - Near) * (1.0 - Near / distance);
}

/// A square across the view at the distance from the eye, which is in the origin.
vtkActor* AddSheet(Rig& rig, double distance, const glm::vec4& color)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 2, 3 });
  for (const glm::dvec2& corner :
    { glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1) })
  {
    points->InsertNextPoint(2.0 * distance * corner.x, 2.0 * distance * corner.y, -distance);
  }
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetPolys(quads);
  return rig.AddPolyData(polydata, color);
}

/// The window depth that the rasteriser makes of a sheet.
float MeasureDepth(Report& report, Rig& rig, double distance)
{
  rig.RemoveProps();
  AddSheet(rig, distance, { 1.0f, 1.0f, 1.0f, 1.0f });
  rig.Render();
  const Image& depths = rig.GetDepth();
  const float depth = depths.At(0, 0).r;
  bool isConstant = true;
  for (const glm::vec4& pixel : depths.Pixels)
  {
    isConstant = isConstant && pixel.r == depth;
  }
  report.Check(isConstant, "a sheet across the view has different depths");
  report.Check(std::abs(depth - ToWindowDepth(distance)) < 4e-7,
    "the depth at " + std::to_string(distance) + " is " + std::to_string(depth));
  return depth;
}

/// Layers from the distance on, so far apart that the nominal window depths differ by `steps`
/// steps of 2^-24; further away than float32 depths reach, by a factor.
void CheckSpacing(Report& report, Rig& rig, const Setup& setup, double distance, double steps)
{
  const std::string what =
    "at " + std::to_string(distance) + ", " + std::to_string(steps) + " steps";
  const int count = 5;
  std::vector<double> distances{ distance };
  for (int i = 1; i < count; ++i)
  {
    const double last = distances.back();
    const double next = Near / (Near / last - steps * std::ldexp(1.0, -24));
    distances.push_back(next > last && next < 0.5 * Far ? next : 2.0 * last);
  }
  std::vector<Layer> layers;
  Random random(11);
  int distinct = 1;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec4 color(random.Uniform(), random.Uniform(), random.Uniform(), 0.5);
    layers.push_back({ MeasureDepth(report, rig, distances[i]), glm::vec4(color) });
    report.Check(i == 0 || layers[i].Depth >= layers[i - 1].Depth, what + ": depths are reversed");
    distinct += i > 0 && layers[i].Depth > layers[i - 1].Depth;
  }
  // Steps between 0.5 and 1 are 2^-24; the projection in float32 rounds by some of them.
  report.Check(
    steps < 8.0 || distinct == count, what + ": " + std::to_string(distinct) + " depths");
  report.Check(steps > 0.01 || distinct < count, what + ": no two depths are equal");

  std::vector<int> order{ 0, 1, 2, 3, 4 };
  for (int i = 0; i < 3; ++i)
  {
    random.Shuffle(order);
    rig.RemoveProps();
    for (const int index : order)
    {
      AddSheet(rig, distances[index], layers[index].Color);
    }
    report.Compare(what + ", order " + std::to_string(i), rig.Render(),
      Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
  }
}
}

int TestDepthRange(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(11);
      Rig rig(setup, 8, 6);
      vtkCamera* camera = rig.Renderer->GetActiveCamera();
      camera->ParallelProjectionOff();
      camera->SetViewAngle(60.0);
      camera->SetPosition(0.0, 0.0, 0.0);
      camera->SetFocalPoint(0.0, 0.0, -1.0);
      camera->SetClippingRange(Near, Far);
      for (const double distance : { 0.0015, 0.01, 0.1, 1.0, 10.0 })
      {
        CheckSpacing(report, rig, setup, distance, 64.0);
        CheckSpacing(report, rig, setup, distance, 8.0);
        if (!setup.IsContender) // the window's depth buffer, which is read here, has 24 bits
        {
          CheckSpacing(report, rig, setup, distance, 0.01);
        }
      }
    });
}
