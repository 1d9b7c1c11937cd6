// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// A store larger than one storage block may be (128 MiB on llvmpipe): still one geometry pass and
// the exact picture. For larger ones, with time and memory, give width, height and layers:
//
//     vtkOITCxxTests TestABufferLargeStore abuffer 2304 2304 30     2.5 GB with half floats

#include "Scenes/DeepStack.h"

#include <cstdlib>

using namespace vtkOITTest;

int TestABufferLargeStore(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [&](Report& report, const Setup& setup)
    {
      // VTK gives tests options, too, but they start with a dash.
      const bool isGiven = argc > 4 && std::atoi(argv[4]) > 0;
      Rig rig(setup, isGiven ? std::atoi(argv[2]) : 200, isGiven ? std::atoi(argv[3]) : 150);
      const int layers = isGiven                 ? std::atoi(argv[4])
        : setup.FragmentStorage == Storage::Half ? 300
                                                 : 150;
      CheckDeepStack(report, rig, setup, std::to_string(layers) + " layers", layers, 2);
      report.Check(rig.Pass->GetBufferSizeInBytes() > 128 << 20,
        "the pass holds only " + std::to_string(rig.Pass->GetBufferSizeInBytes()) +
          " bytes: this tests nothing");
    });
}
