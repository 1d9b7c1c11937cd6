// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITOSMesaLiveWindows.h"

#include "vtkOITOSMesaContext.h"
#include "vtkOITOSMesaRenderWindow.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

//------------------------------------------------------------------------------
vtkOITOSMesaLiveWindows& vtkOITOSMesaLiveWindows::Get()
{
  // Never destroyed: a window may end later.
  static auto* instance = new vtkOITOSMesaLiveWindows;
  return *instance;
}

//------------------------------------------------------------------------------
void vtkOITOSMesaLiveWindows::Add(vtkOITOSMesaRenderWindow* window)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->HasExitHandler)
  {
    // Exit handlers run last in, first out, and Mesa set up its own for the first context.
#ifdef __GLIBC__
    this->HasExitHandler = on_exit(&vtkOITOSMesaLiveWindows::Exit, nullptr) == 0;
#else
    this->HasExitHandler = std::atexit([]() { vtkOITOSMesaLiveWindows::Get().Finalize(); }) == 0;
#endif
  }
  this->Windows.insert(window);
}

//------------------------------------------------------------------------------
void vtkOITOSMesaLiveWindows::Remove(vtkOITOSMesaRenderWindow* window)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Windows.erase(window);
}

#ifdef __GLIBC__
//------------------------------------------------------------------------------
void vtkOITOSMesaLiveWindows::Exit(int status, void*)
{
  if (!vtkOITOSMesaContext::FindLossByFork().empty())
  {
    // Mesa's own handler would wait for threads that this process does not have.
    std::cout.flush();
    std::fflush(nullptr);
    _exit(status);
  }
  vtkOITOSMesaLiveWindows::Get().Finalize();
}
#endif

//------------------------------------------------------------------------------
void vtkOITOSMesaLiveWindows::Finalize()
{
  while (vtkOITOSMesaRenderWindow* window = this->GetFirst())
  {
    window->Finalize(); // removes it
  }
}

//------------------------------------------------------------------------------
vtkOITOSMesaRenderWindow* vtkOITOSMesaLiveWindows::GetFirst()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Windows.empty() ? nullptr : *this->Windows.begin();
}
