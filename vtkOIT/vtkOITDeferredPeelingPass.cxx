// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITDeferredPeelingPass.h"

#include "Private/ABuffer/vtkOITABufferEngine.h"
#include "Private/Frame/vtkOITSettings.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITDeferredPeelingPass);

//------------------------------------------------------------------------------
vtkOITDeferredPeelingPass::vtkOITDeferredPeelingPass()
  : vtkOITPass(std::make_unique<vtkOITABufferEngine>())
{
}

//------------------------------------------------------------------------------
vtkOITDeferredPeelingPass::~vtkOITDeferredPeelingPass() = default;

//------------------------------------------------------------------------------
vtkOITSettings vtkOITDeferredPeelingPass::MakeSettings(const vtkOITCapabilities& capabilities) const
{
  vtkOITSettings settings = this->Superclass::MakeSettings(capabilities);
  settings.DeferShading = vtkOITSettings::Deferral::Always;
  return settings;
}
