// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * libOSMesa, opened at run time.
 *
 * Neither its library nor its header is needed to build. It is opened for this library alone
 * (RTLD_LOCAL), so other users of OpenGL in the process keep the OpenGL that they have, and it is
 * never closed: VTK keeps addresses of its functions until the process ends.
 */

#ifndef vtkOITOSMesaLibrary_h
#define vtkOITOSMesaLibrary_h

#include <string>

struct vtkOITOSMesaLibrary
{
  using Function = void (*)();
  /// OSMesaContext of osmesa.h.
  using Handle = struct osmesa_context*;

  Handle (*CreateContextAttribs)(const int* attributes, Handle share) = nullptr;
  void (*DestroyContext)(Handle context) = nullptr;
  unsigned char (*MakeCurrent)(
    Handle context, void* buffer, unsigned int type, int width, int height) = nullptr;
  Handle (*GetCurrentContext)() = nullptr;
  unsigned char (*GetColorBuffer)(
    Handle context, int* width, int* height, int* format, void** buffer) = nullptr;
  Function (*GetProcAddress)(const char* name) = nullptr;

  /// Why the library cannot be used, one line; empty when it can.
  std::string Error;

  /// The one instance; the first call opens libOSMesa.
  static const vtkOITOSMesaLibrary& Get();

private:
  vtkOITOSMesaLibrary();
};

#endif
