// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITWeightedPass.h"

#include "Private/Frame/vtkOITSettings.h"
#include "Private/Weighted/vtkOITWeightedEngine.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITWeightedPass);

//------------------------------------------------------------------------------
vtkOITWeightedPass::vtkOITWeightedPass()
  : vtkOITPass(std::make_unique<vtkOITWeightedEngine>())
{
}

//------------------------------------------------------------------------------
vtkOITWeightedPass::~vtkOITWeightedPass() = default;

//------------------------------------------------------------------------------
void vtkOITWeightedPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->GetOwnAlgorithmName() << "\n";
}

//------------------------------------------------------------------------------
void vtkOITWeightedPass::SetMode(int mode)
{
  if (this->IsNamedValue("Mode", mode, BLENDED, "AVERAGE, SUM or BLENDED") && this->Mode != mode)
  {
    this->Mode = mode;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkOITSettings vtkOITWeightedPass::MakeSettings(const vtkOITCapabilities& capabilities) const
{
  vtkOITSettings settings = this->Superclass::MakeSettings(capabilities);
  settings.WeightedMode = this->Mode;
  return settings;
}
