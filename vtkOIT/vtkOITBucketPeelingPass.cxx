// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITBucketPeelingPass.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/Peeling/vtkOITBucketPeeler.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITBucketPeelingPass);

//------------------------------------------------------------------------------
vtkOITBucketPeelingPass::vtkOITBucketPeelingPass()
  : vtkOITPeelingPass(std::make_unique<vtkOITBucketPeeler>())
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
void vtkOITBucketPeelingPass::RenderTranslucent(vtkOITFrame& frame)
{
  auto& peeler = static_cast<vtkOITBucketPeeler&>(this->GetPeeler());
  peeler.SetDivision(this->Mode == PAIRS ? vtkOITBucketPeeler::Division::Pairs
      : this->Mode == ADAPTIVE           ? vtkOITBucketPeeler::Division::Adaptive
                                         : vtkOITBucketPeeler::Division::Uniform);
  peeler.SetHasExactRange(this->DepthRange == EXACT);
  peeler.SetIsSingleShot(this->MaximumNumberOfPeels == 1);
  this->Superclass::RenderTranslucent(frame);
}
