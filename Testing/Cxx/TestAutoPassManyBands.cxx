// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// 64 layers that cross each other in a 64th of the memory that their fragments take. With
// --large in 4096 x 4096 pixels and 256 MiB; that takes minutes, so it is not what ctest runs.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkOITAutoPass.h"

#include <chrono>
#include <cstring>

using namespace vtkOITTest;

namespace
{
constexpr int Layers = 64;
constexpr int FewestBands = 64; // 16 bytes a fragment

void CheckFrames(Report& report, const Setup& setup, int size)
{
  // 16 bytes a pixel: those of a single layer.
  const vtkTypeInt64 limit = vtkTypeInt64(size) * size * 16;
  Rig rig(setup, size, size);
  rig.Pass->SetMaximumBufferSize(limit);
  std::vector<Layer> left;
  std::vector<Layer> right;
  Random random(64);
  for (int i = 0; i < Layers; ++i)
  {
    const auto depth = static_cast<float>(0.1 + 0.8 * (i + 0.5) / Layers);
    const glm::vec4 color(random.Uniform(), random.Uniform(), random.Uniform(), 0.1f);
    left.push_back({ depth, color });
    right.push_back({ 1.0f - depth, color });
  }
  random.Shuffle(left);
  for (const Layer& layer : left)
  {
    rig.AddRamp(layer.Depth, 1.0 - layer.Depth, layer.Color);
  }
  const glm::dvec4 expectedLeft = ReferenceCompositor::Composite(left, rig.GetBackground());
  const glm::dvec4 expectedRight = ReferenceCompositor::Composite(right, rig.GetBackground());
  const Tolerance bound =
    ReferenceCompositor::RoundingBoundOfAnyStack(Layers, setup.FragmentStorage) +
    Rig::WindowTolerance();
  for (int frame = 0; frame < 2; ++frame)
  {
    const std::string what = std::to_string(size) + " pixels, frame " + std::to_string(frame);
    const auto start = std::chrono::steady_clock::now();
    const Image image = rig.RenderWindow();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    report.Compare(
      what, image, [&](int x, int) { return x < size / 2 ? expectedLeft : expectedRight; }, bound);
    const vtkTypeInt64 bytes = rig.Pass->GetBufferSizeInBytes();
    const int passes = rig.Pass->GetNumberOfGeometryPasses();
    std::printf("%s: %s, %d geometry passes, %lld of %lld bytes, %.1f s\n", what.c_str(),
      rig.Pass->GetAlgorithmName().c_str(), passes, static_cast<long long>(bytes),
      static_cast<long long>(limit), seconds.count());
    report.Check(bytes > limit / 2 && bytes <= limit,
      what + ": the pass holds " + std::to_string(bytes) + " bytes of " + std::to_string(limit));
    report.Check(passes >= FewestBands, what + ": only " + std::to_string(passes) + " bands");
    report.Check(rig.Pass->GetAlgorithmName() == std::string("A-buffer") && rig.Pass->GetExact(),
      what + ": drawn by " + rig.Pass->GetAlgorithmName());
    report.Check(rig.Pass->GetNumberOfFragments() == vtkTypeInt64(size) * size * Layers,
      what + ": " + std::to_string(rig.Pass->GetNumberOfFragments()) + " fragments");
  }
}
}

int TestAutoPassManyBands(int argc, char* argv[])
{
  const bool isLarge = argc > 2 && std::strcmp(argv[argc - 1], "--large") == 0;
  bool isDone = false; // once is enough: no setup changes the memory that is needed by much
  return RunTest(isLarge ? argc - 1 : argc, argv, Setups::Storages,
    [&isDone, isLarge](Report& report, const Setup& setup)
    {
      if (!isDone)
      {
        CheckFrames(report, setup, isLarge ? 4096 : 512);
      }
      isDone = true;
    });
}
