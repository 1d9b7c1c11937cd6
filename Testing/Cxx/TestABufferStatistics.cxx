// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// What the pass reports about a frame, for frames whose numbers are known.

#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkOITABufferPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

using namespace vtkOITTest;

namespace
{
void CheckStatistics(Report& report, Rig& rig, const std::string& what, int passes,
  vtkTypeInt64 fragments, int complexity)
{
  report.Check(rig.Pass->GetNumberOfGeometryPasses() == passes,
    what + ": geometry passes " + std::to_string(rig.Pass->GetNumberOfGeometryPasses()) +
      ", expected " + std::to_string(passes));
  report.Check(rig.Pass->GetNumberOfFragments() == fragments,
    what + ": fragments " + std::to_string(rig.Pass->GetNumberOfFragments()) + ", expected " +
      std::to_string(fragments));
  report.Check(rig.Pass->GetMaximumDepthComplexity() == complexity,
    what + ": depth complexity " + std::to_string(rig.Pass->GetMaximumDepthComplexity()) +
      ", expected " + std::to_string(complexity));
  report.Check(rig.Pass->GetExact(), what + ": is reported as not exact");
  report.Check(rig.Pass->GetErrorBound() == 0.0, what + ": has an error bound");
}
}

int TestABufferStatistics(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::All,
    [](Report& report, const Setup& setup)
    {
      Rig rig(setup, 32, 16);
      report.Check(std::string(rig.Pass->GetAlgorithmName()) == "A-buffer", "another algorithm");
      rig.AddQuad({ 0.9f, { 0.5f, 0.5f, 0.5f, 1.0f } });
      rig.Render();
      CheckStatistics(report, rig, "nothing translucent", 0, 0, 0);
      report.Check(rig.Pass->GetBufferSizeInBytes() == 0, "nothing translucent: buffers");

      const glm::vec4 color(0.9f, 0.5f, 0.1f, 0.25f);
      Random random(3);
      for (const float depth : random.Depths(7))
      {
        rig.AddQuad({ depth * 0.5f, color }, { 4.0, 2.0, 24.0, 12.0 }); // 200 pixels
      }
      rig.AddEqualLayers({ 0.1f, 0.2f, 0.3f }, color); // 512 pixels
      rig.Render();
      rig.Render();
      CheckStatistics(report, rig, "ten layers", 1, 7 * 200 + 3 * 512, 10);
      const vtkTypeInt64 bytes = rig.Pass->GetBufferSizeInBytes();
      const int node = setup.FragmentStorage == Storage::Half ? 12 : 20; // depth, colour
      report.Check(bytes >= (7 * 200 + 3 * 512) * node,
        "ten layers: the pass reports only " + std::to_string(bytes) + " bytes");

      // Opaque geometry in front of the left half: its fragments are hidden and not captured.
      rig.AddQuad({ 0.01f, { 0.2f, 0.2f, 0.2f, 1.0f } }, { 0.0, 0.0, 14.0, 16.0 });
      rig.Render();
      CheckStatistics(report, rig, "half hidden", 1, 7 * 100 + 3 * 18 * 16, 10);

      // All of it hidden.
      rig.AddQuad({ 0.01f, { 0.2f, 0.2f, 0.2f, 1.0f } });
      rig.Render();
      CheckStatistics(report, rig, "all hidden", 1, 0, 0);

      rig.RemoveProps();
      rig.Render();
      if (setup.UseMode != Use::Installed) // a renderer with nothing translucent calls no pass
      {
        CheckStatistics(report, rig, "props removed", 0, 0, 0);
      }
      rig.Pass->ReleaseGraphicsResources(rig.Window);
      report.Check(rig.Pass->GetBufferSizeInBytes() == 0, "released, but buffers are reported");
    });
}
