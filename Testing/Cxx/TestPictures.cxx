// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Renders a scene of PictureScenes.h with a method and compares it with the baseline:
//
//   TestPictures <method> <scene> -V <baseline> -T <folder for output> [--against-vtk]
//
// --against-vtk also prints the difference to VTK's dual depth peeling run to completion: a look
// from another side before a picture is made a baseline. It accumulates in 8 bits, so a few steps
// of difference are its own.

#include "Oracle/ImageComparison.h"
#include "Rig/Setup.h"
#include "Scenes/PictureScenes.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <cstdio>
#include <cstring>
#include <vector>

using namespace vtkOITTest;

namespace
{
constexpr int Size = 300;

Image RenderScene(
  Report& report, const std::string& scene, const std::function<void(vtkRenderer*)>& attach)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(Size, Size);
  if (!report.Check(BuildScene(scene, window, attach), "no scene is called '" + scene + "'"))
  {
    return {};
  }
  window->Render();
  window->Render(); // the steady state
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetRGBACharPixelData(0, 0, Size - 1, Size - 1, 0, bytes);
  Image image{ Size, Size, {} };
  for (vtkIdType i = 0; i < Size * Size; ++i)
  {
    const unsigned char* pixel = bytes->GetPointer(4 * i);
    image.Pixels.push_back(glm::vec4(pixel[0], pixel[1], pixel[2], pixel[3]) / 255.0f);
  }
  return image;
}
}

int TestPictures(int argc, char* argv[])
{
  return RunTest(argc, argv, Setups::Storages,
    [argc, argv](Report& report, const Setup& setup)
    {
      if (setup.FragmentStorage != Storage::Half)
      {
        return; // pictures show the default
      }
      const std::string scene = argc > 2 ? argv[2] : "";
      std::vector<vtkSmartPointer<vtkOITPass>> passes;
      const Image image = RenderScene(report, scene,
        [&](vtkRenderer* renderer)
        {
          passes.push_back(setup.CreatePass());
          setup.Attach(renderer, passes.back());
        });
      if (image.Pixels.empty())
      {
        return;
      }
      for (int i = 1; i < argc; ++i)
      {
        if (std::strcmp(argv[i], "--against-vtk") == 0)
        {
          const Image peeled = RenderScene(report, scene,
            [](vtkRenderer* renderer)
            {
              renderer->UseDepthPeelingOn();
              renderer->SetMaximumNumberOfPeels(1000);
              renderer->SetOcclusionRatio(0.0);
            });
          const ImageDifference difference = FindDifference(image, peeled, ImageLimits());
          std::printf("difference to VTK's dual depth peeling: max %.0f, mean %.4f, %d pixels "
                      "beyond 3\n",
            difference.Maximum, difference.Mean, difference.Outliers);
        }
      }
      ImageLimits limits;
      if (!setup.HasFetch)
      {
        // Blending in the window's 8 bits is off by up to 1.5 steps, and so by one for up to half
        // of the channels once rounded; that goes for every pixel that has a layer.
        limits.Mean = 0.5;
      }
      report.Check(CompareWithBaseline(image, ImageArguments::Parse(argc, argv), limits),
        scene + " differs from its baseline");
    });
}
