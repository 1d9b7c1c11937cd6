// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Quads in front of, inside and behind volumes of constant density, at any depth of a ray, against the
// law of Beer and Lambert: within the rounding of fragments, whatever the order of drawing, the sample
// distance, the bands and the samples of a pixel. Where a volume cannot be mixed with the quads, the
// picture is not called exact.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/LineCatcher.h"
#include "Rig/Rig.h"
#include "Scenes/Light.h"
#include "Scenes/VolumeSlab.h"

#include "vtkActor.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace vtkOITTest;

namespace
{
struct Case
{
  std::string What;
  std::vector<Layer> Layers;
};

std::vector<Case> MakeCases(const Slab& slab)
{
  const float step = static_cast<float>(0.5 * slab.GetSampleDistance());
  const auto inside = [&](float steps) { return slab.Nearest + steps * step; };
  return {
    { "in front, inside and behind", { { 0.1f, Red }, { 0.5f, Green }, { 0.9f, Blue } } },
    { "in front", { { 0.1f, Red }, { 0.2f, Green } } },
    { "behind", { { 0.8f, Red }, { 0.9f, Green } } },
    { "inside", { { 0.4f, Red }, { 0.45f, Green }, { 0.6f, Blue } } },
    { "on the near face", { { slab.Nearest, Red } } },
    { "on the far face", { { slab.Farthest, Red } } },
    { "on a sample", { { inside(7.0f), Red } } },
    { "in the first sample", { { inside(0.25f), Red }, { inside(0.75f), Green } } },
    { "in the last sample", { { inside(slab.Samples - 0.5f), Red } } },
    { "three in one sample",
      { { inside(12.2f), Red }, { inside(12.5f), Green }, { inside(12.8f), Blue } } },
    { "three coincide", { { 0.5f, Red }, { 0.5f, Green }, { 0.5f, Blue } } },
    { "opacity 1 inside", { { 0.4f, Red }, { 0.5f, glm::vec4(0.0f, 1.0f, 0.0f, 1.0f) } } },
  };
}

void CheckCase(Report& report, const Setup& setup, const Slab& slab, const Case& test)
{
  const glm::dvec4 background(0.2, 0.4, 0.6, 0.4);
  const std::vector<Layer> all = PutBetween(test.Layers, { slab });
  const glm::dvec4 expected = ReferenceCompositor::Composite(all, background);
  const Tolerance bound =
    ReferenceCompositor::RoundingBound(all, background, setup.FragmentStorage) + OfSamples;
  std::vector<Layer> layers = test.Layers;
  for (const std::string order : { "front to back", "back to front" })
  {
    Rig rig(setup, 20, 12);
    rig.AddStack(layers);
    AddSlab(rig, slab);
    report.Compare(test.What + ", " + order, rig.Render(), Everywhere(expected), bound);
    report.Check(rig.Pass->GetExact(), test.What + ": not exact");
    report.Check(rig.Pass->GetNumberOfGeometryPasses() == 1, test.What + ": several passes");
    std::reverse(layers.begin(), layers.end());
  }
}

/// Where lists of fragments are not to be had, the volume is drawn over all, and that is said.
void CheckWithoutLists(Report& report, const Setup& setup)
{
  const LineCatcher lines;
  Rig rig(setup, 20, 12);
  rig.AddStack({ { 0.5f, Red } });
  AddSlab(rig, {});
  rig.Render();
  report.Check(!rig.Pass->GetExact() && rig.Pass->GetErrorBound() > 0.0, "called exact");
  report.Check(lines.Describe().find("A volume") != std::string::npos, "no line about the volume");
}

/// The picture does not depend on the sample distance, which VTK's peeling does.
void CheckSampleDistances(Report& report, const Setup& setup)
{
  for (const int samples : { 5, 20, 80 })
  {
    Slab slab;
    slab.Samples = samples;
    CheckCase(report, setup, slab,
      { std::to_string(samples) + " samples",
        { { 0.41f, Red }, { 0.47f, Green }, { 0.61f, Blue } } });
  }
}

/// A limit of memory that makes bands, in each of which the volume's rays of its pixels are cast.
void CheckBands(Report& report, const Setup& setup)
{
  std::vector<Layer> layers;
  for (int i = 0; i < 24; ++i)
  {
    layers.push_back({ 0.2f + 0.025f * i, { i % 2, 0.5f, 1.0f - i % 2, 0.1f } });
  }
  const Slab slab;
  Rig rig(setup, 160, 120);
  rig.Pass->SetMaximumBufferSize(1 << 20);
  rig.AddStack(layers);
  AddSlab(rig, slab);
  const std::vector<Layer> all = PutBetween(layers, { slab });
  report.Compare("bands", rig.Render(),
    Everywhere(ReferenceCompositor::Composite(all, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(all, rig.GetBackground(), setup.FragmentStorage) +
      OfSamples);
  report.Check(rig.Pass->GetNumberOfGeometryPasses() > 1, "bands: one pass");
}

/// Pixels that the volume or the quad does not cover.
void CheckPartlyCovered(Report& report, const Setup& setup)
{
  Slab slab;
  slab.X0 = 0.0f;
  Rig rig(setup, 20, 20);
  const Layer layer{ 0.5f, Red };
  rig.AddQuad(layer, { 0, 0, 20, 10 });
  AddSlab(rig, slab);
  const glm::dvec4 background = rig.GetBackground();
  const auto expected = [&](int x, int y)
  {
    const std::vector<Layer> layers = y < 10 ? std::vector<Layer>{ layer } : std::vector<Layer>{};
    return ReferenceCompositor::Composite(
      x < 10 ? layers : PutBetween(layers, { slab }), background);
  };
  report.Compare("partly covered", rig.Render(), expected,
    ReferenceCompositor::RoundingBoundOfAnyStack(1, setup.FragmentStorage) + OfSamples);
}

/// An opaque quad inside hides what is behind it.
void CheckOpaque(Report& report, const Setup& setup)
{
  Slab slab;
  slab.Samples = 160;
  Rig rig(setup, 20, 12);
  rig.AddQuad({ 0.6f, { 0.0f, 0.0f, 1.0f, 1.0f } });
  rig.AddStack({ { 0.4f, Red }, { 0.65f, Green } });
  AddSlab(rig, slab);
  // The last sample in front of the opaque quad stands for what is behind it, too.
  const double step = slab.GetSampleDistance();
  const Tolerance ofLast = { slab.Opacity * step, slab.Opacity * step };
  const std::vector<Layer> all =
    PutBetween({ { 0.4f, Red }, { 0.6f, { 0.0f, 0.0f, 1.0f, 1.0f } } }, { slab });
  report.Compare("opaque inside", rig.Render(),
    Everywhere(ReferenceCompositor::Composite(all, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(all, rig.GetBackground(), setup.FragmentStorage) +
      OfSamples + ofLast);
}

/// Light adds up to any colour, so the threshold of the transmittance leaves none out.
void CheckLight(Report& report, const Setup& setup)
{
  const std::vector<Layer> layers{ { 0.1f, { 1.0f, 0.0f, 0.0f, 0.99f } },
    { 0.2f, { 0.0f, 1.0f, 0.0f, 0.9f } } };
  const float depth = 0.5f;
  Slab slab;
  slab.Opacity = 0.1f;
  Rig rig(setup, 20, 12);
  rig.Pass->SetTransmittanceThreshold(1.0 / 512.0);
  rig.AddStack(layers);
  AddLight(rig, { rig.ToWorld(10.0, 6.0, depth) }, { 1.0f, 1.0f, 1.0f, 1.0f }, 0.0);
  AddSlab(rig, slab);
  const std::vector<Layer> all = PutBetween(layers, { slab });
  const double inFront = std::pow(1.0 - slab.Opacity, 2.0 * (depth - slab.Nearest));
  const double light = (1.0 - 0.99) * (1.0 - 0.9) * inFront;
  const glm::dvec4 answer =
    ReferenceCompositor::Composite(all, rig.GetBackground()) + glm::dvec4(light, light, light, 0.0);
  report.Compare("light behind the threshold", rig.Render(), Everywhere(answer),
    ReferenceCompositor::RoundingBound(all, rig.GetBackground(), setup.FragmentStorage) +
      OfSamples);
  report.Check(rig.Pass->GetExact(), "light behind the threshold: not exact");
}

/// A window of samples, as windows have them.
void CheckMultisampling(Report& report, const Setup& setup)
{
  const Slab slab;
  const std::vector<Layer> layers{ { 0.2f, Red }, { 0.5f, Green }, { 0.9f, Blue } };
  Rig rig(setup, 24, 16);
  rig.Window->SetMultiSamples(4);
  for (const Layer& layer : layers)
  {
    // The diagonal between the triangles of a quad must not be seen.
    rig.AddQuad(layer);
  }
  AddSlab(rig, slab);
  const std::vector<Layer> all = PutBetween(layers, { slab });
  report.Compare("4 samples a pixel", rig.RenderWindow(),
    Everywhere(ReferenceCompositor::Composite(all, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(all, rig.GetBackground(), setup.FragmentStorage) +
      OfSamples + Rig::WindowTolerance());
  report.Check(rig.Pass->GetExact(), "4 samples a pixel: not exact");
}
}

int TestVolumeSlabs(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      if (setup.UseMode == Use::CameraChain)
      {
        return; // its own volumetric pass comes after ours: see TestVolumeOrder
      }
      if (!setup.HasStorage)
      {
        CheckWithoutLists(report, setup);
        return;
      }
      for (const Case& test : MakeCases({}))
      {
        CheckCase(report, setup, {}, test);
      }
      CheckSampleDistances(report, setup);
      CheckPartlyCovered(report, setup);
      CheckOpaque(report, setup);
      CheckLight(report, setup);
      CheckBands(report, setup);
      if (setup.UseMode == Use::Installed)
      {
        CheckMultisampling(report, setup);
      }
    });
}
