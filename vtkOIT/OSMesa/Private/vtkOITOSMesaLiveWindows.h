// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITOSMesaLiveWindows_h
#define vtkOITOSMesaLiveWindows_h

#include <mutex>
#include <set>

class vtkOITOSMesaRenderWindow;

/**
 * The windows that have a context. Mesa tears itself down when the process exits, before static
 * objects are destroyed; what a window still holds then must be released earlier.
 */
class vtkOITOSMesaLiveWindows
{
public:
  static vtkOITOSMesaLiveWindows& Get();

  void Add(vtkOITOSMesaRenderWindow* window);
  void Remove(vtkOITOSMesaRenderWindow* window);

private:
  vtkOITOSMesaLiveWindows() = default;

#ifdef __GLIBC__
  static void Exit(int status, void*);
#endif
  void Finalize();
  vtkOITOSMesaRenderWindow* GetFirst();

  std::mutex Mutex;
  std::set<vtkOITOSMesaRenderWindow*> Windows;
  bool HasExitHandler = false;
};

#endif
