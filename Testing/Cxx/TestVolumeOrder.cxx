// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// When volumes are drawn: before, between and after the translucent props, several of them, by others
// than the pass, and by mappers that cannot be mixed. The picture is right, or not called exact.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/LineCatcher.h"
#include "Rig/Rig.h"
#include "Scenes/VolumeSlab.h"

#include "vtkActor.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOITRendererHook.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <functional>
#include <string>

using namespace vtkOITTest;

namespace
{
Slab MakeThin(float nearest, float farthest, const glm::vec3& color)
{
  Slab slab;
  slab.Nearest = nearest;
  slab.Farthest = farthest;
  slab.Color = color;
  return slab;
}

/// The scene in this order of volumes, compared with what is right.
void Compare(Report& report, const Setup& setup, const std::string& what,
  const std::vector<Layer>& layers, const std::vector<Slab>& slabs)
{
  Rig rig(setup, 20, 12);
  rig.AddStack(layers);
  for (const Slab& slab : slabs)
  {
    AddSlab(rig, slab);
  }
  const std::vector<Layer> all = PutBetween(layers, slabs);
  report.Compare(what, rig.Render(),
    Everywhere(ReferenceCompositor::Composite(all, rig.GetBackground())),
    ReferenceCompositor::RoundingBound(all, rig.GetBackground(), setup.FragmentStorage) +
      OfSamples);
  report.Check(rig.Pass->GetExact(), what + ": not exact");
  const auto props = static_cast<int>(layers.size() + slabs.size());
  report.Check(rig.Pass->GetNumberOfRenderedProps() == props, what + ": other props are drawn");
}

void CheckSeveral(Report& report, const Setup& setup)
{
  const Slab first = MakeThin(0.2f, 0.3f, { 1.0f, 0.6f, 0.2f });
  const Slab second = MakeThin(0.4f, 0.5f, { 0.2f, 0.6f, 1.0f });
  const Slab third = MakeThin(0.6f, 0.7f, { 0.4f, 1.0f, 0.4f });
  const std::vector<Layer> inside{ { 0.25f, Red }, { 0.45f, Green }, { 0.65f, Blue } };
  const std::vector<Layer> between{ { 0.1f, Red }, { 0.35f, Green }, { 0.55f, Blue },
    { 0.8f, Red } };
  std::vector<Slab> slabs{ first, second, third };
  const auto isNearer = [](const Slab& a, const Slab& b) { return a.Nearest < b.Nearest; };
  do
  {
    const std::string order =
      std::to_string(slabs[0].Nearest) + " " + std::to_string(slabs[1].Nearest);
    Compare(report, setup, "quads in three volumes, " + order, inside, slabs);
    Compare(report, setup, "quads between three volumes, " + order, between, slabs);
    Compare(report, setup, "one quad, three volumes, " + order, { { 0.45f, Red } }, slabs);
  } while (std::next_permutation(slabs.begin(), slabs.end(), isNearer));
  Compare(report, setup, "in front", { { 0.8f, Red }, { 0.9f, Green } }, { third, first });
  Compare(report, setup, "behind", { { 0.05f, Red }, { 0.1f, Green } }, { first, third });
  Compare(report, setup, "in front and behind", { { 0.5f, Red } }, { first, third });
}

/// Volumes that overlap: their order is not known.
void CheckOverlap(Report& report, const Setup& setup)
{
  const LineCatcher lines;
  Rig rig(setup, 20, 12);
  rig.AddStack({ { 0.45f, Red } });
  AddSlab(rig, MakeThin(0.3f, 0.5f, { 1.0f, 0.6f, 0.2f }));
  AddSlab(rig, MakeThin(0.4f, 0.6f, { 0.2f, 0.6f, 1.0f }));
  rig.Render();
  report.Check(!rig.Pass->GetExact() && rig.Pass->GetErrorBound() > 0.0, "overlap: called exact");
  report.Check(lines.Describe().find("vtkMultiVolume") != std::string::npos, "overlap: no line");
}

/// A volume that somebody else draws, or cannot be mixed: right only in front of all.
void CheckOver(Report& report, const Setup& setup, const std::string& what, bool isBehindRight,
  const std::function<void(Rig&, vtkVolume*)>& change)
{
  const Slab slab;
  for (const float depth : { 0.2f, 0.5f, 0.8f })
  {
    const LineCatcher lines;
    Rig rig(setup, 20, 12);
    const std::vector<Layer> layers{ { depth, Red } };
    rig.AddStack(layers);
    change(rig, AddSlab(rig, slab));
    const Image image = rig.Render();
    const std::string where = what + ", quad at " + std::to_string(depth);
    const bool isRight = depth > slab.Farthest || (isBehindRight && depth < slab.Nearest);
    report.Check(rig.Pass->GetExact() == isRight, where + ": exact is wrong");
    report.Check(
      lines.GetTexts().size() == (isRight ? 0 : 1), where + ": lines: " + lines.Describe());
    if (isRight)
    {
      const std::vector<Layer> all = PutBetween(layers, { slab });
      const Tolerance ofCPU = { 0.02, 0.02 }; // its pictures have 8 bits, its samples lie otherwise
      report.Compare(where, image,
        Everywhere(ReferenceCompositor::Composite(all, rig.GetBackground())),
        ReferenceCompositor::RoundingBound(all, rig.GetBackground(), setup.FragmentStorage) +
          OfSamples + (isBehindRight ? ofCPU : Tolerance()));
    }
  }
}

/// Without translucent props the pass is not asked, and volumes are as they were.
void CheckAlone(Report& report, const Setup& setup)
{
  Rig rig(setup, 20, 12);
  AddSlab(rig, {});
  const Image with = rig.Render();
  report.Check(rig.Pass->GetExact() && rig.Pass->GetNumberOfGeometryPasses() == 0, "alone: drawn");
  vtkOITRendererHook::Uninstall(rig.Renderer);
  report.CompareBits("alone", with, rig.Render());
}

/// What the hook switches on, it switches off again.
void CheckSwitch(Report& report, const Setup& setup)
{
  for (const bool before : { false, true })
  {
    Rig rig(setup, 8, 8);
    setup.Detach(rig.Renderer);
    rig.Renderer->SetUseDepthPeelingForVolumes(before);
    vtkOITRendererHook::Install(rig.Renderer, rig.Pass);
    report.Check(rig.Renderer->GetUseDepthPeelingForVolumes(), "not switched on");
    vtkOITRendererHook::Uninstall(rig.Renderer);
    report.Check(rig.Renderer->GetUseDepthPeelingForVolumes() == before, "not given back");
  }
}
}

int TestVolumeOrder(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      if (!setup.HasStorage || setup.FragmentStorage != Storage::Half)
      {
        return; // see TestVolumeSlabs
      }
      if (setup.UseMode == Use::CameraChain)
      {
        CheckOver(report, setup, "a pass after ours", false, [](Rig&, vtkVolume*) {});
        return;
      }
      CheckSeveral(report, setup);
      CheckOverlap(report, setup);
      CheckOver(report, setup, "CPU mapper", true,
        [](Rig&, vtkVolume* volume)
        {
          vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
          mapper->SetInputData(GetMapper(volume)->GetInput());
          mapper->AutoAdjustSampleDistancesOff();
          mapper->SetSampleDistance(GetMapper(volume)->GetSampleDistance());
          mapper->SetImageSampleDistance(1.0f);
          volume->SetMapper(mapper);
        });
      if (setup.UseMode == Use::Installed)
      {
        CheckOver(report, setup, "switched off", false,
          [](Rig& rig, vtkVolume*) { rig.Renderer->UseDepthPeelingForVolumesOff(); });
        CheckAlone(report, setup);
        CheckSwitch(report, setup);
      }
    });
}
