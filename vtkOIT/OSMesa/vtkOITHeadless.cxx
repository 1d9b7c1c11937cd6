// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITHeadless.h"

#include "vtkObjectFactory.h"
#include "vtkVersionMacros.h"

#ifdef VTKOIT_HAS_OSMESA_WINDOW
#include "Private/vtkOITForkedTrial.h"
#include "Private/vtkOITOSMesaContext.h"
#include "Private/vtkOITOSMesaFactory.h"
#include "Private/vtkOITOSMesaRedirection.h"
#elif VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0) && defined(__unix__)
#define VTKOIT_HAS_RUN_TIME_WINDOWS
#include "Private/vtkOITForkedTrial.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <dlfcn.h>

#include <cstdlib>
#endif

vtkStandardNewMacro(vtkOITHeadless);

namespace
{
std::string BackendName;

#if defined(VTKOIT_HAS_OSMESA_WINDOW)
//------------------------------------------------------------------------------
// Each of these returns the backend's name, or an empty string and an error.
std::string SetUp(std::string& error)
{
  // One context is made and dropped, elsewhere: better to fail here than at the first frame.
  error = vtkOITTryInChild(
    []()
    {
      std::string reason;
      vtkOITOSMesaContext::Create(nullptr, reason);
      return reason;
    });
  if (error.empty())
  {
    error = vtkOITOSMesaRedirection::Update();
  }
  if (!error.empty())
  {
    return {};
  }
  vtkOITOSMesaFactory::Register();
  return "OSMesa";
}

#elif defined(VTKOIT_HAS_RUN_TIME_WINDOWS)
const char* const WindowVariable = "VTK_DEFAULT_OPENGL_WINDOW";
const char* const EGLWindow = "vtkEGLRenderWindow";

//------------------------------------------------------------------------------
bool CanOpen(const char* library, std::string& error)
{
  if (void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL))
  {
    dlclose(handle);
    return true;
  }
  const char* reason = dlerror();
  error += std::string(error.empty() ? "" : ", ") + (reason ? reason : library);
  return false;
}

//------------------------------------------------------------------------------
bool WindowWorks(const char* className)
{
  setenv(WindowVariable, className, 1);
  return vtkOITTryInChild(
    [className]() -> std::string
    {
      auto window = vtkSmartPointer<vtkRenderWindow>::New();
      window->SetOffScreenRendering(1);
      return window->IsA(className) && window->SupportsOpenGL() ? "" : "it does not";
    })
    .empty();
}

//------------------------------------------------------------------------------
std::string SetUp(std::string& error)
{
  const char* before = std::getenv(WindowVariable);
  const std::string saved = before ? before : "";

  std::string reason;
  if (saved != EGLWindow && CanOpen("libOSMesa.so.8", reason))
  {
    if (WindowWorks("vtkOSOpenGLRenderWindow"))
    {
      return "OSMesa";
    }
    reason = "VTK's window of OSMesa gives no OpenGL 3.2";
  }
  if (CanOpen("libEGL.so.1", reason))
  {
    if (WindowWorks(EGLWindow))
    {
      return "EGL";
    }
    reason += std::string(reason.empty() ? "" : ", ") + "VTK's window of EGL gives no OpenGL 3.2";
  }
  if (before)
  {
    setenv(WindowVariable, saved.c_str(), 1);
  }
  else
  {
    unsetenv(WindowVariable);
  }
  error = saved == EGLWindow ? "EGL, the only window asked for, does not render here ("
                             : "neither OSMesa nor EGL renders here (";
  error += reason + "); install Mesa's EGL (Debian and Ubuntu: libegl1 libgl1-mesa-dri)";
  return {};
}

#else
//------------------------------------------------------------------------------
std::string SetUp(std::string& error)
{
  error = "this operating system has no rendering without a display here; it needs Linux";
  return {};
}
#endif
}

//------------------------------------------------------------------------------
bool vtkOITHeadless::Initialize()
{
  if (BackendName.empty())
  {
    std::string error;
    BackendName = SetUp(error);
    if (BackendName.empty())
    {
      vtkErrorWithObjectMacro(nullptr, "vtkOITHeadless: " << error << ".");
    }
  }
  return !BackendName.empty();
}

//------------------------------------------------------------------------------
std::string vtkOITHeadless::GetBackendName()
{
  return BackendName;
}

//------------------------------------------------------------------------------
void vtkOITHeadless::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BackendName: " << BackendName << "\n";
}
