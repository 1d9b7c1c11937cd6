// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 29: more fragments than the store holds. The frame is exact nevertheless, in the
// first frame too: the store grows, or the viewport is rendered in bands within
// MaximumBufferSize.

#include "TestRandom.h"
#include "TestRig.h"

#include <algorithm>

using namespace vtkOITTest;

namespace
{
/// Deep stacks over the whole viewport; as many fragments as pixels times layers.
void CheckFrames(TestReport& report, TestRig& rig, const Setup& setup, const std::string& what,
  int numberOfLayers)
{
  const glm::vec4 color(0.9f, 0.5f, 0.05f, 0.01f);
  const std::vector<float> depths = Random(numberOfLayers).Depths(numberOfLayers);
  const std::vector<Layer> layers = EqualLayers(depths, color);
  rig.RemoveProps();
  rig.AddEqualLayers(depths, color);
  const TestReport::Expected expected =
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground()));
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage);
  const vtkTypeInt64 fragments =
    vtkTypeInt64(rig.GetWidth()) * rig.GetHeight() * numberOfLayers;
  for (int frame = 0; frame < 3; ++frame)
  {
    const std::string name = what + ", frame " + std::to_string(frame);
    report.Compare(name, rig.Render(), expected, bound);
    report.Check(rig.Pass->GetExact() && rig.Pass->GetErrorBound() == 0.0,
      name + ": is reported as not exact");
    report.Check(rig.Pass->GetNumberOfFragments() == fragments,
      name + ": " + std::to_string(rig.Pass->GetNumberOfFragments()) + " fragments reported of " +
        std::to_string(fragments));
    report.Check(rig.Pass->GetMaximumDepthComplexity() == numberOfLayers,
      name + ": a depth complexity of " +
        std::to_string(rig.Pass->GetMaximumDepthComplexity()) + " reported");
  }
}
}

int TestABufferOverflow(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](TestReport& report, const Setup& setup)
    {
      {
        TestRig rig(setup, 96, 64);
        CheckFrames(report, rig, setup, "300 layers", 300);
        report.Check(rig.Pass->GetNumberOfGeometryPasses() == 1,
          "later frames do not start with the right size: " +
            std::to_string(rig.Pass->GetNumberOfGeometryPasses()) + " geometry passes");
        CheckFrames(report, rig, setup, "fewer layers again", 3);
      }
      {
        // 1.8 million fragments of at least 12 bytes do not fit into 1 MiB.
        const vtkTypeInt64 limit = 1 << 20;
        TestRig rig(setup, 96, 64);
        rig.Pass->SetMaximumBufferSize(limit);
        CheckFrames(report, rig, setup, "300 layers in 1 MiB", 300);
        report.Check(rig.Pass->GetBufferSizeInBytes() <= limit,
          "the pass holds " + std::to_string(rig.Pass->GetBufferSizeInBytes()) + " bytes of " +
            std::to_string(limit));
        report.Check(rig.Pass->GetNumberOfGeometryPasses() > 1,
          "the limit was not reached: this tests nothing");
        // A row alone is more than the limit.
        rig.SetSize(96, 3);
        CheckFrames(report, rig, setup, "3000 layers in 1 MiB", 3000);
        report.Check(rig.Pass->GetBufferSizeInBytes() <= limit,
          "the pass holds " + std::to_string(rig.Pass->GetBufferSizeInBytes()) + " bytes of " +
            std::to_string(limit));
        rig.Pass->SetMaximumBufferSize(0);
        CheckFrames(report, rig, setup, "without the limit", 300);
      }
      {
        // Beyond one storage block of llvmpipe (128 MiB): 9 million fragments.
        TestRig rig(setup, 200, 150);
        CheckFrames(report, rig, setup, "beyond a storage block", 300);
      }
    });
}
