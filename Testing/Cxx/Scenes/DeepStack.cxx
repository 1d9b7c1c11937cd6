// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes/DeepStack.h"

#include "Oracle/ReferenceCompositor.h"
#include "Scenes/Random.h"

namespace vtkOITTest
{
//------------------------------------------------------------------------------
void CheckDeepStack(Report& report, Rig& rig, const Setup& setup, const std::string& what,
  int numberOfLayers, int numberOfFrames)
{
  const glm::vec4 color(0.9f, 0.5f, 0.05f, 0.01f);
  const std::vector<float> depths = Random(numberOfLayers).Depths(numberOfLayers);
  const std::vector<Layer> layers = EqualLayers(depths, color);
  rig.RemoveProps();
  rig.AddEqualLayers(depths, color);
  const Report::Expected expected =
    Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground()));
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage);
  const vtkTypeInt64 fragments = vtkTypeInt64(rig.GetWidth()) * rig.GetHeight() * numberOfLayers;
  for (int frame = 0; frame < numberOfFrames; ++frame)
  {
    const std::string name = what + ", frame " + std::to_string(frame);
    report.Compare(name, rig.Render(), expected, bound);
    report.Check(rig.Pass->GetExact() && rig.Pass->GetErrorBound() == 0.0,
      name + ": is reported as not exact");
    report.Check(rig.Pass->GetNumberOfFragments() == fragments,
      name + ": " + std::to_string(rig.Pass->GetNumberOfFragments()) + " fragments reported of " +
        std::to_string(fragments));
    report.Check(rig.Pass->GetMaximumDepthComplexity() == numberOfLayers,
      name + ": a depth complexity of " + std::to_string(rig.Pass->GetMaximumDepthComplexity()) +
        " reported");
  }
}
}
