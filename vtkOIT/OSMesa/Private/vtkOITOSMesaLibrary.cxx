// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/vtkOITOSMesaLibrary.h"

#include <dlfcn.h>

#include <type_traits>

namespace
{
const char* const LibraryName = "libOSMesa.so.8";
}

//------------------------------------------------------------------------------
vtkOITOSMesaLibrary::vtkOITOSMesaLibrary()
{
  void* library = dlopen(LibraryName, RTLD_NOW | RTLD_LOCAL);
  if (!library)
  {
    const char* reason = dlerror();
    this->Error = std::string(LibraryName) + " cannot be opened (" +
      (reason ? reason : "no reason given") + "); install OSMesa (Debian and Ubuntu: libosmesa6)";
    return;
  }

  const char* missing = nullptr;
  const auto find = [&](auto& function, const char* name)
  {
    void* address = dlsym(library, name);
    if (!address && !missing)
    {
      missing = name;
    }
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(address);
  };
  find(this->CreateContextAttribs, "OSMesaCreateContextAttribs");
  find(this->DestroyContext, "OSMesaDestroyContext");
  find(this->MakeCurrent, "OSMesaMakeCurrent");
  find(this->GetCurrentContext, "OSMesaGetCurrentContext");
  find(this->GetColorBuffer, "OSMesaGetColorBuffer");
  find(this->GetProcAddress, "OSMesaGetProcAddress");
  if (missing)
  {
    this->Error = std::string(LibraryName) + " has no function " + missing +
      "; install OSMesa of Mesa 11.2 or later (Debian and Ubuntu: libosmesa6)";
  }
}

//------------------------------------------------------------------------------
const vtkOITOSMesaLibrary& vtkOITOSMesaLibrary::Get()
{
  // Never destroyed: a window may end after this library's static objects.
  static const vtkOITOSMesaLibrary* instance = new vtkOITOSMesaLibrary;
  return *instance;
}
