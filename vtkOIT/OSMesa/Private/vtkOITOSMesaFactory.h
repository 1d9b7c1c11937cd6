// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Makes vtkRenderWindow::New() give a vtkOITOSMesaRenderWindow, and
 * vtkRenderWindowInteractor::New() one that needs no X server.
 */

#ifndef vtkOITOSMesaFactory_h
#define vtkOITOSMesaFactory_h

#include "vtkObjectFactory.h"

class vtkOITOSMesaFactory : public vtkObjectFactory
{
public:
  static vtkOITOSMesaFactory* New();
  vtkTypeMacro(vtkOITOSMesaFactory, vtkObjectFactory);

  /// Registers the factory, in front of those that VTK has now. Once is enough.
  static void Register();

  const char* GetVTKSourceVersion() override;
  const char* GetDescription() override;

protected:
  vtkOITOSMesaFactory();
  ~vtkOITOSMesaFactory() override = default;

private:
  vtkOITOSMesaFactory(const vtkOITOSMesaFactory&) = delete;
  void operator=(const vtkOITOSMesaFactory&) = delete;
};

#endif
