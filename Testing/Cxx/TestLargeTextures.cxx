// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// A window so large that llvmpipe refuses the textures of a method: it is drawn in bands, rightly.

#include "Oracle/ReferenceCompositor.h"
#include "Rig/LineCatcher.h"
#include "Rig/Rig.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

using namespace vtkOITTest;

int TestLargeTextures(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [](Report& report, const Setup& setup)
    {
      const bool isDual = setup.Method == "dual";
      if (setup.Tier != "all extensions" || (isDual && setup.FragmentStorage == Storage::Float32))
      {
        return;
      }
      // Its largest texture array takes more than 1 GiB.
      const int size = isDual ? 5000 : 4300;
      const std::vector<Layer> layers{ { 0.25f, { 1.0f, 0.2f, 0.0f, 0.5f } },
        { 0.5f, { 0.0f, 1.0f, 0.4f, 0.5f } }, { 0.75f, { 0.6f, 0.0f, 1.0f, 0.5f } } };
      Rig rig(setup, size, size);
      rig.AddStack(layers);
      const LineCatcher lines;
      rig.Window->Render();
      report.Check(rig.Pass->GetExact(), "not exact");
      report.Check(lines.GetTexts().empty(), "lines are printed" + lines.Describe());
      Image column{ 1, size, {} };
      vtkNew<vtkUnsignedCharArray> bytes;
      rig.Window->GetRGBACharPixelData(size / 2, 0, size / 2, size - 1, 0, bytes);
      for (int y = 0; y < size; ++y)
      {
        const unsigned char* pixel = bytes->GetPointer(4 * y);
        column.Pixels.emplace_back(
          pixel[0] / 255.0f, pixel[1] / 255.0f, pixel[2] / 255.0f, pixel[3] / 255.0f);
      }
      report.Compare(std::to_string(size) + " x " + std::to_string(size), column,
        Everywhere(ReferenceCompositor::Composite(layers, rig.GetBackground())),
        ReferenceCompositor::RoundingBoundOfAnyStack(3, setup.FragmentStorage) +
          Rig::WindowTolerance());
    });
}
