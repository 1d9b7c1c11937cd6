// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What cannot be drawn gives one error that names the reason, and the window works afterwards.
#include "HeadlessTest.h"

#include "vtkFloatArray.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkWindowToImageFilter.h"

#include <vector>

using namespace HeadlessTest;

namespace
{
const Colour Quad = { 204, 255, 0 };
const Colour Background = { 51, 0, 0 };

//------------------------------------------------------------------------------
// Calls that an application may make although nothing was drawn yet.
void Touch(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> bytes;
  vtkNew<vtkFloatArray> floats;
  Check(window->GetPixelData(0, 0, 1, 1, 1, bytes) == VTK_ERROR, "GetPixelData without a frame");
  Check(
    window->GetPixelData(0, 0, 1, 1, 0, bytes) == VTK_ERROR, "GetPixelData without a frame, back");
  Check(window->GetRGBAPixelData(0, 0, 1, 1, 1, floats) == VTK_ERROR,
    "GetRGBAPixelData without a frame");
  Check(window->GetRGBACharPixelData(0, 0, 1, 1, 1, bytes) == VTK_ERROR,
    "GetRGBACharPixelData without a frame");
  Check(window->GetZbufferData(0, 0, 1, 1, floats) == VTK_ERROR, "GetZbufferData without a frame");
  std::vector<float> values(16, 0.0f);
  std::vector<unsigned char> colours(16, 0);
  Check(window->SetZbufferData(0, 0, 1, 1, values.data()) == VTK_ERROR, "SetZbufferData");
  Check(window->SetPixelData(0, 0, 1, 1, colours.data(), 1) == VTK_ERROR, "SetPixelData");
  Check(window->SetRGBAPixelData(0, 0, 1, 1, values.data(), 1) == VTK_ERROR, "SetRGBAPixelData");
  Check(window->SetRGBACharPixelData(0, 0, 1, 1, colours.data(), 1) == VTK_ERROR,
    "SetRGBACharPixelData");
  window->Frame();
  window->End();
  window->MakeCurrent();
  Check(!window->IsCurrent(), "IsCurrent without a context");
  Check(window->GetGenericContext() == nullptr, "no context");
  window->ReleaseGraphicsResources(window);
}
}

int main()
{
  if (!vtkOITHeadless::Initialize())
  {
    return EXIT_FAILURE;
  }
  if (!HasOwnWindow())
  {
    std::cout << "skipped: VTK's own headless windows are used here, not vtkOITOSMesaRenderWindow"
              << std::endl;
    return Skipped;
  }

  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(MakeScene(Quad, Background));
  {
    Messages messages;
    Touch(window);
    Check(messages.Count() == 0, "a window without a frame reports nothing: " + messages.Get());
  }
  for (const int size : { 100000, 16385 })
  {
    Messages messages;
    window->SetSize(size, size);
    window->Render();
    const std::string text = messages.Get();
    Check(messages.Count() == 1, "one error: " + text);
    Check(text.find(std::to_string(size) + " by ") != std::string::npos &&
        text.find("16384") != std::string::npos && text.find("smaller size") != std::string::npos,
      "the error names the size and the limit: " + text);
    window->Start();
    window->End();
    vtkNew<vtkUnsignedCharArray> bytes;
    Check(window->GetPixelData(0, 0, 0, 0, 1, bytes) == VTK_ERROR, "no pixels after a refusal");
  }
  {
    Messages messages;
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    interactor->Initialize();
    interactor->Render();
    window->SetInteractor(nullptr);
  }
  window->SetSize(50, 50);
  window->Render();
  CheckScene(window, Quad, Background, "after a refusal");

  // A refusal after a good frame, and a good frame after that.
  {
    Messages messages;
    window->SetSize(100000, 10);
    window->Render();
    Check(messages.Count() == 1, "one error after a good frame: " + messages.Get());
  }
  window->SetSize(60, 60);
  window->Render();
  CheckScene(window, Quad, Background, "after a second refusal");
  return GetStatus();
}
