// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITPeelingPass.h"

#include "Private/Engine/vtkOITEngine.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"

#include <utility>

//------------------------------------------------------------------------------
vtkOITPeelingPass::vtkOITPeelingPass(std::unique_ptr<vtkOITEngine> engine)
  : vtkOITPass(std::move(engine))
{
}

//------------------------------------------------------------------------------
vtkOITPeelingPass::~vtkOITPeelingPass() = default;

//------------------------------------------------------------------------------
void vtkOITPeelingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseOcclusionQuery: " << this->UseOcclusionQuery << "\n"
     << indent << "NumberOfPeels: " << this->GetNumberOfPeels() << "\n"
     << indent << "NumberOfLostFragments: " << this->GetNumberOfLostFragments() << "\n";
}

//------------------------------------------------------------------------------
vtkOITSettings vtkOITPeelingPass::MakeSettings(const vtkOITCapabilities& capabilities) const
{
  vtkOITSettings settings = this->Superclass::MakeSettings(capabilities);
  settings.UseOcclusionQuery = this->UseOcclusionQuery;
  return settings;
}

//------------------------------------------------------------------------------
int vtkOITPeelingPass::GetNumberOfPeels() const
{
  return this->GetStatistics().NumberOfPeels;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkOITPeelingPass::GetNumberOfLostFragments() const
{
  return this->GetStatistics().NumberOfLostFragments;
}
