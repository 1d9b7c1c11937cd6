// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// Stands in for libvtkCommonCore of another VTK, which vtkOIT was not built for.

extern "C" [[gnu::visibility("default")]] const char* GetVTKVersion()
{
  return "0.0.1";
}
