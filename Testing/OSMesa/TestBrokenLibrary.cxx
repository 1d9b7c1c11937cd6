// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Run with a libOSMesa.so.8 of our own in front of the real one. The argument says what that does:
//
//   never   it makes no context at all: Initialize fails with one error that names the reason
//   once    it makes one context and no more: windows report an error each time and never crash
//   empty   it lacks the functions that are needed
#include "HeadlessTest.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

using namespace HeadlessTest;

int main(int argc, char* argv[])
{
  const std::string mode = argc > 1 ? argv[1] : "";
  Messages messages;
  const bool initialized = vtkOITHeadless::Initialize();
  if (mode != "once")
  {
    const std::string text = messages.Get();
    Check(!initialized && vtkOITHeadless::GetBackendName().empty(), "Initialize fails");
    Check(messages.Count() == 1, "one error: " + text);
    Check(text.find(mode == "empty" ? "has no function OSMesa" : "no OpenGL 3.2 core context") !=
        std::string::npos,
      "the error names the reason: " + text);
    Check(!vtkOITHeadless::Initialize() && messages.Count() == 2, "and again when asked again");
    return GetStatus();
  }

  Check(initialized, "Initialize succeeds: " + messages.Get());
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(MakeScene({ 1, 1, 1 }, { 2, 2, 2 }));
  window->SetSize(20, 20);
  window->Render();
  Check(messages.Count() == 1, "one error: " + messages.Get());
  Check(messages.Get().find("no OpenGL context: ") != std::string::npos,
    "the error names the reason: " + messages.Get());
  window->Start();
  window->Frame();
  window->End();
  vtkNew<vtkUnsignedCharArray> bytes;
  Check(window->GetPixelData(0, 0, 1, 1, 1, bytes) == VTK_ERROR, "no pixels");
  Check(!window->SupportsOpenGL(), "SupportsOpenGL");
  Check(std::string(window->ReportCapabilities()).find("no OpenGL context") != std::string::npos,
    "ReportCapabilities");
  vtkOpenGLRenderWindow::SafeDownCast(window)->PushContext();
  vtkOpenGLRenderWindow::SafeDownCast(window)->PopContext();
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Initialize();
  interactor->Render();
  window->Finalize();
  window->WindowRemap();
  return GetStatus();
}
