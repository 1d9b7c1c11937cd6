// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// A store larger than one storage block may be (128 MiB on llvmpipe): still one geometry pass and
// the exact picture.

#include "DeepStack.h"

using namespace vtkOITTest;

int TestABufferLargeStore(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](TestReport& report, const Setup& setup)
    {
      TestRig rig(setup, 200, 150);
      const int layers = setup.FragmentStorage == Storage::Half ? 300 : 150;
      CheckDeepStack(report, rig, setup, std::to_string(layers) + " layers", layers, 2);
      report.Check(rig.Pass->GetBufferSizeInBytes() > 128 << 20,
        "the pass holds only " + std::to_string(rig.Pass->GetBufferSizeInBytes()) +
          " bytes: this tests nothing");
    });
}
