// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 23: closed meshes and crossing triangles against the ray caster, in parallel and in
// perspective projection, from both sides.

#include "Oracle/RayCaster.h"
#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include "vtkCamera.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <cmath>
#include <utility>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 72;
constexpr int Height = 60;

struct Scene
{
  std::string Name;
  std::vector<Mesh> Meshes;
  double LargestExcludedShare; // of the pixels
};

std::vector<Scene> MakeScenes()
{
  const glm::vec4 red(0.9f, 0.2f, 0.1f, 0.375f);
  const glm::vec4 green(0.1f, 0.8f, 0.2f, 0.5f);
  const glm::vec4 blue(0.1f, 0.3f, 0.9f, 0.25f);
  std::vector<Mesh> shells;
  for (int i = 0; i < 6; ++i)
  {
    const glm::vec4 color(0.15f * i, 0.9f - 0.1f * i, 0.5f, 0.15f + 0.05f * i);
    shells.push_back(MakeSphere({ 0.02 * i, 0.0, 0.01 * i }, 0.3 + 0.1 * i, 12, color));
  }
  std::vector<Mesh> tubes;
  for (int i = 0; i < 3; ++i)
  {
    tubes.push_back(MakeTorus(i == 0 ? red : i == 1 ? green : blue));
    Rotate(tubes.back(), { 1.0, 0.3 * i, 0.2 }, 35.0 + 50.0 * i);
  }
  std::vector<Scene> scenes{ { "sphere", { MakeSphere({ 0.0, 0.0, 0.0 }, 0.8, 20, red) }, 0.02 },
    { "torus", { MakeTorus(green) }, 0.02 }, { "knot", { MakeKnot(blue) }, 0.03 },
    { "nested shells", shells, 0.03 }, { "crossing tubes", tubes, 0.05 } };
  for (Scene& scene : scenes)
  {
    for (Mesh& mesh : scene.Meshes)
    {
      Rotate(mesh, { 0.4, 1.0, 0.1 }, 25.0);
    }
  }
  Random random(71);
  scenes.push_back({ "soup", MakeSoup(random, 24, 0.8), 0.06 });
  return scenes;
}

std::vector<std::pair<std::string, CastCamera>> MakeCameras()
{
  CastCamera parallel;
  parallel.Position = { 0.3, 0.2, 2.0 };
  CastCamera reversed = parallel;
  reversed.Position = -parallel.Position;
  CastCamera perspective;
  perspective.IsParallel = false;
  perspective.Position = { 1.0, -0.7, 2.2 };
  perspective.ViewAngle = 42.0;
  perspective.Near = 0.75;
  perspective.Far = 5.0;
  return { { "parallel", parallel }, { "from behind", reversed }, { "perspective", perspective } };
}

void SetCamera(vtkRenderer* renderer, const CastCamera& cast)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetParallelProjection(cast.IsParallel);
  camera->SetPosition(cast.Position.x, cast.Position.y, cast.Position.z);
  camera->SetFocalPoint(cast.FocalPoint.x, cast.FocalPoint.y, cast.FocalPoint.z);
  camera->SetViewUp(cast.ViewUp.x, cast.ViewUp.y, cast.ViewUp.z);
  camera->SetParallelScale(cast.ParallelScale);
  camera->SetViewAngle(cast.ViewAngle);
  camera->SetClippingRange(cast.Near, cast.Far);
}

/// The picture by the ray caster, and which pixels count.
struct Answer
{
  std::vector<RayCaster::Pixel> Pixels;
  int Excluded = 0;
  int LargestStack = 0;
};

Answer Cast(const Scene& scene, const CastCamera& camera)
{
  RayCaster caster(camera, Width, Height);
  for (const Mesh& mesh : scene.Meshes)
  {
    caster.Add(mesh);
  }
  Answer answer;
  for (int i = 0; i < Width * Height; ++i)
  {
    answer.Pixels.push_back(caster.Cast(i % Width, i / Width));
    answer.Excluded += answer.Pixels.back().IsExcluded;
    answer.LargestStack =
      std::max(answer.LargestStack, static_cast<int>(answer.Pixels.back().Hits.size()));
  }
  return answer;
}

void CheckScene(Report& report, Rig& rig, const Setup& setup, const std::string& what,
  const Scene& scene, const Answer& answer)
{
  report.Check(answer.LargestStack >= 2 && answer.Excluded > 0 &&
      answer.Excluded <= scene.LargestExcludedShare * Width * Height,
    what + ": the scene tests little, " + std::to_string(answer.LargestStack) + " layers, " +
      std::to_string(answer.Excluded) + " pixels excluded");
  rig.RemoveProps();
  for (const Mesh& mesh : scene.Meshes)
  {
    rig.AddPolyData(MakePolyData(mesh), mesh.Color);
  }
  const Image image = rig.Render();
  report.Compare(
    what, image,
    [&](int x, int y)
    {
      const RayCaster::Pixel& pixel = answer.Pixels[std::size_t(y) * Width + x];
      return pixel.IsExcluded ? glm::dvec4(image.At(x, y))
                              : RayCaster::Blend(pixel, rig.GetBackground());
    },
    ReferenceCompositor::RoundingBoundOfAnyStack(answer.LargestStack, setup.FragmentStorage));
  const vtkTypeInt64 fragments = rig.Pass->GetNumberOfFragments();
  report.Check(scene.Name == "soup" || fragments < 0 || fragments % 2 == 0,
    what + ": a closed mesh with " + std::to_string(fragments) + " fragments");
}
}

int TestClosedMeshes(int argc, char* argv[])
{
  const std::vector<Scene> scenes = MakeScenes();
  const auto cameras = MakeCameras();
  std::vector<Answer> answers;
  for (const Scene& scene : scenes)
  {
    for (const auto& camera : cameras)
    {
      answers.push_back(Cast(scene, camera.second));
    }
  }
  return RunTest(argc, argv, Setups::All,
    [&](Report& report, const Setup& setup)
    {
      report.SetStressTest(23);
      Rig rig(setup, Width, Height);
      auto answer = answers.begin();
      for (const Scene& scene : scenes)
      {
        for (const auto& camera : cameras)
        {
          SetCamera(rig.Renderer, camera.second);
          CheckScene(report, rig, setup, scene.Name + ", " + camera.first, scene, *answer++);
        }
      }
    });
}
