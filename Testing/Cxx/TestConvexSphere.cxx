// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 22: every pixel of a closed convex mesh has exactly two layers, at the silhouette
// too, or none.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cmath>

using namespace vtkOITTest;

int TestConvexSphere(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(22);
      Rig rig(setup, 97, 83);
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(0.8);
      sphere->SetThetaResolution(61);
      sphere->SetPhiResolution(47);
      sphere->Update();
      const glm::vec4 color(0.9f, 0.3f, 0.1f, 0.25f);
      vtkActor* actor = rig.AddPolyData(sphere->GetOutput(), color);
      actor->RotateX(33.0);
      actor->RotateY(21.0);

      const std::vector<Layer> two{ { 0.25f, color }, { 0.75f, color } };
      const glm::dvec4 background = rig.GetBackground();
      const glm::dvec4 inside = ReferenceCompositor::Composite(two, background);
      const Tolerance bound =
        ReferenceCompositor::RoundingBound(two, background, setup.FragmentStorage);
      const Image image = rig.Render();
      int covered = 0;
      report.Compare(
        "two layers or none", image,
        [&](int x, int y)
        {
          // The geometry decides well inside and outside; between them the pixel's own colour,
          // which then must be exactly one of the two.
          const double radius = std::hypot(x + 0.5 - 48.5, y + 0.5 - 41.5) / 41.5;
          const bool isCovered =
            radius < 0.78 || (radius < 0.82 && std::abs(image.At(x, y).r - background.r) > 0.01);
          covered += isCovered;
          return isCovered ? inside : background;
        },
        bound);
      report.Check(
        rig.Pass->GetNumberOfFragments() < 0 || rig.Pass->GetNumberOfFragments() % 2 == 0,
        "an odd number of fragments: " + std::to_string(rig.Pass->GetNumberOfFragments()));
      const double area = std::acos(-1.0) * 0.64 * 41.5 * 41.5;
      report.Check(std::abs(covered - area) < 0.02 * area,
        "covered pixels: " + std::to_string(covered) +
          ", area of the disc: " + std::to_string(area));
    });
}
