// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITDepthPeelingPass.h"

#include "Private/Peeling/vtkOITMinMaxPeeler.h"
#include "Private/Peeling/vtkOITPeelingEngine.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITDepthPeelingPass);

//------------------------------------------------------------------------------
vtkOITDepthPeelingPass::vtkOITDepthPeelingPass()
  : vtkOITPeelingPass(std::make_unique<vtkOITPeelingEngine>(
      "depth peeling", std::make_unique<vtkOITMinMaxPeeler>(false)))
{
}

//------------------------------------------------------------------------------
vtkOITDepthPeelingPass::~vtkOITDepthPeelingPass() = default;

//------------------------------------------------------------------------------
void vtkOITDepthPeelingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
