// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Which scenes with closed props the automatic pass blends: what was quicker when both were
// measured.

#include "Rig/Report.h"

#include "Private/Auto/vtkOITBlendCost.h"

#include <string>

using namespace vtkOITTest;

namespace
{
struct Measured
{
  std::string Scene;
  int Props;
  int TrianglesOfEach;
  int SideOfEach; // pixels of its rectangle
  int BlendSide;  // of all of them
  int FrameSide;
  int LeftSide; // of what is sorted anyway
  bool Pays;
};

bool Pays(const Measured& scene)
{
  vtkOITBlendCost cost;
  cost.Props = scene.Props;
  cost.Triangles = static_cast<std::int64_t>(scene.Props) * scene.TrianglesOfEach;
  cost.Fragments = 1.57 * scene.Props * scene.SideOfEach * scene.SideOfEach;
  cost.BlendArea = scene.BlendSide * scene.BlendSide;
  cost.FrameArea = scene.FrameSide * scene.FrameSide;
  cost.LeftArea = scene.LeftSide * scene.LeftSide;
  return cost.Pays();
}
}

int TestBlendCost(int, char*[])
{
  Report report;
  report.SetContext("blend cost");
  for (const Measured& scene : {
         Measured{ "few props", 32, 100000, 1, 10, 1000, 1000, true },
         Measured{ "64 behind each other", 64, 448, 200, 200, 200, 0, true },
         Measured{ "64 behind each other, small and fine", 64, 7936, 50, 50, 50, 0, true },
         Measured{ "228 behind each other", 228, 448, 200, 200, 200, 0, true },
         Measured{ "64 beside each other", 64, 96, 45, 400, 400, 0, true },
         Measured{ "256 beside each other", 256, 96, 22, 400, 400, 0, true },
         Measured{ "256 beside each other, finer", 256, 4416, 22, 400, 400, 0, false },
         Measured{ "1024 beside each other", 1024, 96, 11, 400, 400, 0, false },
         Measured{ "61 of a crowd of 100", 61, 96, 18, 370, 370, 350, false },
         Measured{ "67 of a large crowd of 100", 67, 96, 45, 900, 900, 880, false },
         Measured{ "44 of a large crowd of 50", 44, 96, 45, 900, 900, 600, true },
       })
  {
    report.Check(Pays(scene) == scene.Pays,
      scene.Scene + (scene.Pays ? " should be blended" : " should be sorted"));
  }
  return report.GetExitStatus();
}
