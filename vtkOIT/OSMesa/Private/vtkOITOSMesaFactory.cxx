// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/vtkOITOSMesaFactory.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkOITOSMesaRenderWindow.h"
#include "vtkVersion.h"

vtkStandardNewMacro(vtkOITOSMesaFactory);

namespace
{
template <typename ClassType>
vtkObject* CreateAs()
{
  return ClassType::New();
}
}

//------------------------------------------------------------------------------
vtkOITOSMesaFactory::vtkOITOSMesaFactory()
{
  this->RegisterOverride("vtkRenderWindow", "vtkOITOSMesaRenderWindow", "render window of OSMesa",
    1, CreateAs<vtkOITOSMesaRenderWindow>);
  // VTK's interactor for X talks to the X server of its window, which ours does not have.
  this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
    "interactor without a window system", 1, CreateAs<vtkGenericRenderWindowInteractor>);
}

//------------------------------------------------------------------------------
void vtkOITOSMesaFactory::Register()
{
  // The first enabled factory wins and ours comes last, so the others must stand back. The call
  // makes VTK's list, which the next ones take for granted.
  vtkObjectFactory::GetRegisteredFactories();
  for (const char* name : { "vtkRenderWindow", "vtkRenderWindowInteractor" })
  {
    vtkObjectFactory::SetAllEnableFlags(0, name);
  }
  vtkNew<vtkOITOSMesaFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);
}

//------------------------------------------------------------------------------
const char* vtkOITOSMesaFactory::GetVTKSourceVersion()
{
  return VTK_SOURCE_VERSION;
}

//------------------------------------------------------------------------------
const char* vtkOITOSMesaFactory::GetDescription()
{
  return "vtkOIT: rendering without a display through OSMesa";
}
