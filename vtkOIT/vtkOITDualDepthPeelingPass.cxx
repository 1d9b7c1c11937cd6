// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITDualDepthPeelingPass.h"

#include "Private/vtkOITDualLayerPeeler.h"
#include "Private/vtkOITFrame.h"
#include "Private/vtkOITMinMaxPeeler.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITDualDepthPeelingPass);

//------------------------------------------------------------------------------
vtkOITDualDepthPeelingPass::vtkOITDualDepthPeelingPass()
  : vtkOITPeelingPass(std::make_unique<vtkOITMinMaxPeeler>(true))
{
}

//------------------------------------------------------------------------------
vtkOITDualDepthPeelingPass::~vtkOITDualDepthPeelingPass() = default;

//------------------------------------------------------------------------------
void vtkOITDualDepthPeelingPass::RenderTranslucent(vtkOITFrame& frame)
{
  const bool keepsLayers = vtkOITPeelState::CanWorkInPlace(frame);
  if (keepsLayers != this->KeepsLayers)
  {
    this->KeepsLayers = keepsLayers;
    if (keepsLayers)
    {
      this->SetPeeler(std::make_unique<vtkOITDualLayerPeeler>());
    }
    else
    {
      this->SetPeeler(std::make_unique<vtkOITMinMaxPeeler>(true));
    }
  }
  if (keepsLayers)
  {
    auto& peeler = static_cast<vtkOITDualLayerPeeler&>(this->GetPeeler());
    peeler.SetLayersPerSide(getenv("OITK") ? atoi(getenv("OITK")) : 2);
  }
  this->Superclass::RenderTranslucent(frame);
}

//------------------------------------------------------------------------------
void vtkOITDualDepthPeelingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
