// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause

// The library for LD_PRELOAD. It replaces New() of VTK's translucent passes, for applications that
// make their chain of passes where nobody else gets at it. What vtkOIT itself makes, and what is to
// be VTK's, is made by VTK.
//
// It is loaded into every program that the application starts, so it is linked to nothing. VTK's own
// headers of these classes bring objects along that need its libraries (vtkSetGet.h of VTK 9.6 does).

#include "vtkOITRunningVTK.h"

#if __has_include("vtkABINamespace.h") // VTK 9.2 and later
#include "vtkABINamespace.h"
#else
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#include <dlfcn.h>

#include <cstdlib>

VTK_ABI_NAMESPACE_BEGIN
class __attribute__((visibility("default"))) vtkDepthPeelingPass
{
public:
  static vtkDepthPeelingPass* New();
};
class __attribute__((visibility("default"))) vtkDualDepthPeelingPass
{
public:
  static vtkDualDepthPeelingPass* New();
};
class __attribute__((visibility("default"))) vtkOrderIndependentTranslucentPass
{
public:
  static vtkOrderIndependentTranslucentPass* New();
};
class __attribute__((visibility("default"))) vtkTranslucentPass
{
public:
  static vtkTranslucentPass* New();
};
VTK_ABI_NAMESPACE_END

namespace
{
/// `own`: the function that replaces VTK's; its symbol is the one to look for.
template <typename PassType>
PassType* Make(const char* className, PassType* (*own)(), const void* caller)
{
  using Function = void* (*)(const char*);
  if (!vtkOITRunningVTK::IsInVtkOIT(caller))
  {
    if (const auto make =
          reinterpret_cast<Function>(vtkOITRunningVTK::FindFunction("vtkOITNewTranslucentPass")))
    {
      if (void* made = make(className))
      {
        return static_cast<PassType*>(made);
      }
    }
  }
  Dl_info info;
  using NewFunction = PassType* (*)();
  const auto make = dladdr(reinterpret_cast<void*>(own), &info) && info.dli_sname
    ? reinterpret_cast<NewFunction>(vtkOITRunningVTK::FindHidden(info.dli_sname))
    : nullptr;
  return make ? make() : nullptr;
}
}

vtkDualDepthPeelingPass* vtkDualDepthPeelingPass::New()
{
  return Make<vtkDualDepthPeelingPass>(
    "vtkDualDepthPeelingPass", &vtkDualDepthPeelingPass::New, __builtin_return_address(0));
}

vtkDepthPeelingPass* vtkDepthPeelingPass::New()
{
  return Make<vtkDepthPeelingPass>(
    "vtkDepthPeelingPass", &vtkDepthPeelingPass::New, __builtin_return_address(0));
}

vtkOrderIndependentTranslucentPass* vtkOrderIndependentTranslucentPass::New()
{
  return Make<vtkOrderIndependentTranslucentPass>("vtkOrderIndependentTranslucentPass",
    &vtkOrderIndependentTranslucentPass::New, __builtin_return_address(0));
}

vtkTranslucentPass* vtkTranslucentPass::New()
{
  return Make<vtkTranslucentPass>(
    "vtkTranslucentPass", &vtkTranslucentPass::New, __builtin_return_address(0));
}
