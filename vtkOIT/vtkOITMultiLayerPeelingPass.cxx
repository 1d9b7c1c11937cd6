// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITMultiLayerPeelingPass.h"

#include "Private/Frame/vtkOITSettings.h"
#include "Private/Peeling/vtkOITMultiLayerPeeler.h"
#include "Private/Peeling/vtkOITPeelingEngine.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOITMultiLayerPeelingPass);

//------------------------------------------------------------------------------
vtkOITMultiLayerPeelingPass::vtkOITMultiLayerPeelingPass()
  : vtkOITPeelingPass(std::make_unique<vtkOITPeelingEngine>(
      "multi-layer depth peeling", std::make_unique<vtkOITMultiLayerPeeler>()))
{
}

//------------------------------------------------------------------------------
vtkOITMultiLayerPeelingPass::~vtkOITMultiLayerPeelingPass() = default;

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeelingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLayersPerPass: " << this->NumberOfLayersPerPass << "\n"
     << indent << "Synchronization: " << this->Synchronization << "\n";
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeelingPass::SetNumberOfLayersPerPass(int layers)
{
  if (layers != 4 && layers != 8 && layers != 16)
  {
    vtkErrorMacro("NumberOfLayersPerPass " << layers << " is refused; give 4, 8 or 16");
    return;
  }
  if (this->NumberOfLayersPerPass != layers)
  {
    this->NumberOfLayersPerPass = layers;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeelingPass::SetSynchronization(int synchronization)
{
  if (this->IsNamedValue("Synchronization", synchronization, TEXTURE_BARRIER,
        "AUTOMATIC, FRAMEBUFFER_FETCH, INTERLOCK or TEXTURE_BARRIER") &&
    this->Synchronization != synchronization)
  {
    this->Synchronization = synchronization;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeelingPass::SetFragmentPrecision(int precision)
{
  if (precision == FLOAT)
  {
    vtkErrorMacro("FragmentPrecision FLOAT is refused; multi-layer peeling keeps half floats. Take "
                  "another method, e.g. vtkOITABufferPass or vtkOITDualDepthPeelingPass");
    return;
  }
  this->Superclass::SetFragmentPrecision(precision);
}

//------------------------------------------------------------------------------
vtkOITSettings vtkOITMultiLayerPeelingPass::MakeSettings(
  const vtkOITCapabilities& capabilities) const
{
  vtkOITSettings settings = this->Superclass::MakeSettings(capabilities);
  settings.NumberOfLayersPerPass = this->NumberOfLayersPerPass;
  settings.Synchronization = this->Synchronization;
  return settings;
}
