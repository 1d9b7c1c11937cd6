// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITRunningVTK.h"

#include "vtkVersionMacros.h" // what we were built for

#include <dlfcn.h>
#include <link.h>

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace
{
std::string GetFileName(const std::string& path)
{
  return path.substr(path.rfind('/') + 1);
}

/// The paths of all loaded libraries whose file names start so.
std::vector<std::string> FindLoaded(const char* start)
{
  struct Search
  {
    std::string Start;
    std::vector<std::string> Found;
  } search{ start, {} };
  dl_iterate_phdr(
    [](dl_phdr_info* info, size_t, void* data)
    {
      auto* wanted = static_cast<Search*>(data);
      if (GetFileName(info->dlpi_name).compare(0, wanted->Start.size(), wanted->Start) == 0)
      {
        wanted->Found.emplace_back(info->dlpi_name);
      }
      return 0;
    },
    &search);
  return search.Found;
}

void* OpenLoaded(const std::string& path)
{
  return dlopen(path.c_str(), RTLD_LAZY | RTLD_NOLOAD);
}

/// Empty, or why libvtkOIT cannot be loaded here.
std::string FindObstacle()
{
  const std::string builtFor = VTKOIT_VTK_LIBRARY;
  const std::vector<std::string> loaded = FindLoaded("libvtkCommonCore");
  if (loaded.empty())
  {
    return "this program has its VTK built in, and vtkOIT was built for " + builtFor;
  }
  if (loaded.size() > 1)
  {
    return "this program has loaded two VTKs, " + loaded[0] + " and " + loaded[1];
  }
  if (GetFileName(loaded[0]) != builtFor)
  {
    return "this program has " + GetFileName(loaded[0]) + ", and vtkOIT was built for " + builtFor;
  }
  void* library = OpenLoaded(loaded[0]);
  using Function = const char* (*)();
  const auto getVersion =
    reinterpret_cast<Function>(library ? dlsym(library, "GetVTKVersion") : nullptr);
  const std::string version = getVersion ? getVersion() : "of unknown version";
  return version == VTK_VERSION
    ? std::string()
    : "this program has VTK " + version + ", and vtkOIT was built for VTK " VTK_VERSION;
}

void* OpenVtkOIT()
{
  const char* failure = nullptr;
  std::string obstacle = FindObstacle();
  void* library = nullptr;
  if (obstacle.empty())
  {
    // By the RUNPATH of this library. It stays for good: objects of the application refer to it.
    library = dlopen(VTKOIT_LIBRARY, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    failure = library ? nullptr : dlerror();
    obstacle = failure ? failure : "";
  }
  if (!library)
  {
    const std::string line = "vtkoit: " + obstacle + "; translucency is left to VTK\n";
    std::fputs(line.c_str(), stderr);
  }
  return library;
}
}

//------------------------------------------------------------------------------
void* vtkOITRunningVTK::FindFunction(const char* name)
{
  static void* library = OpenVtkOIT();
  return library ? dlsym(library, name) : nullptr;
}

//------------------------------------------------------------------------------
void* vtkOITRunningVTK::FindHidden(const char* symbol)
{
  for (const std::string& path : FindLoaded("libvtkRenderingOpenGL2"))
  {
    void* library = OpenLoaded(path);
    if (void* found = library ? dlsym(library, symbol) : nullptr)
    {
      return found;
    }
  }
  return dlsym(RTLD_NEXT, symbol);
}

//------------------------------------------------------------------------------
bool vtkOITRunningVTK::IsInVtkOIT(const void* address)
{
  Dl_info info;
  return dladdr(address, &info) && GetFileName(info.dli_fname) == VTKOIT_LIBRARY;
}
