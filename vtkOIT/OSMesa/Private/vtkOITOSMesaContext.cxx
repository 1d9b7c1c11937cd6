// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/vtkOITOSMesaContext.h"

#include <unistd.h>

#include <atomic>
#include <mutex>
#include <set>

namespace
{
// From osmesa.h and gl.h, which this module does not need installed.
constexpr int RGBA = 0x1908; // OSMESA_RGBA is GL_RGBA
constexpr unsigned int UnsignedByte = 0x1401;
constexpr int Format = 0x22;
constexpr int DepthBits = 0x30;
constexpr int StencilBits = 0x31;
constexpr int AccumulationBits = 0x32;
constexpr int Profile = 0x33;
constexpr int CoreProfile = 0x34;
constexpr int ContextMajorVersion = 0x36;
constexpr int ContextMinorVersion = 0x37;

// OSMesa refuses a version that it does not have, so they are tried from the top down to what VTK
// needs at least.
constexpr int Versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 4 }, { 4, 3 }, { 4, 2 }, { 4, 1 },
  { 4, 0 }, { 3, 3 }, { 3, 2 } };

// The process in which the first context was made, and Mesa's threads started; 0 before.
std::atomic<pid_t> Owner{ 0 };

// The contexts that exist, of all threads.
struct Registry
{
  std::mutex Mutex;
  std::set<vtkOITOSMesaLibrary::Handle> Contexts;

  static Registry& Get()
  {
    static Registry* instance = new Registry; // never destroyed: a window may end later
    return *instance;
  }

  bool Has(vtkOITOSMesaLibrary::Handle handle)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Contexts.count(handle) != 0;
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkOITOSMesaContext> vtkOITOSMesaContext::Create(
  const vtkOITOSMesaContext* share, std::string& error)
{
  const vtkOITOSMesaLibrary& library = vtkOITOSMesaLibrary::Get();
  error = library.Error.empty() ? FindLossByFork() : library.Error;
  if (!error.empty())
  {
    return nullptr;
  }

  pid_t none = 0;
  Owner.compare_exchange_strong(none, getpid());
  for (const auto& version : Versions)
  {
    const int attributes[] = { Format, RGBA, DepthBits, 24, StencilBits, 8, AccumulationBits, 0,
      Profile, CoreProfile, ContextMajorVersion, version[0], ContextMinorVersion, version[1], 0 };
    if (vtkOITOSMesaLibrary::Handle handle =
          library.CreateContextAttribs(attributes, share ? share->Handle : nullptr))
    {
      return std::unique_ptr<vtkOITOSMesaContext>(new vtkOITOSMesaContext(handle));
    }
  }
  error = "OSMesa gives no OpenGL 3.2 core context; its driver needs Mesa 11.2 or later "
          "with llvmpipe, and memory";
  return nullptr;
}

//------------------------------------------------------------------------------
std::string vtkOITOSMesaContext::FindLossByFork()
{
  const pid_t owner = Owner;
  if (owner == 0 || owner == getpid())
  {
    return {};
  }
  return "this process was forked from one that had drawn with OSMesa, whose threads do not come "
         "along; draw first after the fork, or start the process anew "
         "(Python: multiprocessing.set_start_method('spawn'))";
}

//------------------------------------------------------------------------------
vtkOITOSMesaContext::vtkOITOSMesaContext(vtkOITOSMesaLibrary::Handle handle)
  : Handle(handle)
{
  Registry& registry = Registry::Get();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  registry.Contexts.insert(handle);
}

//------------------------------------------------------------------------------
vtkOITOSMesaContext::~vtkOITOSMesaContext()
{
  if (!FindLossByFork().empty())
  {
    return; // Mesa would wait for its threads
  }
  const vtkOITOSMesaLibrary& library = vtkOITOSMesaLibrary::Get();
  if (this->IsCurrent())
  {
    library.MakeCurrent(nullptr, nullptr, UnsignedByte, 0, 0);
  }
  Registry& registry = Registry::Get();
  {
    const std::lock_guard<std::mutex> lock(registry.Mutex);
    registry.Contexts.erase(this->Handle);
  }
  library.DestroyContext(this->Handle);
}

//------------------------------------------------------------------------------
bool vtkOITOSMesaContext::MakeCurrent()
{
  return this->IsCurrent() ||
    vtkOITOSMesaLibrary::Get().MakeCurrent(this->Handle, this->Pixel.data(), UnsignedByte, 1, 1);
}

//------------------------------------------------------------------------------
bool vtkOITOSMesaContext::IsCurrent() const
{
  return vtkOITOSMesaLibrary::Get().GetCurrentContext() == this->Handle;
}

//------------------------------------------------------------------------------
vtkOITOSMesaContext::Binding vtkOITOSMesaContext::GetBinding()
{
  Binding binding;
  const vtkOITOSMesaLibrary& library = vtkOITOSMesaLibrary::Get();
  if (!library.Error.empty())
  {
    return binding;
  }
  binding.Handle = library.GetCurrentContext();
  if (binding.Handle)
  {
    int format;
    library.GetColorBuffer(
      binding.Handle, &binding.Width, &binding.Height, &format, &binding.Buffer);
    binding.Ours = Registry::Get().Has(binding.Handle);
  }
  return binding;
}

//------------------------------------------------------------------------------
void vtkOITOSMesaContext::Restore(const Binding& binding)
{
  if (!binding.Handle || (binding.Ours && !Registry::Get().Has(binding.Handle)))
  {
    return;
  }
  const vtkOITOSMesaLibrary& library = vtkOITOSMesaLibrary::Get();
  if (library.GetCurrentContext() != binding.Handle)
  {
    library.MakeCurrent(
      binding.Handle, binding.Buffer, UnsignedByte, binding.Width, binding.Height);
  }
}
