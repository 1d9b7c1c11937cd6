// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// What the automatic pass leaves out or blends, scene by scene: each must be skipped as far as its
// order is known and no further, and skipping must not change the picture.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"
#include "Scenes/SkipScenes.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOITAutoPass.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <string>
#include <vector>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 64;
constexpr int Height = 48;

vtkOITAutoPass* GetPass(Rig& rig)
{
  return vtkOITAutoPass::SafeDownCast(rig.Pass);
}

void CheckCounts(Report& report, const Setup& setup, Rig& rig, const SkipScene& scene)
{
  vtkOITAutoPass* pass = GetPass(rig);
  const std::string summary = pass->GetSkipSummary();
  const auto check = [&](int count, const std::string& words)
  {
    const std::string expected = std::to_string(count) + " of ";
    const bool isThere = summary.find(words) != std::string::npos;
    report.Check(count == Any || (count == 0 ? !isThere : isThere), scene.Name + ": " + summary);
    report.Check(count <= 0 || summary.find(expected) != std::string::npos,
      scene.Name + ": " + summary + ", expected " + expected);
  };
  check(scene.Invisible, "left out: invisible");
  check(scene.Blended, "blended: their order is known");
  const std::string name = pass->GetAlgorithmName();
  const std::string sorter = setup.HasStorage ? "A-buffer" : "dual depth peeling";
  if (scene.Sorted != Any)
  {
    const std::string expected = scene.Sorted > 0 ? sorter
      : scene.Blended > 0                         ? "ordered blending"
                                                  : "automatic choice";
    report.Check(name == expected, scene.Name + ": drawn by " + name + ", expected " + expected);
    report.Check(pass->GetAlgorithmReason().empty() == (scene.Sorted == 0 && scene.Blended == 0),
      scene.Name + ": the choice is " + pass->GetAlgorithmReason());
  }
  report.Check(scene.Passes == Any || pass->GetNumberOfGeometryPasses() == scene.Passes,
    scene.Name + ": " + std::to_string(pass->GetNumberOfGeometryPasses()) +
      " geometry passes, expected " + std::to_string(scene.Passes));
  report.Check(pass->GetExact() && pass->GetErrorBound() == 0.0, scene.Name + ": is not exact");
  if (scene.Passes == 0)
  {
    report.Check(pass->GetBufferSizeInBytes() == 0, scene.Name + ": there are buffers");
  }
}

void CheckScene(Report& report, const Setup& setup, const SkipScene& scene)
{
  Rig rig(setup, Width, Height);
  vtkOITAutoPass* pass = GetPass(rig);
  pass->ReuseFramesOff();
  scene.Build(rig);
  const Image image = rig.Render();
  CheckCounts(report, setup, rig, scene);
  const Image window = rig.RenderWindow();

  // Only leaving props out: the others are drawn as before.
  pass->SkipInvisiblePropsOff();
  const Image withInvisible = rig.Render();
  report.Check(pass->GetSkipSummary().find("invisible") == std::string::npos,
    scene.Name + ": props are left out though it is off");
  if (scene.Sorted == 0)
  {
    report.Compare(scene.Name + ", with invisible props", image, withInvisible,
      ReferenceCompositor::RoundingBoundOfAnyStack(scene.Layers, setup.FragmentStorage));
  }
  pass->SkipSortingOff();
  const Image sorted = rig.Render();
  report.Check(pass->GetSkipSummary().empty(), scene.Name + ": skips " + pass->GetSkipSummary());
  // The compiler may round lighting otherwise in another shader.
  const Tolerance bound =
    ReferenceCompositor::RoundingBoundOfAnyStack(scene.Layers, setup.FragmentStorage) +
    Tolerance{ 1e-5, 0.0 };
  report.Compare(scene.Name + ", sorted", image, sorted, bound);
  // Two roundings to 8 bits, or two 8-bit blends, of nearly the same.
  const double step = (setup.HasFetch ? 1.0 : 2.0) / 255.0 + 1e-6;
  report.Compare(scene.Name + ", sorted, in 8 bits", window, rig.RenderWindow(), { step, step });
  vtkMapper::SetResolveCoincidentTopologyToOff();
}

/// A camera that moves the scene is the same as props that are moved.
void CheckModelTransform(Report& report, const Setup& setup)
{
  Rig moved(setup, Width, Height);
  Rig rig(setup, Width, Height);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, -1.5);
  matrix->SetElement(2, 2, -1.0); // to and fro change places
  rig.Renderer->GetActiveCamera()->SetModelTransformMatrix(matrix);
  for (const double z : { -0.5, 0.5 })
  {
    const glm::vec4 color = z < 0.0 ? Red : Green;
    for (vtkActor* actor : { AddSphere(moved, color, { z * 0.2, 0.0, -z }, 0.3),
           AddSphere(rig, color, { z * 0.2 + 1.5, 0.0, z }, 0.3) })
    {
      actor->GetProperty()->LightingOff();
      actor->GetMapper()->ScalarVisibilityOff();
    }
  }
  const Image expected = moved.Render();
  const double step = 1e-3; // half floats, and none of them in the one that is blended
  report.Compare("model transform of the camera", rig.Render(), expected, { step, step });
}

/// The A-buffer leaves out what solid texels hide, from the second frame on, unless it is off.
void CheckHiddenFragments(Report& report, const Setup& setup)
{
  Rig rig(setup, 200, 150);
  vtkOITAutoPass* pass = GetPass(rig);
  pass->ReuseFramesOff();
  pass->SkipSortingOff();
  rig.AddQuad({ 0.1f, Green })->GetProperty()->SetOpacity(1.0);
  rig.Renderer->GetActors()->GetLastActor()->ForceTranslucentOn();
  rig.AddEqualLayers({ 0.2f, 0.3f, 0.4f, 0.5f }, Red);
  Image images[2];
  for (const bool isOn : { true, false })
  {
    pass->SetSkipHiddenFragments(isOn);
    rig.Render();
    images[isOn] = rig.Render();
    const bool isSkipped = pass->GetSkipSummary() == "fragments behind those of opacity 1 left out";
    report.Check(isSkipped == (isOn && setup.HasStorage),
      std::string("hidden fragments, ") + (isOn ? "on: " : "off: ") + pass->GetSkipSummary());
  }
  report.CompareBits("hidden fragments", images[1], images[0]);
}

/// Drawn twice, 40 props of a few pixels each cost more than an A-buffer of them, but less than
/// peeling them.
void CheckManySmall(Report& report, const Setup& setup)
{
  Rig rig(setup, Width, Height);
  GetPass(rig)->ReuseFramesOff();
  for (int i = 0; i < 40; ++i)
  {
    const int row = i / 8;
    AddSphere(rig, i % 2 == 0 ? Red : Blue, { 0.25 * (i % 8) - 0.9, 0.35 * row - 0.7, 0.0 }, 0.05);
  }
  rig.Render();
  const std::string expected =
    setup.HasStorage ? "" : "40 of 40 props blended: their order is known";
  report.Check(GetPass(rig)->GetSkipSummary() == expected,
    "many small spheres: \"" + GetPass(rig)->GetSkipSummary() + "\", expected \"" + expected +
      "\"");
}

/// Against the definition, not only against the other method.
void CheckPlanes(Report& report, const Setup& setup)
{
  Rig rig(setup, Width, Height);
  const std::vector<Layer> layers = Random(12).Layers(64);
  for (const Layer& layer : layers)
  {
    rig.AddQuad(layer);
  }
  const Report::Expected expected =
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground()));
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), Storage::Float32);
  rig.Render(); // makes default lookup tables, which is a change
  for (const char* frame : { "planes, drawn", "planes, kept", "planes, reused" })
  {
    report.Compare(frame, rig.Render(), expected, bound);
  }
  report.Check(rig.Pass->GetNumberOfGeometryPasses() == 0, "the third frame is not reused");
  const double half = setup.HasFetch ? 0.5 / 255.0 : 1.5 / 255.0;
  report.Compare("planes in 8 bits", rig.RenderWindow(), expected, bound + Tolerance{ half, half });
}
}

int TestAutoPassSkips(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [&](Report& report, const Setup& setup)
    {
      std::vector<std::vector<SkipScene>> parts;
      if (IsAsked(argc, argv, "flat"))
      {
        parts = { GetInvisibleScenes(), GetFlatScenes() };
      }
      if (IsAsked(argc, argv, "partial"))
      {
        parts.push_back(GetPartialScenes());
      }
      if (IsAsked(argc, argv, "closed"))
      {
        parts.push_back(GetClosedScenes());
      }
      for (const std::vector<SkipScene>& scenes : parts)
      {
        for (const SkipScene& scene : scenes)
        {
          CheckScene(report, setup, scene);
        }
      }
      if (!IsAsked(argc, argv, "flat"))
      {
        return;
      }
      CheckModelTransform(report, setup);
      CheckHiddenFragments(report, setup);
      CheckManySmall(report, setup);
      CheckPlanes(report, setup);
    });
}
