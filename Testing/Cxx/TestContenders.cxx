// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// The comparison with VTK's passes, tested with what is known of any VTK: each is right for one
// layer, none sees the order of two but those that peel, and vtkOIT's own is right throughout.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Contenders.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkOITHeadless.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using namespace vtkOITTest;

namespace
{
/// Green of opacity 0.9 over red, two random layers, and one layer only.
void Draw(Report& report, const Setup& setup)
{
  const std::vector<std::vector<Layer>> stacks{ { { 0.5f, { 0.1f, 0.9f, 0.2f, 0.5f } } },
    { { 0.75f, { 1.0f, 0.0f, 0.0f, 0.9f } }, { 0.25f, { 0.0f, 1.0f, 0.0f, 0.9f } } },
    Random(5).Layers(5) };
  Rig rig(setup, 16, 12);
  for (const std::vector<Layer>& layers : stacks)
  {
    report.SetStressTest(static_cast<int>(layers.size()));
    rig.RemoveProps();
    rig.AddStack(layers);
    report.Compare(std::to_string(layers.size()) + " layers", rig.Render(),
      Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
      ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage));
  }
}

bool IsRight(const Report::Result& result)
{
  return result.Error.Color <= result.Allowed.Color;
}
}

int TestContenders(int, char*[])
{
  if (!vtkOITHeadless::Initialize())
  {
    std::printf("FAILED: no headless render window; see the error above\n");
    return EXIT_FAILURE;
  }
  Report report;
  report.SetContext("contenders");
  for (const std::string name : { "vtk-weighted", "vtk-dual", "vtk-dual-4", "vtk-peel", "abuffer" })
  {
    report.Check(IsContender(name) == (name != "abuffer"), name + ": whose pass it is");
    const auto results = ObserveContender(name, Draw);
    if (!report.Check(results.size() == 3, name + ": a comparison is missing"))
    {
      continue;
    }
    report.Check(
      results[1].StressTest == 2 && results[1].What == "2 layers", name + ": results are mixed up");
    report.Check(IsRight(results[0]), name + ": one layer is wrong");
    const bool knowsOrder = name != "vtk-weighted";
    report.Check(IsRight(results[1]) == knowsOrder, name + ": two layers");
    report.Check(IsRight(results[2]) == knowsOrder, name + ": five layers");
    if (name == "abuffer")
    {
      for (const Report::Result& result : results)
      {
        report.Check(result.Error.Alpha <= result.Allowed.Alpha, name + ": alpha is wrong");
      }
    }
  }
  report.Check(!CreateContenderPass("vtk-none"), "an unknown contender has a pass");
  return report.GetExitStatus();
}
