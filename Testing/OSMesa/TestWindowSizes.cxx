// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Every size from one pixel to 8192 by 8192, up and down again in one window, and as a first size.
#include "HeadlessTest.h"

#include <utility>

using namespace HeadlessTest;

int main()
{
  if (!vtkOITHeadless::Initialize())
  {
    return EXIT_FAILURE;
  }
  const Colour green = { 0, 255, 0 };
  const Colour blue = { 0, 0, 102 };
  const std::pair<int, int> sizes[] = { { 300, 200 }, { 1, 1 }, { 640, 480 }, { 17, 4096 },
    { 8192, 8192 }, { 33, 31 }, { 3, 1 }, { 256, 256 } };

  {
    vtkNew<vtkRenderWindow> window;
    window->SetMultiSamples(0);
    window->AddRenderer(MakeScene(green, blue));
    // VTK's own headless windows draw the largest too, in many seconds.
    const int largest = HasOwnWindow() ? 8192 : 4096;
    for (const auto& size : sizes)
    {
      if (size.first > largest)
      {
        continue;
      }
      window->SetSize(size.first, size.second);
      window->Render();
      CheckScene(window, green, blue,
        "resized to " + std::to_string(size.first) + " by " + std::to_string(size.second));
    }
  }
  for (const auto& size : { std::pair<int, int>(1, 1), std::pair<int, int>(1024, 3) })
  {
    vtkNew<vtkRenderWindow> window;
    window->SetMultiSamples(0);
    window->AddRenderer(MakeScene(green, blue));
    window->SetSize(size.first, size.second);
    window->Render();
    CheckScene(window, green, blue,
      "first size " + std::to_string(size.first) + " by " + std::to_string(size.second));
  }
  {
    vtkNew<vtkRenderWindow> window;
    window->AddRenderer(MakeScene(green, blue));
    window->Render();
    Check(window->GetSize()[0] == 300 && window->GetSize()[1] == 300, "default size 300 by 300");
    CheckScene(window, green, blue, "default size");
  }
  return GetStatus();
}
