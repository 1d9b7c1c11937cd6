// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Fragments that a shader discards are not captured: clipping planes of translucent and of opaque
// props.

#include "Oracle/ReferenceCompositor.h"
#include "Oracle/SingleLayer.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

using namespace vtkOITTest;

namespace
{
const glm::vec4 Orange(0.9f, 0.5f, 0.1f, 0.375f);

void AddClippingPlane(vtkActor* actor, double x, double y, double z, double offset)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(x, y, z);
  plane->SetOrigin(offset * x, offset * y, offset * z);
  actor->GetMapper()->AddClippingPlane(plane);
}
}

int TestClippingPlanes(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 64, 48);
      const glm::dvec4 background = rig.GetBackground();
      const PixelRectangle left{ 0.0, 0.0, 20.0, 48.0 };

      // Known without any rendering: what remains of the middle of three layers.
      std::vector<Layer> layers{ { 0.25f, { 0.9f, 0.1f, 0.1f, 0.5f } },
        { 0.5f, { 0.1f, 0.9f, 0.1f, 0.25f } }, { 0.75f, { 0.1f, 0.1f, 0.9f, 0.75f } } };
      const glm::dvec4 three = ReferenceCompositor::Composite(layers, background);
      const glm::dvec4 two = ReferenceCompositor::Composite({ layers[0], layers[2] }, background);
      rig.AddQuad(layers[0]);
      vtkActor* middle = rig.AddQuad(layers[1]);
      rig.AddQuad(layers[2]);
      AddClippingPlane(middle, -1.0, 0.0, 0.0, -rig.ToWorld(20.0, 0.0, 0.5).x);
      report.Compare(
        "the middle layer clipped", rig.Render(),
        [&](int x, int y) { return left.Contains(x, y) ? three : two; },
        ReferenceCompositor::RoundingBound(layers, background, setup.FragmentStorage));

      rig.RemoveProps();
      vtkActor* actor = rig.AddRamp(0.3, 0.7, Orange);
      AddClippingPlane(actor, 0.6, 0.8, 0.0, -0.3);
      AddClippingPlane(actor, 0.0, -1.0, 0.0, -0.6);
      CheckSingleLayer(report, rig, setup, "two planes through a ramp", actor, Orange.a);

      rig.RemoveProps();
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(0.7);
      sphere->Update();
      vtkActor* opaque = rig.AddPolyData(sphere->GetOutput(), { 0.1f, 0.3f, 0.9f, 1.0f });
      AddClippingPlane(opaque, 0.6, 0.0, -0.8, -0.2);
      CheckSingleLayer(report, rig, setup, "quad through a clipped opaque sphere",
        rig.AddQuad({ 0.4f, Orange }), Orange.a);
    });
}
