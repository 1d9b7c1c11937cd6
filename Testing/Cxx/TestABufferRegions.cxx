// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Regions of the screen with memory of their own: how often the counter is used that all threads share is
// known for each frame, and the picture is the same with regions, without, and where one was exceeded.

#include "Rig/Rig.h"

#include "vtkOITABufferPass.h"

using namespace vtkOITTest;

namespace
{
constexpr int Width = 200; // four regions, the last one in part
constexpr int Height = 150;
constexpr vtkTypeInt64 Pixels = vtkTypeInt64{ Width } * Height;

const glm::vec4 Color(0.9f, 0.5f, 0.1f, 0.25f);

void AddLayers(Rig& rig)
{
  rig.AddEqualLayers({ 0.1f, 0.5f, 0.3f, 0.4f, 0.2f }, Color);
}

/// In one region where nothing let expect it.
void AddDeepSpot(Rig& rig)
{
  for (int i = 0; i < 60; ++i)
  {
    const float shade = static_cast<float>(i) / 60.0f;
    rig.AddQuad(
      { 0.25f + 0.005f * static_cast<float>((i * 37) % 60), { shade, 0.5f, 1.0f - shade, 0.05f } },
      { 70.0, 70.0, 120.0, 120.0 });
  }
}

void CheckShared(Report& report, const Rig& rig, const std::string& what, vtkTypeInt64 expected)
{
  const auto* pass = vtkOITABufferPass::SafeDownCast(rig.Pass);
  const vtkTypeInt64 shared = pass ? pass->GetNumberOfSharedAllocations() : -1;
  report.Check(shared == expected,
    what + ": " + std::to_string(shared) + " shared allocations, expected " +
      std::to_string(expected));
}
}

int TestABufferRegions(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      // Five fragments take two pages of four; without framebuffer fetch each takes a node.
      const vtkTypeInt64 each = setup.HasFetch ? 2 * Pixels : 5 * Pixels;
      Rig rig(setup, Width, Height);
      AddLayers(rig);
      const Image first = rig.Render();
      CheckShared(report, rig, "first frame", each);
      // More room than the pool has is worth it from the ninth frame on.
      for (int i = 2; i < 12; ++i)
      {
        const std::string frame = "frame " + std::to_string(i);
        report.CompareBits(frame, rig.Render(), first);
        CheckShared(report, rig, frame, setup.HasFetch && i > 8 ? 0 : each);
        report.Check(
          rig.Pass->GetNumberOfGeometryPasses() == 1, "regions that are large enough, twice");
        report.Check(rig.Pass->GetNumberOfFragments() == 5 * Pixels, "fragments with regions");
      }

      Rig fresh(setup, Width, Height);
      AddLayers(fresh);
      AddDeepSpot(fresh);
      const Image expected = fresh.Render();
      AddDeepSpot(rig);
      report.CompareBits("an exceeded region", rig.Render(), expected);
      // 60 more fragments go on in the second page, which has three nodes left.
      const vtkTypeInt64 spot = 50 * 50 * vtkTypeInt64{ setup.HasFetch ? 15 : 60 };
      CheckShared(report, rig, "an exceeded region", each + spot);
      report.Check(rig.Pass->GetExact(), "an exceeded region is reported as not exact");
      if (setup.HasFetch)
      {
        report.Check(
          rig.Pass->GetNumberOfGeometryPasses() == 2, "no region was exceeded: this tests nothing");
      }
      for (int i = 0; i < 10; ++i)
      {
        report.CompareBits("after that", rig.Render(), expected);
        report.Check(rig.Pass->GetNumberOfGeometryPasses() == 1, "later frames are drawn twice");
      }
      CheckShared(report, rig, "regions again", setup.HasFetch ? 0 : each + spot);

      // Fewer layers in the same pool have regions from the third frame on, this one counted.
      fresh.RemoveProps();
      fresh.AddEqualLayers({ 0.5f }, Color);
      for (int i = 2; i < 5; ++i)
      {
        fresh.Render();
        CheckShared(report, fresh, "one layer, frame " + std::to_string(i),
          setup.HasFetch && i > 2 ? 0 : Pixels);
      }

      // In bands there are none, and a picture of another size has others.
      rig.Pass->SetMaximumBufferSize(1 << 20);
      report.CompareBits("in bands", rig.Render(), expected);
      rig.Pass->SetMaximumBufferSize(0);
      report.CompareBits("without a limit", rig.Render(), expected);
    });
}
