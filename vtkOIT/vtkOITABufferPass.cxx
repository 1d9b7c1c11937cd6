// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITABufferPass.h"

#include "Private/ABuffer/vtkOITABufferEngine.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITABufferPass);

//------------------------------------------------------------------------------
vtkOITABufferPass::vtkOITABufferPass()
  : vtkOITPass(std::make_unique<vtkOITABufferEngine>())
  , Engine(static_cast<vtkOITABufferEngine*>(this->GetEngine()))
{
}

//------------------------------------------------------------------------------
vtkOITABufferPass::~vtkOITABufferPass() = default;

//------------------------------------------------------------------------------
void vtkOITABufferPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SkipHiddenFragments: " << this->SkipHiddenFragments << "\n"
     << indent << "SkippedHiddenFragments: " << this->GetSkippedHiddenFragments() << "\n"
     << indent << "NumberOfSharedAllocations: " << this->GetNumberOfSharedAllocations() << "\n";
}

//------------------------------------------------------------------------------
vtkOITSettings vtkOITABufferPass::MakeSettings(const vtkOITCapabilities& capabilities) const
{
  vtkOITSettings settings = this->Superclass::MakeSettings(capabilities);
  settings.SkipHiddenFragments = this->SkipHiddenFragments;
  return settings;
}

//------------------------------------------------------------------------------
bool vtkOITABufferPass::GetSkippedHiddenFragments() const
{
  return this->GetStatistics().SkippedHiddenFragments;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkOITABufferPass::GetNumberOfSharedAllocations() const
{
  return this->GetStatistics().SharedAllocations;
}

//------------------------------------------------------------------------------
bool vtkOITABufferPass::GetFragments(vtkFloatArray* fragments)
{
  if (this->GetAlgorithmName() != this->GetOwnAlgorithmName() ||
    this->GetStatistics().NumberOfFragments <= 0)
  {
    this->Engine->ForgetFrame();
  }
  const std::string reason = this->Engine->ReadFragments(fragments);
  if (!reason.empty())
  {
    vtkErrorMacro(<< reason);
  }
  return reason.empty();
}
