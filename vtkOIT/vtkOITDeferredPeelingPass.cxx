// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITDeferredPeelingPass.h"

#include "Private/Frame/vtkOITSettings.h"
#include "Private/Plan/vtkOITDeferredEngine.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITDeferredPeelingPass);

//------------------------------------------------------------------------------
vtkOITDeferredPeelingPass::vtkOITDeferredPeelingPass()
  : vtkOITPeelingPass(std::make_unique<vtkOITDeferredEngine>())
  , Engine(static_cast<vtkOITDeferredEngine*>(this->GetEngine()))
{
}

//------------------------------------------------------------------------------
vtkOITDeferredPeelingPass::~vtkOITDeferredPeelingPass() = default;

//------------------------------------------------------------------------------
void vtkOITDeferredPeelingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
}

//------------------------------------------------------------------------------
void vtkOITDeferredPeelingPass::SetMode(int mode)
{
  if (this->IsNamedValue("Mode", mode, A_BUFFER, "PEELING or A_BUFFER") && this->Mode != mode)
  {
    this->Mode = mode;
    this->Engine->SetPeels(mode == PEELING);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkOITSettings vtkOITDeferredPeelingPass::MakeSettings(const vtkOITCapabilities& capabilities) const
{
  vtkOITSettings settings = this->Superclass::MakeSettings(capabilities);
  settings.DeferShading = vtkOITSettings::Deferral::Always;
  return settings;
}
