// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Linking the module and one call are enough to render without a display. This program is linked a
// second time with libGL before everything else, which is the order that would defeat a module that
// relied on the order.
#include "HeadlessTest.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

#include <cstdlib>

using namespace HeadlessTest;

int main()
{
  Check(vtkOITHeadless::GetBackendName().empty(), "no backend before Initialize");
  if (!vtkOITHeadless::Initialize())
  {
    return EXIT_FAILURE;
  }
  Check(vtkOITHeadless::Initialize(), "a second Initialize succeeds");
  const std::string backend = vtkOITHeadless::GetBackendName();
  Check(backend == "OSMesa" || backend == "EGL", "the backend has a name, found " + backend);

  const Colour red = { 255, 0, 0 };
  const Colour grey = { 51, 51, 51 };
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(MakeScene(red, grey));
  window->SetSize(64, 48);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Initialize();
  interactor->Start(); // must return: there is nothing to interact with
  window->Render();
  CheckScene(window, red, grey, "first frame");

  const std::string report = window->ReportCapabilities();
  std::cout << backend << ", " << window->GetClassName() << "\n"
            << report.substr(0, report.find("OpenGL extensions")) << std::endl;
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(window)->GetOpenGLVersion(major, minor);
  Check(major * 10 + minor >= 45,
    "OpenGL 4.5, found " + std::to_string(major) + "." + std::to_string(minor));
  Check(window->SupportsOpenGL() != 0, "SupportsOpenGL");
  Check(window->GetDepthBufferSize() >= 24, "24 bits of depth");
  Check(window->GetScreenSize()[0] > 0 && window->GetScreenSize()[1] > 0, "a screen size");
  if (HasOwnWindow())
  {
    Check(std::string(window->GetRenderingBackend()) == "OSMesa", "GetRenderingBackend");
    Check(report.find("OSMesa") != std::string::npos, "ReportCapabilities names OSMesa");
    Check(window->IsDirect() == 0, "IsDirect");
    window->Print(std::cout);
  }
  // SupportsOpenGL makes a window of its own: this one must still draw.
  window->Render();
  CheckScene(window, red, grey, "after SupportsOpenGL");
  return GetStatus();
}
