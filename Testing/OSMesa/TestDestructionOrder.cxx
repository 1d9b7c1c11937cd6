// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Windows, renderers and what they show end in any order, and windows end and begin again.
#include "HeadlessTest.h"

#include "vtkRendererCollection.h"

using namespace HeadlessTest;

namespace
{
const Colour Quad = { 255, 0, 255 };
const Colour Background = { 0, 51, 0 };

vtkSmartPointer<vtkRenderWindow> MakeWindow(vtkRenderer* renderer)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetSize(60, 60);
  window->AddRenderer(renderer);
  window->Render();
  CheckScene(window, Quad, Background, "window");
  return window;
}

void WindowFirst()
{
  auto renderer = MakeScene(Quad, Background);
  auto window = MakeWindow(renderer);
  window = nullptr;
  Check(renderer->GetRenderWindow() == nullptr, "the window's end detaches its renderer");
  // The same renderer in a new window: nothing of the old context may be left in it.
  window = MakeWindow(renderer);
  window = nullptr;
  renderer = nullptr;
}

void RendererFirst()
{
  auto renderer = MakeScene(Quad, Background);
  auto window = MakeWindow(renderer);
  renderer = nullptr; // the window still holds it
  window->RemoveRenderer(window->GetRenderers()->GetFirstRenderer());
  window->Render();
  window->AddRenderer(MakeScene(Quad, Background));
  window->Render();
  CheckScene(window, Quad, Background, "window with a new renderer");
}

void WhileAnotherIsCurrent()
{
  auto first = MakeWindow(MakeScene(Quad, Background));
  auto second = MakeWindow(MakeScene(Quad, Background));
  auto third = MakeWindow(MakeScene(Quad, Background));
  second->MakeCurrent();
  first = nullptr;
  second->Render();
  CheckScene(second, Quad, Background, "current window after another's end");
  second = nullptr;
  third->Render();
  CheckScene(third, Quad, Background, "window after the current one's end");
}

void PropInTwoWindows()
{
  auto renderer = MakeScene(Quad, Background);
  auto first = MakeWindow(renderer);
  first->RemoveRenderer(renderer);
  auto second = MakeWindow(renderer);
  first = nullptr;
  second->Render();
  CheckScene(second, Quad, Background, "renderer that moved");
}

void Again()
{
  auto window = MakeWindow(MakeScene(Quad, Background));
  for (int i = 0; i < 3; ++i)
  {
    window->Finalize();
    window->Finalize(); // no harm
    window->SetSize(60 + i, 60);
    window->Render();
    CheckScene(window, Quad, Background, "window after Finalize");
  }
  window->WindowRemap();
  window->Render();
  CheckScene(window, Quad, Background, "window after WindowRemap");
  window->Finalize();
}

// A window that is still there when main ends: its end comes after that of most static objects.
vtkSmartPointer<vtkRenderWindow> Last;

void NeverRendered()
{
  vtkNew<vtkRenderWindow> empty;
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(MakeScene(Quad, Background));
  window->Finalize();
}
}

int main()
{
  if (!vtkOITHeadless::Initialize())
  {
    return EXIT_FAILURE;
  }
  NeverRendered();
  WindowFirst();
  RendererFirst();
  WhileAnotherIsCurrent();
  PropInTwoWindows();
  Again();
  if (HasOwnWindow()) // VTK's window of OSMesa crashes then
  {
    Last = MakeWindow(MakeScene(Quad, Background));
  }
  return GetStatus();
}
