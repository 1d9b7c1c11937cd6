// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Opaque geometry hides translucent fragments exactly as the depth test would: intersecting,
// coplanar, with polygon offsets, and for lines and points.

#include "Oracle/ReferenceCompositor.h"
#include "Oracle/SingleLayer.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkLineSource.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

using namespace vtkOITTest;

namespace
{
const glm::vec4 Blue(0.1f, 0.3f, 0.9f, 1.0f);
const glm::vec4 Orange(0.9f, 0.5f, 0.1f, 0.375f);

void CheckIntersections(Report& report, Rig& rig, const Setup& setup)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.6);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  sphere->Update();
  rig.RemoveProps();
  rig.AddPolyData(sphere->GetOutput(), Blue);
  CheckSingleLayer(
    report, rig, setup, "quad through an opaque sphere", rig.AddQuad({ 0.4f, Orange }), Orange.a);

  rig.RemoveProps();
  rig.AddRamp(0.2, 0.8, Blue);
  CheckSingleLayer(report, rig, setup, "crossing ramps", rig.AddRamp(0.7, 0.3, Orange), Orange.a);

  rig.RemoveProps();
  rig.AddQuad({ 0.5f, Blue });
  CheckSingleLayer(report, rig, setup, "quad right behind an opaque one",
    rig.AddQuad({ 0.50000006f, Orange }), Orange.a, 0);
}

/// Same plane, same depth: the depth test of VTK lets equal depths pass.
void CheckCoplanar(Report& report, Rig& rig, const Setup& setup)
{
  rig.RemoveProps();
  rig.AddQuad({ 0.5f, Blue });
  CheckSingleLayer(report, rig, setup, "coplanar quads",
    rig.AddQuad({ 0.5f, Orange }, { 4.0, 5.0, 40.0, 30.0 }), Orange.a);
  rig.RemoveProps();
  rig.AddRamp(0.2, 0.8, Blue);
  CheckSingleLayer(
    report, rig, setup, "coplanar ramps", rig.AddRamp(0.2, 0.8, Orange), Orange.a, 20, 0);
}

/// An opaque quad in the middle of a stack of more layers than one peel takes: those behind it do
/// not show, the coplanar one does.
void CheckMiddleOfStack(Report& report, Rig& rig, const Setup& setup, int count)
{
  std::vector<Layer> layers = Random(count).Layers(count);
  layers.push_back({ 0.5f, Orange });
  std::vector<Layer> visible;
  for (Layer& layer : layers)
  {
    layer.Color.a *= 0.3f;
    if (layer.Depth <= 0.5f)
    {
      visible.push_back(layer);
    }
  }
  const PixelRectangle opaque{ 0.0, 0.0, 30.0, 48.0 };
  rig.RemoveProps();
  rig.AddQuad({ 0.5f, Blue }, opaque);
  rig.AddStack(layers);
  const glm::dvec4 background = rig.GetBackground();
  const glm::dvec4 left = ReferenceCompositor::Composite(visible, glm::dvec4(Blue));
  const glm::dvec4 right = ReferenceCompositor::Composite(layers, background);
  report.Compare(
    "opaque in the middle of " + std::to_string(count) + " layers", rig.Render(),
    [&](int x, int y) { return opaque.Contains(x, y) ? left : right; },
    ReferenceCompositor::RoundingBound(layers, background, setup.FragmentStorage));
  report.Check(rig.Pass->GetNumberOfFragments() < 0 ||
      rig.Pass->GetNumberOfFragments() ==
        vtkTypeInt64(visible.size()) * 30 * 48 + vtkTypeInt64(layers.size()) * 34 * 48,
    "opaque in the middle: " + std::to_string(rig.Pass->GetNumberOfFragments()) + " fragments");
}

/// Offsets, which VTK's mappers write to gl_FragDepth, decide between coplanar faces.
void CheckPolygonOffset(Report& report, Rig& rig, const Setup& setup)
{
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  for (const double units : { -200.0, 200.0 })
  {
    rig.RemoveProps();
    rig.AddQuad({ 0.5f, Blue });
    vtkActor* actor = rig.AddQuad({ 0.5f, Orange }, { 4.0, 5.0, 40.0, 30.0 });
    actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, units);
    CheckSingleLayer(report, rig, setup, "offset by " + std::to_string(int(units)) + " units",
      actor, Orange.a, units < 0.0 ? 20 : 0);
    if (units > 0.0)
    {
      const glm::dvec4 blue(Blue);
      report.Compare("offset behind, hidden", rig.Render(), Everywhere(blue), { 0.0, 0.0 });
    }
  }
  vtkMapper::SetResolveCoincidentTopologyToDefault();
}

/// Lines and points, partly inside an opaque sphere. Distant from each other: one fragment each.
void CheckLinesAndPoints(Report& report, Rig& rig, const Setup& setup)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.5);
  sphere->Update();
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-0.9, -0.5, 0.6);
  line->SetPoint2(0.9, 0.6, -0.2);
  line->Update();
  rig.RemoveProps();
  rig.AddPolyData(sphere->GetOutput(), Blue);
  vtkActor* actor = rig.AddPolyData(line->GetOutput(), Orange);
  CheckSingleLayer(report, rig, setup, "line", actor, Orange.a, 10);
  actor->GetProperty()->SetLineWidth(3.0);
  CheckSingleLayer(report, rig, setup, "wide line", actor, Orange.a, 30);

  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (int i = 0; i < 12; ++i)
  {
    vertices->InsertNextCell(1);
    vertices->InsertCellPoint(
      points->InsertNextPoint(-0.9 + 0.3 * (i % 6), i < 6 ? -0.2 : 0.3, i % 2 ? 0.5 : 0.0));
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->SetVerts(vertices);
  rig.RemoveProps();
  rig.AddPolyData(sphere->GetOutput(), Blue);
  actor = rig.AddPolyData(cloud, Orange);
  actor->GetProperty()->SetPointSize(4.0);
  CheckSingleLayer(report, rig, setup, "points", actor, Orange.a);
}

/// In the window: with and without samples and stencil, whose depths have other formats.
void CheckWindows(Report& report, const Setup& setup)
{
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  for (const int samples : { 0, 4 })
  {
    for (const int stencil : { 0, 1 })
    {
      const std::string what =
        std::to_string(samples) + " samples, stencil " + (stencil ? "on" : "off");
      Rig rig(setup, 20, 16);
      rig.Window->SetMultiSamples(samples);
      rig.Window->SetStencilCapable(stencil);
      rig.AddQuad({ 0.5f, Blue });
      vtkActor* actor = rig.AddQuad({ 0.5f, Orange });
      for (const double units : { -200.0, 200.0 })
      {
        actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, units);
        const glm::dvec4 expected = units > 0.0
          ? glm::dvec4(Blue)
          : ReferenceCompositor::Composite({ { 0.5f, Orange } }, glm::dvec4(Blue));
        report.Compare(what + (units > 0.0 ? ", behind" : ", in front"), rig.RenderWindow(),
          Everywhere(expected),
          ReferenceCompositor::RoundingBoundOfAnyStack(1, setup.FragmentStorage) +
            Rig::WindowTolerance());
      }
    }
  }
  vtkMapper::SetResolveCoincidentTopologyToDefault();
}
}

int TestOpaqueOcclusion(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(10);
      Rig rig(setup, 64, 48);
      CheckIntersections(report, rig, setup);
      CheckCoplanar(report, rig, setup);
      CheckPolygonOffset(report, rig, setup);
      if (setup.Promise == Expectation::Exact)
      {
        for (const int count : { 3, 12, 40 })
        {
          CheckMiddleOfStack(report, rig, setup, count);
        }
      }
      CheckLinesAndPoints(report, rig, setup);
      CheckWindows(report, setup);
    });
}
