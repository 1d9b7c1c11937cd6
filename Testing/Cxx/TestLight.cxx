// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stress test 38: emissive Gaussians add light. Their opacity times their colour is seen through what
// lies in front of them, and takes nothing away from what lies behind. Where it coincides with layers,
// it lies on top of them, or in the order of drawing with LAST_ON_TOP. Without the A-buffer it is added
// over all, as VTK does, and that is not promised to be exact.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/Rig.h"
#include "Scenes/Light.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTranslucentPass.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

using namespace vtkOITTest;

namespace
{
constexpr int Width = 20;
constexpr int Height = 16;

/// A layer, or light of this colour and opacity.
struct Part
{
  Layer Of;
  bool IsLight = false;
};
using Parts = std::vector<Part>;

glm::dvec3 FindCenter(const Rig& rig, float depth)
{
  return rig.ToWorld(Width / 2.0, Height / 2.0, depth);
}

void AddParts(Rig& rig, const Parts& parts)
{
  rig.RemoveProps();
  for (const Part& part : parts)
  {
    if (part.IsLight)
    {
      AddLight(rig, { FindCenter(rig, part.Of.Depth) }, part.Of.Color, 0.0);
    }
    else
    {
      rig.AddQuad(part.Of)->ForceTranslucentOn();
    }
  }
}

/// Layers in groups of one depth; light before those of its group.
glm::dvec4 FindAnswer(const Parts& parts, const glm::dvec4& background)
{
  std::vector<Layer> layers;
  for (const Part& part : parts)
  {
    if (!part.IsLight)
    {
      layers.push_back(part.Of);
    }
  }
  glm::dvec4 answer = ReferenceCompositor::Composite(layers, background);
  for (const Part& part : parts)
  {
    double transmittance = part.IsLight ? part.Of.Color.a : 0.0;
    for (const Layer& layer : layers)
    {
      transmittance *= layer.Depth < part.Of.Depth ? 1.0 - layer.Color.a : 1.0;
    }
    answer += transmittance * glm::dvec4(glm::dvec3(part.Of.Color), 0.0);
  }
  return answer;
}

/// The light is rounded once, and with it each opacity in front of it, where the format rounds.
Tolerance FindBound(const Rig& rig, const Setup& setup, const Parts& parts)
{
  const double step = setup.FragmentStorage == Storage::Half ? std::ldexp(1.0, -11) : 1e-7;
  std::vector<Layer> layers;
  for (const Part& part : parts)
  {
    if (!part.IsLight)
    {
      layers.push_back(part.Of);
    }
  }
  Tolerance bound =
    ReferenceCompositor::RoundingBound(layers, rig.GetBackground(), setup.FragmentStorage);
  for (const Part& part : parts)
  {
    double light = part.IsLight ? part.Of.Color.a : 0.0;
    double errors = 2.0;
    for (const Layer& layer : layers)
    {
      if (layer.Depth < part.Of.Depth && layer.Color.a < 1.0f)
      {
        light *= 1.0 - layer.Color.a;
        errors += layer.Color.a / (1.0 - layer.Color.a);
      }
    }
    bound.Color += light * errors * step;
  }
  return bound;
}

void Compare(
  Report& report, Rig& rig, const Setup& setup, const std::string& what, const Parts& parts)
{
  AddParts(rig, parts);
  report.Compare(what, rig.Render(), Everywhere(FindAnswer(parts, rig.GetBackground())),
    FindBound(rig, setup, parts));
  report.Check(rig.Pass->GetExact(), what + ": it is said not to be exact");
}

const Layer Near{ 0.25f, { 0.2f, 0.9f, 0.1f, 0.5f } };
const Layer Far{ 0.75f, { 0.9f, 0.8f, 0.1f, 0.25f } };

Layer MakeLight(float depth)
{
  return { depth, { 0.5f, 0.25f, 0.75f, 0.5f } };
}

void CheckPlaces(Report& report, Rig& rig, const Setup& setup)
{
  Compare(report, rig, setup, "light alone", { { MakeLight(0.5f), true } });
  for (const float depth : { 0.125f, 0.25f, 0.5f, 0.75f, 0.875f })
  {
    const std::string what = "light at depth " + std::to_string(depth);
    Compare(report, rig, setup, what, { { Near }, { MakeLight(depth), true }, { Far } });
    Compare(report, rig, setup, what + ", drawn first",
      { { MakeLight(depth), true }, { Far }, { Near } });
  }
  Layer solid = Near;
  solid.Color.a = 1.0f;
  Compare(report, rig, setup, "light before and behind opacity 1",
    { { MakeLight(0.5f), true }, { solid }, { MakeLight(0.125f), true }, { Far } });
  Compare(report, rig, setup, "lights among layers",
    { { MakeLight(0.125f), true }, { Near }, { MakeLight(0.375f), true }, { MakeLight(0.5f), true },
      { MakeLight(0.5f), true }, { Far }, { MakeLight(0.875f), true } });
  Layer bright = MakeLight(0.5f);
  bright.Color = { 1.0f, 0.9f, 0.8f, 1.0f };
  Compare(report, rig, setup, "light above 1",
    { { Near }, { bright, true }, { bright, true }, { bright, true }, { Far } });
}

/// More than the registers of a stage take, and a threshold that may not leave light out.
void CheckMany(Report& report, Rig& rig, const Setup& setup)
{
  rig.Pass->SetTransmittanceThreshold(1.0 / 512.0);
  for (const int count : { 20, 40, 80 })
  {
    Parts parts;
    for (const Layer& layer : Random(count).Layers(count))
    {
      parts.push_back({ layer, parts.size() % 2 == 0 });
      parts.back().Of.Color.a *= parts.back().IsLight ? 1.0f : 0.5f;
    }
    Compare(report, rig, setup, std::to_string(count) + " layers and lights", parts);
  }
  rig.Pass->SetTransmittanceThreshold(0.0);
}

void CheckLastOnTop(Report& report, Rig& rig, const Setup& setup)
{
  rig.Pass->SetCoincidentLayersToLastOnTop();
  const Layer light = MakeLight(Near.Depth);
  const Parts first{ { light, true }, { Near }, { Far } };
  const Parts last{ { Near }, { light, true }, { Far } };
  Parts behind = first; // what is drawn over it is in front of it
  behind[0].Of.Depth = 0.5f;
  for (const bool isLast : { false, true })
  {
    const Parts& parts = isLast ? last : first;
    AddParts(rig, parts);
    report.Compare(isLast ? "light drawn on a layer" : "light drawn below a layer", rig.Render(),
      Everywhere(FindAnswer(isLast ? last : behind, rig.GetBackground())),
      FindBound(rig, setup, parts));
    report.Check(rig.Pass->GetExact(), "LAST_ON_TOP: it is said not to be exact");
  }
  rig.Pass->SetCoincidentLayersToMean();
}

/// Splats that fade, through a layer: the light alone, that layer, and nothing else.
void CheckSplats(Report& report, Rig& rig, const Setup& setup)
{
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 12; ++i)
  {
    points.push_back(rig.ToWorld(2.0 + 1.5 * i, 8.0 + (i % 3) * 3.0, 0.4 + 0.02 * i));
  }
  const glm::vec4 color(0.5f, 0.25f, 0.75f, 0.5f);
  rig.RemoveProps();
  AddLight(rig, points, color, 3.0);
  const Image alone = rig.Render();
  rig.AddQuad(Near);
  rig.AddQuad(Far);
  const glm::dvec4 background = rig.GetBackground();
  const glm::dvec4 layers = ReferenceCompositor::Composite({ Near, Far }, background);
  const Tolerance bound = ReferenceCompositor::RoundingBoundOfAnyStack(14, setup.FragmentStorage);
  report.Compare(
    "splats between layers", rig.Render(),
    [&](int x, int y)
    {
      const glm::dvec4 light = glm::dvec4(alone.At(x, y)) - background;
      return layers + (1.0 - Near.Color.a) * glm::dvec4(glm::dvec3(light), 0.0);
    },
    bound + bound);
  report.Check(std::abs(alone.At(8, 8).b - background.b) > 0.05, "the splats give no light");
  report.Check(rig.Pass->GetExact(), "splats: it is said not to be exact");
}

/// In a window of 8 bits, with samples and without: as OpenGL, each fragment is clamped to 1, and the
/// pixel.
void CheckWindow(Report& report, const Setup& setup, int samples)
{
  Rig rig(setup, Width, Height);
  rig.Window->SetMultiSamples(samples);
  const Parts parts{ { Near }, { MakeLight(0.5f), true }, { Far }, { MakeLight(0.625f), true } };
  AddParts(rig, parts);
  const glm::dvec4 answer = FindAnswer(parts, rig.GetBackground());
  report.Compare("window of " + std::to_string(samples) + " samples", rig.RenderWindow(),
    Everywhere(glm::min(answer, glm::dvec4(1.0))),
    FindBound(rig, setup, parts) + Rig::WindowTolerance());
  report.Check(rig.Pass->GetExact(), "window: it is said not to be exact");
}

/// Over an opaque quad, by the pass and by VTK's unsorted blending: added either way.
void CheckUnsorted(Report& report, const Setup& setup)
{
  Image images[2];
  for (Image& image : images)
  {
    Rig rig(setup, Width, Height);
    rig.AddQuad({ 0.75f, { 0.25f, 0.125f, 0.5f, 1.0f } });
    AddLight(
      rig, { FindCenter(rig, 0.5f), FindCenter(rig, 0.25f) }, { 0.5f, 0.25f, 0.75f, 0.5f }, 4.0);
    if (&image == &images[1])
    {
      setup.Detach(rig.Renderer);
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkTranslucentPass> blending;
      steps->SetTranslucentPass(blending);
      rig.Renderer->SetPass(steps);
    }
    rig.RenderWindow();
    image = rig.RenderWindow();
    report.Check(&image == &images[1] || !rig.Pass->GetExact(), "light: wrong promise");
  }
  report.CompareBits("light added over all", images[0], images[1]);
}
}

int TestLight(int argc, char* argv[])
{
  vtkObject::GlobalWarningDisplayOff(); // that the A-buffer draws, or nothing sorts light
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      report.SetStressTest(38);
      if (!setup.HasStorage || setup.Promise == Expectation::Preview)
      {
        CheckUnsorted(report, setup);
        return;
      }
      Rig rig(setup, Width, Height);
      CheckPlaces(report, rig, setup);
      CheckMany(report, rig, setup);
      CheckLastOnTop(report, rig, setup);
      CheckSplats(report, rig, setup);
      CheckWindow(report, setup, 0);
      CheckWindow(report, setup, 4);
    });
}
