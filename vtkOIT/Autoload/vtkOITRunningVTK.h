// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITRunningVTK_h
#define vtkOITRunningVTK_h

/**
 * The VTK that is loaded in this process, looked at from a library that is linked to none: linking
 * would load a second VTK into a program that has another one, and crash it.
 */
namespace vtkOITRunningVTK
{
/// A function of libvtkOIT, which is loaded for it. nullptr, with one line on standard error (the
/// first time), when the process has not the VTK that vtkOIT was built for.
void* FindFunction(const char* name);

/// VTK's own function of that (mangled) name, which a library of LD_PRELOAD hides; nullptr when VTK
/// is not loaded.
void* FindHidden(const char* symbol);

/// Whether the code at an address is part of libvtkOIT.
bool IsInVtkOIT(const void* address);
}

#endif
