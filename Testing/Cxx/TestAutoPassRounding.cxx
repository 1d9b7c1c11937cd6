// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Layers whose order is known are blended frame after frame, each time elsewhere: a pixel of a
// window of 8 bits is rounded once, however many layers it has, and nothing is left over from other
// frames, windows of other sizes, or pictures that were reused.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"
#include "Scenes/SkipScenes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkOITAutoPass.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <string>
#include <vector>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 24;
constexpr int Height = 16;
constexpr int AllFrames = 100;
constexpr int FewFrames = 20;

/// Without framebuffer fetch the blend unit rounds source, factor and result.
double GetLargestError(const Setup& setup)
{
  return (setup.HasFetch ? 0.5 : 1.5) / 255.0 + 1e-5;
}

struct Quad
{
  Layer TheLayer;
  PixelRectangle Rectangle;
};

std::vector<Quad> MakeQuads(Random& random, int width, int height)
{
  std::vector<Quad> quads;
  for (const Layer& layer : random.Layers(1 + random.Below(5)))
  {
    const int x = random.Below(width - 4);
    const int y = random.Below(height - 4);
    quads.push_back({ layer,
      { double(x), double(y), double(x + 3 + random.Below(width - x - 3)),
        double(y + 3 + random.Below(height - y - 3)) } });
  }
  return quads;
}

void CheckMovingQuads(Report& report, const Setup& setup, int frames)
{
  Rig rig(setup, Width, Height);
  Random random(7);
  for (int frame = 0; frame < frames; ++frame)
  {
    if (frame % 60 == 30)
    {
      rig.SetSize(Width + 16, Height + 8);
    }
    else if (frame % 60 == 0)
    {
      rig.SetSize(Width, Height);
    }
    const std::vector<Quad> quads = MakeQuads(random, rig.GetWidth(), rig.GetHeight());
    rig.RemoveProps();
    for (const Quad& quad : quads)
    {
      rig.AddQuad(quad.TheLayer, quad.Rectangle);
    }
    const auto expected = [&](int x, int y)
    {
      std::vector<Layer> layers;
      for (const Quad& quad : quads)
      {
        if (quad.Rectangle.Contains(x, y))
        {
          layers.push_back(quad.TheLayer);
        }
      }
      return ReferenceCompositor::Composite(layers, rig.GetBackground());
    };
    const double most = GetLargestError(setup);
    report.Compare("frame " + std::to_string(frame), rig.RenderWindow(), expected, { most, most });
    report.Check(rig.Pass->GetNumberOfGeometryPasses() == 1, "the quads are sorted");
    if (random.Below(16) == 0)
    {
      rig.RenderWindow(); // the first frame has made default lookup tables, which is a change
      rig.RenderWindow(); // keeps the layer
      report.Compare(
        "frame " + std::to_string(frame) + ", again", rig.RenderWindow(), expected, { most, most });
      report.Check(rig.Pass->GetNumberOfGeometryPasses() == 0, "the frame is not reused");
    }
  }
}

/// A part of the window is drawn to again after as many frames as are told apart by numbers.
void CheckRepeatedNumber(Report& report, const Setup& setup)
{
  constexpr int period = 255;
  Rig rig(setup, Width, Height);
  Random random(9);
  for (int frame = 0; frame < period + 11; ++frame)
  {
    const bool isRight = frame % period == 10;
    const std::vector<Layer> layers = random.Layers(2);
    rig.RemoveProps();
    for (const Layer& layer : layers)
    {
      rig.AddQuad(
        layer, isRight ? PixelRectangle{ 12, 0, 24, 16 } : PixelRectangle{ 0, 0, 12, 16 });
    }
    const glm::dvec4 background = rig.GetBackground();
    const glm::dvec4 drawn = ReferenceCompositor::Composite(layers, background);
    const double most = GetLargestError(setup);
    report.Compare("number " + std::to_string(frame), rig.RenderWindow(),
      [&](int x, int) { return (x >= 12) == isRight ? drawn : background; }, { most, most });
  }
}

/// Closed props, against the same in float32.
void CheckMovingSpheres(Report& report, const Setup& setup, int frames)
{
  Rig rig(setup, 2 * Width, 2 * Height);
  vtkActor* red = AddSphere(rig, Red, {}, 0.5);
  vtkActor* blue = AddSphere(rig, Blue, {}, 0.3);
  Random random(8);
  for (int frame = 0; frame < frames; ++frame)
  {
    const double sign = random.Below(2) == 0 ? 1.0 : -1.0;
    red->SetPosition(random.Uniform() - 0.5, random.Uniform() - 0.5, 0.4 * sign);
    blue->SetPosition(random.Uniform() - 0.5, random.Uniform() - 0.5, -0.5 * sign);
    red->GetProperty()->SetOpacity(0.1 + 0.8 * random.Uniform());
    red->SetVisibility(random.Below(4) > 0);
    const double most = GetLargestError(setup);
    const Image window = rig.RenderWindow();
    report.Compare("spheres " + std::to_string(frame), window, rig.Render(), { most, most });
    report.Check(rig.Pass->GetNumberOfFragments() < 0, "the spheres are sorted");
  }
}
}

int TestAutoPassRounding(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      const bool isFirst = setup.FragmentStorage == Storage::Half && setup.HasFetch;
      CheckMovingQuads(report, setup, isFirst ? AllFrames : FewFrames);
      CheckMovingSpheres(report, setup, FewFrames);
      if (isFirst)
      {
        CheckRepeatedNumber(report, setup);
      }
    });
}
