// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 25: shaders that write gl_FragDepth are sorted by that depth, among translucent
// layers: polygon offsets, depths from a shader, and sphere impostors against the sphere's
// equation.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/FragmentColor.h"
#include "Scenes/Random.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 64;
constexpr int Height = 48;

/// Quads that say they are at the depth of their geometry and write another one.
void CheckWrittenDepths(Report& report, Rig& rig, const Setup& setup)
{
  Random random(25);
  std::vector<Layer> layers = random.Layers(6);
  for (int order = 0; order < 3; ++order)
  {
    rig.RemoveProps();
    for (const Layer& layer : layers)
    {
      vtkActor* actor = rig.AddQuad({ 1.0f - layer.Depth, layer.Color });
      vtkShaderProperty* shaders = actor->GetShaderProperty();
      shaders->AddFragmentShaderReplacement(
        "//VTK::Depth::Impl", true, "//VTK::Depth::Impl\n  gl_FragDepth = testDepth;\n", false);
      shaders->GetFragmentCustomUniforms()->SetUniformf("testDepth", layer.Depth);
    }
    report.Compare("depths written by shaders, order " + std::to_string(order), rig.Render(),
      Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
    random.Shuffle(layers);
  }
}

/// A sphere impostor with a translucent quad through it. Of a ray through the sphere VTK draws the
/// near side, and for translucent props the far side in the same place or not at all; so the quad
/// is compared where it is in front of all of the sphere, and behind its near side.
void CheckSpheres(Report& report, Rig& rig, const Setup& setup, float depth)
{
  const double radius = 0.7;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.1, -0.05, 0.0);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->InsertNextTuple3(50, 150, 230);
  vtkNew<vtkPolyData> polydata;
  polydata->SetPoints(points);
  polydata->SetVerts(vertices);
  polydata->GetPointData()->SetScalars(colors);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(polydata);
  mapper->SetRadius(radius);
  vtkNew<vtkActor> sphere;
  sphere->SetMapper(mapper);
  sphere->GetProperty()->SetOpacity(0.5);
  sphere->GetProperty()->LightingOff();
  rig.RemoveProps();
  rig.Renderer->AddActor(sphere);
  const Image alone = rig.Render();
  const Layer quad{ depth, { 0.9f, 0.1f, 0.2f, 0.625f } };
  rig.AddQuad(quad);
  const Image image = rig.Render();

  const glm::dvec4 background = rig.GetBackground();
  const glm::dvec4 over = ReferenceCompositor::Composite({ quad }, background);
  const double alpha = quad.Color.a;
  int inFront = 0;
  int behind = 0;
  const auto expected = [&](int x, int y) -> glm::dvec4
  {
    const glm::dvec3 world = rig.ToWorld(x + 0.5, y + 0.5, depth);
    const double squared =
      radius * radius - (world.x - 0.1) * (world.x - 0.1) - (world.y + 0.05) * (world.y + 0.05);
    const glm::dvec4 sphereAlone(alone.At(x, y));
    if (std::abs(squared) < 0.06) // the outline, where the depth of the sphere is steep
    {
      return glm::dvec4(image.At(x, y));
    }
    if (squared < 0.0)
    {
      return over;
    }
    const double nearSide = std::sqrt(squared);
    if (world.z > nearSide + 0.02)
    {
      ++inFront; // the quad over what the sphere alone looks like
      return alpha * glm::dvec4(quad.Color.r, quad.Color.g, quad.Color.b, 1.0) +
        (1.0 - alpha) * sphereAlone;
    }
    if (world.z < -nearSide - 0.02)
    {
      ++behind; // the sphere over what the quad alone looks like: T is 1 - a for every layer
      const double transmittance = (1.0 - sphereAlone.a) / (1.0 - background.a);
      return sphereAlone + transmittance * (over - background);
    }
    return glm::dvec4(image.At(x, y));
  };
  const std::string what = "sphere impostor and a quad at " + std::to_string(depth);
  report.Compare(what, image, expected,
    ReferenceCompositor::RoundingBoundOfAnyStack(3, setup.FragmentStorage) +
      ReferenceCompositor::RoundingBoundOfAnyStack(3, setup.FragmentStorage));
  report.Check((inFront > 40) == (depth < 0.5f),
    what + ": " + std::to_string(inFront) + " pixels with the quad in front");
  report.Check((behind > 40) == (depth > 0.5f),
    what + ": " + std::to_string(behind) + " pixels with the quad behind");
}
}

int TestFragmentDepth(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(25);
      Rig rig(setup, Width, Height);
      CheckWrittenDepths(report, rig, setup);
      for (const float depth : { 0.125f, 0.25f, 0.875f })
      {
        if (!setup.IsContender || depth < 0.5f) // behind, the answer needs alpha to be right
        {
          CheckSpheres(report, rig, setup, depth);
        }
      }
    });
}
