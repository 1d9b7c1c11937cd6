// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 29: more fragments than the store holds. The frame is exact nevertheless, in the
// first frame too: the store grows, or the viewport is rendered in bands within
// MaximumBufferSize.

#include "Scenes/DeepStack.h"

using namespace vtkOITTest;

int TestABufferOverflow(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(29);
      {
        Rig rig(setup, 96, 64);
        CheckDeepStack(report, rig, setup, "300 layers", 300);
        report.Check(rig.Pass->GetNumberOfGeometryPasses() == 1,
          "later frames do not start with the right size: " +
            std::to_string(rig.Pass->GetNumberOfGeometryPasses()) + " geometry passes");
        CheckDeepStack(report, rig, setup, "fewer layers again", 3);
      }
      {
        // 1.8 million fragments of at least 12 bytes do not fit into 1 MiB.
        const vtkTypeInt64 limit = 1 << 20;
        Rig rig(setup, 96, 64);
        rig.Pass->SetMaximumBufferSize(limit);
        CheckDeepStack(report, rig, setup, "300 layers in 1 MiB", 300);
        report.Check(rig.Pass->GetBufferSizeInBytes() <= limit,
          "the pass holds " + std::to_string(rig.Pass->GetBufferSizeInBytes()) + " bytes of " +
            std::to_string(limit));
        report.Check(rig.Pass->GetNumberOfGeometryPasses() > 1,
          "the limit was not reached: this tests nothing");
        // A row alone is more than the limit.
        rig.SetSize(96, 3);
        CheckDeepStack(report, rig, setup, "3000 layers in 1 MiB", 3000);
        report.Check(rig.Pass->GetBufferSizeInBytes() <= limit,
          "the pass holds " + std::to_string(rig.Pass->GetBufferSizeInBytes()) + " bytes of " +
            std::to_string(limit));
        rig.Pass->SetMaximumBufferSize(0);
        CheckDeepStack(report, rig, setup, "without the limit", 300);
      }
    });
}
