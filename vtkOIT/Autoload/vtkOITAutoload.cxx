// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// The library in the folder that VTK_AUTOLOAD_PATH names: VTK opens it before it makes its first
// object, and it hooks into the process, see vtkOITProcessHook.
//
// It has none of the functions that VTK looks for in such a library (vtkLoad() and others). VTK would
// refuse a library for another version by a warning of many lines, and append the factory of one for
// its own behind those that draw. So all of the work is done when the library is opened.

#include "vtkOITRunningVTK.h"

namespace
{
[[gnu::constructor]] void Start()
{
  using Function = void (*)();
  if (const auto autoload =
        reinterpret_cast<Function>(vtkOITRunningVTK::FindFunction("vtkOITAutoload")))
  {
    autoload();
  }
}
}
