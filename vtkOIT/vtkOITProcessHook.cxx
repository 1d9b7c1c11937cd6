// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITProcessHook.h"

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Hook/vtkOITEnvironment.h"
#include "Private/Hook/vtkOITHookRecord.h"
#include "Private/Hook/vtkOITReached.h"

#include "vtkCommand.h"
#include "vtkOITPass.h"
#include "vtkOITPassFactory.h"
#include "vtkOITRendererHook.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRenderWindow.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <cstring>
#include <vector>

namespace
{
/// Never destroyed: VTK's own objects may come to an end after ours.
struct State
{
  vtkSmartPointer<vtkObjectFactory> Factory;
  vtkSmartPointer<vtkCommand> WindowObserver;
  std::string Method; // empty when nothing is installed
  bool IsWatching = false;
  bool Respect = false;
  bool Log = false;
  vtkSmartPointer<vtkOITPass> Properties; // a pass that only carries them
  vtkOITReached<vtkRenderer> Renderers;
  vtkOITReached<vtkRenderWindow> Windows;
};
State& GetState()
{
  static auto* state = new State;
  return *state;
}

vtkOITPass* GetProperties()
{
  State& state = GetState();
  if (!state.Properties)
  {
    state.Properties.TakeReference(vtkOITPassFactory::CreatePass("auto"));
  }
  return state.Properties;
}

void CopyProperties(vtkOITPass* pass)
{
  pass->SetTransmittanceThreshold(GetProperties()->GetTransmittanceThreshold());
  pass->SetMaximumBufferSize(GetProperties()->GetMaximumBufferSize());
}

vtkSmartPointer<vtkOITPass> MakePass(const std::string& methodName)
{
  auto pass = vtkSmartPointer<vtkOITPass>::Take(vtkOITPassFactory::CreatePass(methodName));
  if (pass)
  {
    CopyProperties(pass);
  }
  return pass;
}

bool IsMethod(const std::string& name)
{
  return MakePass(name) != nullptr;
}

std::string ListMethods()
{
  std::string list;
  for (int i = 0; i < vtkOITPassFactory::GetNumberOfMethods(); ++i)
  {
    list += (i > 0 ? ", " : "") + vtkOITPassFactory::GetMethodName(i);
  }
  return list;
}
}

/// Before a frame of a window.
class vtkOITProcessHook::WindowObserver : public vtkCommand
{
public:
  static WindowObserver* New() { return new WindowObserver; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    vtkOITProcessHook::ReachRenderersOf(static_cast<vtkRenderWindow*>(caller));
  }
};

/// Lets the factories behind it create, and hooks what they made.
class vtkOITProcessHook::Factory : public vtkObjectFactory
{
public:
  static Factory* New();
  vtkTypeMacro(Factory, vtkObjectFactory);

  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override
  {
    return "vtkOIT: hooks into every renderer";
  }

  vtkObject* CreateObject(const char* className) override
  {
    const bool isRenderer = std::strcmp(className, "vtkRenderer") == 0;
    const bool isWindow = std::strcmp(className, "vtkRenderWindow") == 0;
    static thread_local bool isBehind = false;
    if (isBehind || (!isRenderer && !isWindow))
    {
      return nullptr;
    }
    isBehind = true;
    vtkObject* made = vtkObjectFactory::CreateInstance(className);
    isBehind = false;
    if (isRenderer)
    {
      vtkOITProcessHook::ReachRenderer(vtkRenderer::SafeDownCast(made), "when it was made");
    }
    else
    {
      vtkOITProcessHook::ReachWindow(vtkRenderWindow::SafeDownCast(made));
    }
    return made;
  }
};

vtkStandardNewMacro(vtkOITProcessHook::Factory);
vtkStandardNewMacro(vtkOITProcessHook);

//------------------------------------------------------------------------------
void vtkOITProcessHook::PutFactory()
{
  State& state = GetState();
  if (!state.Factory)
  {
    state.Factory = vtkSmartPointer<Factory>::New();
    state.WindowObserver = vtkSmartPointer<WindowObserver>::New();
  }
  // In front of all others: the first factory that creates wins, and RegisterFactory() appends.
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  if (factories->GetNumberOfItems() == 0)
  {
    factories->AddItem(state.Factory);
  }
  else if (!factories->IsItemPresent(state.Factory))
  {
    factories->InsertItem(-1, state.Factory);
  }
}

//------------------------------------------------------------------------------
void vtkOITProcessHook::SetWatch(bool watch)
{
  State& state = GetState();
  state.IsWatching = watch;
  if (watch)
  {
    PutFactory();
  }
  else if (state.Method.empty() && state.Factory)
  {
    vtkObjectFactory::GetRegisteredFactories()->RemoveItem(state.Factory);
  }
}

//------------------------------------------------------------------------------
bool vtkOITProcessHook::GetWatch()
{
  return GetState().IsWatching;
}

//------------------------------------------------------------------------------
bool vtkOITProcessHook::Install(const std::string& methodName)
{
  if (!IsMethod(methodName))
  {
    vtkGenericWarningMacro(
      "vtkOITProcessHook: there is no method " << methodName << "; give one of " << ListMethods());
    return false;
  }
  PutFactory();
  State& state = GetState();
  const bool isNew = state.Method.empty();
  const bool isChanged = state.Method != methodName;
  state.Method = methodName;
  for (const auto& window : state.Windows.GetAll())
  {
    ReachWindow(window);
  }
  for (const auto& renderer : state.Renderers.GetAll())
  {
    if (isChanged &&
      (vtkOITRendererHook::IsInstalledUnasked(renderer) ||
        !vtkOITRendererHook::GetInstalledPass(renderer)))
    {
      Reach(renderer, isNew ? "later" : "by another method");
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITProcessHook::Uninstall()
{
  State& state = GetState();
  if (state.Method.empty())
  {
    return false;
  }
  state.Method.clear();
  if (!state.IsWatching)
  {
    vtkObjectFactory::GetRegisteredFactories()->RemoveItem(state.Factory);
  }
  for (const auto& window : state.Windows.GetAll())
  {
    window->RemoveObserver(state.WindowObserver);
  }
  for (const auto& renderer : GetReached())
  {
    vtkOITRendererHook::Uninstall(renderer);
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkOITProcessHook::GetInstalledMethod()
{
  return GetState().Method;
}

//------------------------------------------------------------------------------
bool vtkOITProcessHook::InstallByEnvironment()
{
  if (!CheckEnvironment())
  {
    return false;
  }
  const vtkOITEnvironment environment = vtkOITEnvironment::Read();
  SetRespectDepthPeeling(environment.Respect);
  SetLog(environment.Log);
  return Install(environment.Method);
}

//------------------------------------------------------------------------------
bool vtkOITProcessHook::CheckEnvironment()
{
  const vtkOITEnvironment environment = vtkOITEnvironment::Read();
  std::string error = environment.Error;
  if (error.empty() && !IsMethod(environment.Method))
  {
    error = "VTKOIT_METHOD=" + environment.Method + " is not known; give one of " + ListMethods();
  }
  static std::string told;
  if (!error.empty() && error != told)
  {
    told = error;
    vtkOITHookRecord::Say(error + "; translucency is left to VTK");
  }
  return error.empty() && environment.On;
}

//------------------------------------------------------------------------------
void vtkOITProcessHook::ReachWindow(vtkRenderWindow* window)
{
  State& state = GetState();
  if (!window || (state.Method.empty() && !state.IsWatching))
  {
    return;
  }
  state.Windows.Add(window);
  if (!state.Method.empty() && !window->HasObserver(vtkCommand::StartEvent, state.WindowObserver))
  {
    window->AddObserver(vtkCommand::StartEvent, state.WindowObserver);
  }
}

//------------------------------------------------------------------------------
void vtkOITProcessHook::ReachRenderersOf(vtkRenderWindow* window)
{
  vtkRendererCollection* renderers = window->GetRenderers();
  vtkCollectionSimpleIterator it;
  renderers->InitTraversal(it);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(it))
  {
    ReachRenderer(renderer, "before a frame of its window");
  }
}

//------------------------------------------------------------------------------
void vtkOITProcessHook::ReachRenderer(vtkRenderer* renderer, const std::string& way)
{
  if (!vtkOpenGLRenderer::SafeDownCast(renderer))
  {
    return;
  }
  if (vtkOITRendererHook::GetInstalledPass(renderer))
  {
    vtkOITRendererHook::Observe(renderer);
    return;
  }
  GetState().Renderers.Add(renderer);
  if (!GetState().Method.empty())
  {
    Reach(renderer, way);
  }
}

//------------------------------------------------------------------------------
void vtkOITProcessHook::Reach(vtkRenderer* renderer, const std::string& way)
{
  const State& state = GetState();
  vtkOITRendererHook::InstallUnasked(renderer, MakePass(state.Method),
    vtkOITHookRecord::Create(way, state.Method, state.Respect, state.Log));
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkRenderer>> vtkOITProcessHook::GetReached()
{
  std::vector<vtkSmartPointer<vtkRenderer>> reached;
  for (const auto& renderer : GetState().Renderers.GetAll())
  {
    if (vtkOITRendererHook::IsInstalledUnasked(renderer))
    {
      reached.push_back(renderer);
    }
  }
  return reached;
}

//------------------------------------------------------------------------------
bool vtkOITProcessHook::SetTransmittanceThreshold(double threshold)
{
  GetProperties()->SetTransmittanceThreshold(threshold);
  for (const auto& renderer : GetReached())
  {
    CopyProperties(vtkOITRendererHook::GetInstalledPass(renderer));
  }
  return GetTransmittanceThreshold() == threshold;
}

//------------------------------------------------------------------------------
double vtkOITProcessHook::GetTransmittanceThreshold()
{
  return GetProperties()->GetTransmittanceThreshold();
}

//------------------------------------------------------------------------------
bool vtkOITProcessHook::SetMaximumBufferSize(vtkTypeInt64 bytes)
{
  GetProperties()->SetMaximumBufferSize(bytes);
  for (const auto& renderer : GetReached())
  {
    CopyProperties(vtkOITRendererHook::GetInstalledPass(renderer));
  }
  return GetMaximumBufferSize() == bytes;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkOITProcessHook::GetMaximumBufferSize()
{
  return GetProperties()->GetMaximumBufferSize();
}

//------------------------------------------------------------------------------
void vtkOITProcessHook::SetRespectDepthPeeling(bool respect)
{
  GetState().Respect = respect;
}

//------------------------------------------------------------------------------
bool vtkOITProcessHook::GetRespectDepthPeeling()
{
  return GetState().Respect;
}

//------------------------------------------------------------------------------
void vtkOITProcessHook::SetLog(bool log)
{
  GetState().Log = log;
}

//------------------------------------------------------------------------------
bool vtkOITProcessHook::GetLog()
{
  return GetState().Log;
}
