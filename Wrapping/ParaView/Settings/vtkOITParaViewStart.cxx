// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITParaViewStart.h"

#include "vtkCollection.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkOITParaViewSettings.h"
#include "vtkProcessModule.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMPluginManager.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

namespace
{
/// After plugins were loaded, here or in a server, in a client.
class PluginsObserver : public vtkCommand
{
public:
  static PluginsObserver* New() { return new PluginsObserver; }

  void Execute(vtkObject*, unsigned long, void*) override
  {
    vtkSMSession* session = vtkSMProxyManager::GetProxyManager()->GetActiveSession();
    if (!session)
    {
      return;
    }
    // ParaView makes the proxies of settings only when a session begins.
    vtkNew<vtkSMParaViewPipelineController> controller;
    controller->UpdateSettingsProxies(session);
    vtkSMProxy* page = session->GetSessionProxyManager()->GetProxy("settings", "Translucency");
    if (page && !page->HasAnnotation("vtkOITReached"))
    {
      page->SetAnnotation("vtkOITReached", "1");
      this->ReachViewsOf(session, page);
    }
  }

private:
  /// A proxy property hands each process its own object of a view.
  static void ReachViewsOf(vtkSMSession* session, vtkSMProxy* page)
  {
    vtkNew<vtkCollection> objects;
    session->GetAllRemoteObjects(objects);
    vtkSMPropertyHelper views(page, "ViewsFromBefore");
    for (int i = 0; i < objects->GetNumberOfItems(); ++i)
    {
      if (auto* view = vtkSMViewProxy::SafeDownCast(objects->GetItemAsObject(i)))
      {
        views.Add(view);
      }
    }
    page->UpdateVTKObjects();
    views.RemoveAllValues(); // the page is not to own them
    page->UpdateVTKObjects();
  }
};
}

//------------------------------------------------------------------------------
void vtkOITParaViewStart()
{
  vtkOITParaViewSettings::GetInstance()->Start();

  const int type = vtkProcessModule::GetProcessType();
  if (type == vtkProcessModule::PROCESS_CLIENT || type == vtkProcessModule::PROCESS_BATCH)
  {
    const auto observer = vtkSmartPointer<PluginsObserver>::New();
    vtkSMProxyManager::GetProxyManager()->GetPluginManager()->AddObserver(
      vtkSMPluginManager::PluginLoadedEvent, observer);
  }
}
