// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITAutoPass.h"

#include "Private/Auto/vtkOITPlanner.h"
#include "Private/Engine/vtkOITEngine.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITSettings.h"
#include "Private/Frame/vtkOITStatistics.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkOITAutoPass);

namespace
{
constexpr vtkTypeInt64 LargestDefault = INT64_C(1) << 30; // 1 GiB
}

//------------------------------------------------------------------------------
class vtkOITAutoPass::Internals
{
public:
  vtkOITPlanner Planner;
  vtkTypeInt64 Limit = LargestDefault; // that holds for the last frame
};

//------------------------------------------------------------------------------
vtkOITAutoPass::vtkOITAutoPass()
  : vtkOITPass(nullptr)
  , Impl(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkOITAutoPass::~vtkOITAutoPass() = default;

//------------------------------------------------------------------------------
void vtkOITAutoPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SkipInvisibleProps: " << this->SkipInvisibleProps << "\n"
     << indent << "SkipSorting: " << this->SkipSorting << "\n"
     << indent << "SkipHiddenFragments: " << this->SkipHiddenFragments << "\n"
     << indent << "ReuseFrames: " << this->ReuseFrames << "\n"
     << indent << "DeferShading: " << this->DeferShading << "\n"
     << indent << "BufferLimit: " << this->GetBufferLimit() << "\n"
     << indent << "AlgorithmReason: " << this->GetAlgorithmReason() << "\n"
     << indent << "SkipSummary: " << this->GetSkipSummary() << "\n";
}

//------------------------------------------------------------------------------
std::string vtkOITAutoPass::GetSkipSummary() const
{
  return this->GetStatistics().Summary;
}

//------------------------------------------------------------------------------
std::string vtkOITAutoPass::GetAlgorithmReason() const
{
  return this->GetStatistics().Reason;
}

//------------------------------------------------------------------------------
std::string vtkOITAutoPass::GetChoice() const
{
  static bool hasWarned = false;
  if (!hasWarned)
  {
    hasWarned = true;
    vtkWarningMacro("GetChoice() is deprecated; use GetAlgorithmReason()");
  }
  return this->GetAlgorithmReason();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkOITAutoPass::GetBufferLimit() const
{
  return this->MaximumBufferSize > 0 ? this->MaximumBufferSize : this->Impl->Limit;
}

//------------------------------------------------------------------------------
void vtkOITAutoPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Impl->Planner.Forget();
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkOITSettings vtkOITAutoPass::MakeSettings(const vtkOITCapabilities& capabilities) const
{
  const vtkTypeInt64 memory = capabilities.Memory; // 0 when not known
  this->Impl->Limit = memory > 0 ? std::min(LargestDefault, memory / 4) : LargestDefault;
  vtkOITSettings settings = this->Superclass::MakeSettings(capabilities);
  settings.BufferLimit = this->GetBufferLimit();
  settings.SkipInvisibleProps = this->SkipInvisibleProps;
  settings.SkipSorting = this->SkipSorting;
  settings.SkipHiddenFragments = this->SkipHiddenFragments;
  settings.ReuseFrames = this->ReuseFrames;
  settings.DeferShading =
    this->DeferShading ? vtkOITSettings::Deferral::WhereItPays : vtkOITSettings::Deferral::Never;
  return settings;
}

//------------------------------------------------------------------------------
vtkOITPlan vtkOITAutoPass::MakePlan(const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  if (frame.Volumes)
  {
    return this->Superclass::MakePlan(frame, settings); // all is sorted
  }
  // It is not known what other delegates draw.
  const bool isKnown = this->TranslucentPass->GetClassName() == std::string("vtkTranslucentPass");
  return this->Impl->Planner.MakePlan(frame, settings, isKnown);
}
