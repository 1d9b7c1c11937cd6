// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Volume/vtkOITVolumeGather.h"

#include "Private/Volume/vtkOITVolumeHook.h"
#include "Private/Volume/vtkOITVolumeText.h"

#include <utility>

//------------------------------------------------------------------------------
vtkOITVolumeGather::vtkOITVolumeGather()
  : Hook(vtkSmartPointer<vtkOITVolumeHook>::New())
{
  this->Hook->Gather = this;
}

//------------------------------------------------------------------------------
// A mapper may hold the hook longer than the gather lives.
vtkOITVolumeGather::~vtkOITVolumeGather()
{
  this->Hook->Gather = nullptr;
}

//------------------------------------------------------------------------------
void vtkOITVolumeGather::SetStage(Completer complete)
{
  this->Complete = std::move(complete);
  std::string stage = this->Complete(vtkOITGetMarchText());
  if (stage != this->Stage)
  {
    this->Stage = std::move(stage);
    this->Hook->Modified();
  }
}

//------------------------------------------------------------------------------
vtkOITVolumeHook* vtkOITVolumeGather::GetHook() const
{
  return this->Hook;
}
