// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITContextObjects.h"

#include "Private/GL/vtkOITAllocation.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
vtkOITContextObjects::vtkOITContextObjects() = default;

//------------------------------------------------------------------------------
vtkOITContextObjects::~vtkOITContextObjects() = default;

//------------------------------------------------------------------------------
bool vtkOITContextObjects::Attach(vtkOpenGLRenderWindow* window)
{
  if (this->Marker && this->Marker->GetHandle() != 0 && this->Marker->GetContext() == window)
  {
    return true;
  }
  this->Release();
  this->Marker = vtkSmartPointer<vtkTextureObject>::New();
  this->Marker->SetContext(window);
  const vtkOITAllocation allocation;
  this->Marker->Allocate2D(1, 1, 1, VTK_UNSIGNED_CHAR);
  return false;
}

//------------------------------------------------------------------------------
void vtkOITContextObjects::Release()
{
  if (!this->Marker)
  {
    return;
  }
  vtkOpenGLRenderWindow* window = this->Marker->GetContext();
  if (this->Marker->GetHandle() != 0 && window)
  {
    window->PushContext();
    this->Delete();
    this->Marker->ReleaseGraphicsResources(window);
    window->PopContext();
  }
  this->Forget();
  this->Marker = nullptr;
}

//------------------------------------------------------------------------------
vtkOpenGLRenderWindow* vtkOITContextObjects::GetWindow() const
{
  return this->Marker && this->Marker->GetHandle() != 0 ? this->Marker->GetContext() : nullptr;
}
