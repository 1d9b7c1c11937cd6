// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITDualDepthPeelingPass.h"

#include "Private/Peeling/vtkOITDualPeelingEngine.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITDualDepthPeelingPass);

//------------------------------------------------------------------------------
vtkOITDualDepthPeelingPass::vtkOITDualDepthPeelingPass()
  : vtkOITPeelingPass(std::make_unique<vtkOITDualPeelingEngine>())
{
}

//------------------------------------------------------------------------------
vtkOITDualDepthPeelingPass::~vtkOITDualDepthPeelingPass() = default;

//------------------------------------------------------------------------------
void vtkOITDualDepthPeelingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
