// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The properties of a vtkOITPass: what they refuse, and what is made of them for a frame.

#include "vtkOITPass.h"

#include "Private/Frame/vtkOITSettings.h"

//------------------------------------------------------------------------------
void vtkOITPass::SetTranslucentPass(vtkRenderPass* pass)
{
  if (vtkOITPass::SafeDownCast(pass))
  {
    vtkErrorMacro(
      "A " << pass->GetClassName()
           << " is refused as TranslucentPass; give the pass that draws the props, e.g. "
              "a vtkTranslucentPass");
    return;
  }
  if (this->TranslucentPass != pass)
  {
    this->TranslucentPass = pass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkOITPass::GetTranslucentPass()
{
  return this->TranslucentPass;
}

//------------------------------------------------------------------------------
void vtkOITPass::SetVolumetricPass(vtkRenderPass* pass)
{
  if (vtkOITPass::SafeDownCast(pass))
  {
    vtkErrorMacro("A " << pass->GetClassName()
                       << " is refused as VolumetricPass; give the pass that draws the volumes, e.g. "
                          "a vtkVolumetricPass");
    return;
  }
  if (this->VolumetricPass != pass)
  {
    this->VolumetricPass = pass;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkOITPass::GetVolumetricPass()
{
  return this->VolumetricPass;
}

//------------------------------------------------------------------------------
// Not a number is in no range.
bool vtkOITPass::IsInRange(const char* property, double value, double low, double high)
{
  const bool isInRange = value >= low && value <= high;
  if (!isInRange)
  {
    vtkErrorMacro(<< property << " " << value << " is refused; give a number from " << low << " to "
                  << high);
  }
  return isInRange;
}

//------------------------------------------------------------------------------
bool vtkOITPass::IsNamedValue(const char* property, int value, int last, const char* names)
{
  const bool isNamed = value >= 0 && value <= last;
  if (!isNamed)
  {
    vtkErrorMacro(<< property << " " << value << " is refused; give " << names);
  }
  return isNamed;
}

//------------------------------------------------------------------------------
void vtkOITPass::SetTransmittanceThreshold(double threshold)
{
  if (this->IsInRange("TransmittanceThreshold", threshold, 0.0, 1.0) &&
    this->TransmittanceThreshold != threshold)
  {
    this->TransmittanceThreshold = threshold;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::SetMaximumNumberOfPeels(int peels)
{
  if (this->IsInRange("MaximumNumberOfPeels", peels, 0, VTK_INT_MAX) &&
    this->MaximumNumberOfPeels != peels)
  {
    this->MaximumNumberOfPeels = peels;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::SetOcclusionRatio(double ratio)
{
  if (this->IsInRange("OcclusionRatio", ratio, 0.0, 0.5) && this->OcclusionRatio != ratio)
  {
    this->OcclusionRatio = ratio;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::SetMaximumBufferSize(vtkTypeInt64 bytes)
{
  constexpr vtkTypeInt64 smallest = 1 << 20;
  if (bytes < 0 || (bytes > 0 && bytes < smallest))
  {
    vtkErrorMacro("MaximumBufferSize " << bytes << " is refused; give 0 for no limit, or at least "
                                       << smallest << " bytes");
    return;
  }
  if (this->MaximumBufferSize != bytes)
  {
    this->MaximumBufferSize = bytes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::SetFragmentPrecision(int precision)
{
  if (this->IsNamedValue("FragmentPrecision", precision, FLOAT, "HALF or FLOAT") &&
    this->FragmentPrecision != precision)
  {
    this->FragmentPrecision = precision;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITPass::SetCoincidentLayers(int rule)
{
  if (this->IsNamedValue("CoincidentLayers", rule, LAST_ON_TOP, "MEAN or LAST_ON_TOP") &&
    this->CoincidentLayers != rule)
  {
    this->CoincidentLayers = rule;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkOITSettings vtkOITPass::MakeSettings(const vtkOITCapabilities&) const
{
  vtkOITSettings settings;
  settings.TransmittanceThreshold = this->TransmittanceThreshold;
  settings.FloatColor = this->FragmentPrecision == FLOAT;
  settings.LastOnTop = this->CoincidentLayers == LAST_ON_TOP;
  settings.BufferLimit = this->MaximumBufferSize;
  settings.MaximumNumberOfPeels = this->MaximumNumberOfPeels;
  settings.OcclusionRatio = this->OcclusionRatio;
  settings.Time = const_cast<vtkOITPass*>(this)->GetMTime();
  return settings;
}
