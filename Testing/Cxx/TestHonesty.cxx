// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// What a pass says about its picture is true: a frame that is reported as exact is right, and one
// that is not right is reported as not exact, with a bound that holds in an 8-bit window.

#include "Oracle/ReferenceCompositor.h"
#include "Scenes/RandomScene.h"

#include <algorithm>
#include <cmath>

using namespace vtkOITTest;

namespace
{
double FindLargestError(const Image& image, const Image& expected)
{
  double error = 0.0;
  for (std::size_t i = 0; i < image.Pixels.size(); ++i)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      error = std::max(
        error, std::abs(double(image.Pixels[i][channel]) - double(expected.Pixels[i][channel])));
    }
  }
  return error;
}
}

int TestHonesty(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, SceneWidth, SceneHeight);
      Setup peel = setup;
      peel.Method = "peel";
      peel.FragmentStorage = Storage::Float32;
      Rig reference(peel, SceneWidth, SceneHeight);
      const Tolerance rounding =
        ReferenceCompositor::RoundingBoundOfAnyStack(40, setup.FragmentStorage);
      int inexact = 0;
      for (unsigned int seed = 1; seed <= 6; ++seed)
      {
        for (const std::size_t count : { 1, 2, 3, 20 })
        {
          std::vector<SceneProp> props = MakeScene(seed, SceneKind::Aligned).Props;
          props.resize(std::min(count, props.size()));
          const Image image = RenderProps(rig, props);
          const double error = FindLargestError(image, RenderProps(reference, props));
          const std::string what = "seed " + std::to_string(seed) + ", " +
            std::to_string(props.size()) + " props: an error of " + std::to_string(error);
          const bool isExact = rig.Pass->GetExact();
          report.Check(!isExact || error <= rounding.Color, what + " reported as exact");
          report.Check(isExact == (rig.Pass->GetErrorBound() == 0.0), what + ": exact and bound");
          const double shown = FindLargestError(rig.RenderWindow(), reference.RenderWindow());
          report.Check(shown <= rig.Pass->GetErrorBound() + rounding.Color + 3.0 / 255,
            what + ": the bound is " + std::to_string(rig.Pass->GetErrorBound()));
          inexact += isExact ? 0 : 1;
        }
      }
      report.Check((inexact > 0) == (setup.Promise == Expectation::Preview),
        std::to_string(inexact) + " frames were reported as not exact");
    });
}
