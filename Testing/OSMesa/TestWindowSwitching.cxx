// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Several windows at once: each keeps its picture and its context whatever the others do.
#include "HeadlessTest.h"

#include "vtkOpenGLRenderWindow.h"

#include <thread>
#include <vector>

using namespace HeadlessTest;

namespace
{
constexpr int Count = 4;

Colour GetQuad(int i)
{
  return { static_cast<unsigned char>(51 * i), 255, 0 };
}

Colour GetBackground(int i)
{
  return { 0, static_cast<unsigned char>(51 * i), 51 };
}

void CheckAll(const std::vector<vtkSmartPointer<vtkRenderWindow>>& windows, const char* what)
{
  for (int i = 0; i < Count; ++i)
  {
    CheckScene(windows[i], GetQuad(i), GetBackground(i), what + (" window " + std::to_string(i)));
  }
}
}

int main()
{
  if (!vtkOITHeadless::Initialize())
  {
    return EXIT_FAILURE;
  }
  std::vector<vtkSmartPointer<vtkRenderWindow>> windows;
  for (int i = 0; i < Count; ++i)
  {
    windows.push_back(vtkSmartPointer<vtkRenderWindow>::New());
    windows[i]->AddRenderer(MakeScene(GetQuad(i), GetBackground(i)));
    windows[i]->SetSize(40 + 20 * i, 100 - 20 * i);
  }
  // All are drawn before any is read, in both orders.
  for (int i = 0; i < Count; ++i)
  {
    windows[i]->Render();
  }
  CheckAll(windows, "forward");
  for (int i = Count - 1; i >= 0; --i)
  {
    windows[i]->Render();
  }
  CheckAll(windows, "backward");

  const bool own = HasOwnWindow();
  // Current is the one that was asked for, and what was current comes back.
  for (int i = 0; i < Count; ++i)
  {
    windows[i]->MakeCurrent();
    Check(windows[i]->IsCurrent(), "MakeCurrent");
    for (int j = 0; j < Count; ++j)
    {
      if (own) // VTK's window of EGL calls itself current always
      {
        Check(windows[j]->IsCurrent() == (i == j), "IsCurrent");
      }
      auto* inner = vtkOpenGLRenderWindow::SafeDownCast(windows[j]);
      inner->PushContext();
      Check(inner->IsCurrent(), "PushContext makes current");
      inner->PopContext();
      if (own) // VTK's window of OSMesa restores nothing
      {
        Check(windows[i]->IsCurrent(), "PopContext restores");
      }
    }
  }

  // A window in use stays current while another is resized, shrunk to nothing and destroyed.
  windows[0]->MakeCurrent();
  {
    vtkNew<vtkRenderWindow> other;
    other->AddRenderer(MakeScene({ 1, 1, 1 }, { 2, 2, 2 }));
    other->Render();
    other->SetSize(10, 10);
    other->Render();
    windows[0]->MakeCurrent();
  }
  if (own)
  {
    Check(windows[0]->IsCurrent(), "another window's end leaves the current one alone");
  }
  CheckAll(windows, "after another window's end");

  // One thread after the other.
  windows[Count - 1]->MakeCurrent();
  std::thread(
    []
    {
      vtkNew<vtkRenderWindow> window;
      window->AddRenderer(MakeScene({ 0, 0, 255 }, { 255, 255, 255 }));
      window->SetSize(50, 50);
      window->Render();
      CheckScene(window, { 0, 0, 255 }, { 255, 255, 255 }, "window of another thread");
    })
    .join();
  for (auto& window : windows)
  {
    window->Render();
  }
  CheckAll(windows, "after another thread");

  // A window that shares with another draws as well as before, and outlives it.
  if (windows[0]->GetPlatformSupportsRenderWindowSharing())
  {
    vtkNew<vtkRenderWindow> sharing;
    sharing->SetSharedRenderWindow(windows[0]);
    sharing->AddRenderer(MakeScene({ 255, 255, 0 }, { 0, 0, 0 }));
    sharing->Render();
    CheckScene(sharing, { 255, 255, 0 }, { 0, 0, 0 }, "sharing window");
    sharing->SetSharedRenderWindow(nullptr);
    windows[0] = nullptr;
    sharing->Render();
    CheckScene(sharing, { 255, 255, 0 }, { 0, 0, 0 }, "sharing window, alone");
  }
  return GetStatus();
}
