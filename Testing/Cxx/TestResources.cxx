// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// 200 renders with resizes, other ways of use and other passes leave the OpenGL objects and the
// memory of the process where they were.

#include "Rig/GLObjects.h"
#include "Rig/Rig.h"
#include "Scenes/Random.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkOITPass.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <unistd.h>

#include <fstream>
#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace vtkOITTest;

namespace
{
/// Resident memory of this process in bytes; 0 where the system does not say. Without what the
/// allocator keeps for later, which depends on how Mesa's threads take turns.
double GetResidentMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void AddScene(Rig& rig)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(30);
  sphere->SetPhiResolution(30);
  sphere->Update();
  for (int i = 0; i < 6; ++i)
  {
    rig.AddPolyData(sphere->GetOutput(), { 0.1f * i, 0.5f, 0.9f - 0.1f * i, i ? 0.3f : 1.0f })
      ->SetPosition(0.2 * i - 0.5, 0.0, 0.1 * i);
  }
}

/// One round of what an application may do; ends as it began, with a window of size x size.
void RenderRound(Rig& rig, Setup setup, int round, int size)
{
  const std::pair<int, int> sizes[] = { { size, size }, { 2 * size / 5, 5 * size / 7 },
    { 7 * size / 6, size / 6 }, { size, size } };
  for (const auto& next : sizes)
  {
    rig.SetSize(next.first, next.second);
    rig.Window->Render();
  }
  setup.Detach(rig.Renderer);
  rig.Window->Render();
  for (const Use use : { Use::RenderSteps, Use::CameraChain, Use::Installed })
  {
    setup.UseMode = use;
    rig.Pass = setup.CreatePass(); // the one before is dropped with its resources
    rig.Pass->SetMaximumBufferSize(round % 2 ? 1 << 20 : 0);
    setup.Attach(rig.Renderer, rig.Pass);
    rig.Window->Render();
    if (setup.Method != "multilayer") // which keeps half floats only
    {
      rig.Pass->SetFragmentPrecision(1 - rig.Pass->GetFragmentPrecision());
    }
    rig.Window->Render();
    if (use != Use::Installed)
    {
      setup.Detach(rig.Renderer);
    }
  }
  rig.Window->SetMultiSamples(round % 2 ? 4 : 0);
  rig.Window->Render();
  rig.Window->SetMultiSamples(0);
  rig.Window->Render();
}

/// Uninstalling frees what the pass holds on the context, though the pass lives on. VTK keeps the
/// programs.
void CheckRelease(Report& report, Rig& rig, const Setup& setup)
{
  const auto pass = setup.CreatePass();
  GLObjectCounts counts[2];
  for (GLObjectCounts& count : counts)
  {
    setup.Detach(rig.Renderer);
    rig.Window->Render();
    rig.Window->MakeCurrent();
    count = GLObjectCounts::OfCurrentContext();
    setup.Attach(rig.Renderer, pass);
    rig.Window->Render();
  }
  rig.Window->MakeCurrent();
  const GLObjectCounts installed = GLObjectCounts::OfCurrentContext();
  report.Check(installed.Textures + installed.Buffers > counts[0].Textures + counts[0].Buffers,
    "an installed pass holds nothing, so nothing can be missed");
  report.Check(counts[0].Textures == counts[1].Textures && counts[0].Buffers == counts[1].Buffers &&
      counts[0].Framebuffers == counts[1].Framebuffers &&
      counts[0].VertexArrays == counts[1].VertexArrays,
    "uninstalling went from " + counts[0].Describe() + " to " + counts[1].Describe());
}
}

int TestResources(int argc, char* argv[])
{
  bool done = false; // a round goes through all storages and uses itself
  return RunTest(argc, argv, Setups::Storages,
    [&done](Report& report, const Setup& setup)
    {
      if (done)
      {
        return;
      }
      done = true;
      // Buckets keep so much per pixel that 1 MiB means dozens of bands, draw each many times, and
      // take long for each pixel: a smaller window with two bands or three, and fewer rounds.
      const bool hasBuckets = setup.Method.rfind("bucket", 0) == 0;
      const int size = hasBuckets ? 64 : 256;
      Rig rig(setup, size, size);
      AddScene(rig);
      // The first rounds fill VTK's shader cache and Mesa's caches of compiled code, and make the
      // timers of VTK's mappers, which start after 100 draws.
      constexpr int warmUp = 10;
      const int rounds = hasBuckets ? 4 : 16; // of 13 renders
      for (int round = 0; round < warmUp; ++round)
      {
        RenderRound(rig, setup, round, size);
      }
      rig.Window->MakeCurrent();
      const GLObjectCounts before = GLObjectCounts::OfCurrentContext();
      const double memoryBefore = GetResidentMemory();
      report.Check(before.Textures > 0 && before.Programs > 0,
        "no objects were found, so none can be missed: " + before.Describe());
      for (int round = warmUp; round < warmUp + rounds; ++round)
      {
        RenderRound(rig, setup, round, size);
      }
      // Before the check below, which leaves a pass that may hold as much as it likes.
      const double memoryAfter = GetResidentMemory();
      rig.Window->MakeCurrent();
      const GLObjectCounts after = GLObjectCounts::OfCurrentContext();
      report.Check(
        before == after, "objects went from " + before.Describe() + " to " + after.Describe());
      CheckRelease(report, rig, setup);
      // The heads of the lists alone are 4 bytes a pixel, 256 KiB here: leaking that in each of the
      // 48 attachments would be 12 MiB, and a store of fragments more. Allocators keep less.
      const double growth = (memoryAfter - memoryBefore) / 1048576.0;
      std::printf("resident memory grew by %.1f MiB\n", growth);
#ifdef __SANITIZE_ADDRESS__
      std::printf(
        "not checked: AddressSanitizer's quarantine keeps freed memory; its leak check at "
        "the end of the process takes the place of this one\n");
#else
      // The others keep 35 bytes and more per pixel, which would be 105 MiB; buckets 232, which
      // would be 11 MiB in the 12 attachments here.
      const double allowed = setup.Method == "abuffer" || hasBuckets ? 8.0 : 50.0;
      report.Check(growth < allowed, "the process grew by " + std::to_string(growth) + " MiB");
#endif
    });
}
