// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// 4096 x 4096 pixels within 256 MiB, sorted and blended.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"

#include "vtkOITAutoPass.h"

using namespace vtkOITTest;

namespace
{
constexpr int Size = 4096;
constexpr vtkTypeInt64 Limit = INT64_C(256) << 20;

void CheckFrame(Report& report, Rig& rig, const std::string& what, const Report::Expected& expected,
  const std::string& name, const Tolerance& bound)
{
  report.Compare(what, rig.RenderWindow(), expected, bound);
  report.Check(rig.Pass->GetAlgorithmName() == name,
    what + ": drawn by " + rig.Pass->GetAlgorithmName() + ", expected " + name);
  const vtkTypeInt64 bytes = rig.Pass->GetBufferSizeInBytes();
  report.Check(bytes <= Limit, what + ": the pass holds " + std::to_string(bytes) + " bytes");
  report.Check(rig.Pass->GetExact(), what + ": is not exact");
}
}

int TestAutoPassLargeWindow(int argc, char* argv[])
{
  bool isDone = false; // once is enough: no setup changes the memory that is needed by much
  return RunTest(argc, argv, Setups::Storages,
    [&isDone](Report& report, const Setup& setup)
    {
      if (isDone)
      {
        return;
      }
      isDone = true;
      Rig rig(setup, Size, Size);
      rig.Pass->SetMaximumBufferSize(Limit);
      std::vector<Layer> layers;
      for (int i = 0; i < 4; ++i)
      {
        layers.push_back({ 0.2f * (i + 1), { 0.3f * i, 0.9f - 0.2f * i, 0.5f, 0.3f } });
        rig.AddQuad(layers.back());
      }
      const Tolerance bound =
        ReferenceCompositor::RoundingBoundOfAnyStack(8, setup.FragmentStorage) +
        Rig::WindowTolerance();
      const Report::Expected planes =
        Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground()));
      // A layer of float32 takes all of the memory: no frame can be kept.
      for (int frame = 0; frame < 3; ++frame)
      {
        CheckFrame(report, rig, "planes", planes, "ordered blending", bound);
      }

      rig.RemoveProps();
      std::vector<Layer> reversed = layers;
      for (Layer& layer : reversed)
      {
        rig.AddRamp(layer.Depth, 1.0 - layer.Depth, layer.Color);
        layer.Depth = 1.0f - layer.Depth;
      }
      const glm::dvec4 left = ReferenceCompositor::Composite(layers, rig.GetBackground());
      const glm::dvec4 right = ReferenceCompositor::Composite(reversed, rig.GetBackground());
      CheckFrame(
        report, rig, "ramps", [&](int x, int) { return x < Size / 2 ? left : right; }, "A-buffer",
        bound);
    });
}
