// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITBucketPeelingPass.h"

#include "Private/Frame/vtkOITSettings.h"
#include "Private/Peeling/vtkOITBucketPeelingEngine.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITBucketPeelingPass);

//------------------------------------------------------------------------------
vtkOITBucketPeelingPass::vtkOITBucketPeelingPass()
  : vtkOITPeelingPass(std::make_unique<vtkOITBucketPeelingEngine>())
{
}

//------------------------------------------------------------------------------
vtkOITBucketPeelingPass::~vtkOITBucketPeelingPass() = default;

//------------------------------------------------------------------------------
void vtkOITBucketPeelingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n"
     << indent << "DepthRange: " << this->DepthRange << "\n";
}

//------------------------------------------------------------------------------
void vtkOITBucketPeelingPass::SetMode(int mode)
{
  if (this->IsNamedValue("Mode", mode, ADAPTIVE, "UNIFORM, PAIRS or ADAPTIVE") &&
    this->Mode != mode)
  {
    this->Mode = mode;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITBucketPeelingPass::SetDepthRange(int range)
{
  if (this->IsNamedValue("DepthRange", range, EXACT, "BOUNDS or EXACT") &&
    this->DepthRange != range)
  {
    this->DepthRange = range;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkOITSettings vtkOITBucketPeelingPass::MakeSettings(const vtkOITCapabilities& capabilities) const
{
  vtkOITSettings settings = this->Superclass::MakeSettings(capabilities);
  settings.BucketMode = this->Mode;
  settings.HasExactDepthRange = this->DepthRange == EXACT;
  return settings;
}
