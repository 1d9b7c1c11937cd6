// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A library that calls OpenGL and is loaded when frames have been drawn already, as Python loads
// VTK's volume mappers: from the next frame on its calls reach OSMesa.
#include "HeadlessTest.h"

#include <dlfcn.h>

using namespace HeadlessTest;

int main(int argc, char* argv[])
{
  if (argc < 2 || !vtkOITHeadless::Initialize())
  {
    std::cerr << "usage: TestLateLibrary LIBRARY" << std::endl;
    return EXIT_FAILURE;
  }
  const Colour quad = { 0, 255, 255 };
  const Colour background = { 102, 0, 0 };
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(MakeScene(quad, background));
  window->SetSize(40, 40);
  window->Render();

  void* library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  if (!library)
  {
    std::cerr << dlerror() << std::endl;
    return EXIT_FAILURE;
  }
  window->Render();
  CheckScene(window, quad, background, "after loading");
  window->MakeCurrent();
  using GetRenderer = const char* (*)();
  auto getRenderer = reinterpret_cast<GetRenderer>(dlsym(library, "GetRenderer"));
  Check(getRenderer != nullptr, "GetRenderer");
  const char* renderer = getRenderer ? getRenderer() : nullptr;
  Check(renderer && *renderer, "the library's call reaches OSMesa");
  std::cout << (renderer ? renderer : "no renderer") << std::endl;
  return GetStatus();
}
