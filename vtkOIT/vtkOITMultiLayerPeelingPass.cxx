// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITMultiLayerPeelingPass.h"

#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Peeling/vtkOITMultiLayerPeeler.h"

#include "vtkObjectFactory.h"

namespace
{
using Access = vtkOITMultiLayerPeeler::Access;

/// Empty, or what the context lacks for this way of access.
std::string FindMissingFor(const vtkOITCapabilities& capabilities, Access access, int layers)
{
  switch (access)
  {
    case Access::Fetch:
      return capabilities.FramebufferFetch && capabilities.EarlyFragmentTests
        ? ""
        : "GL_EXT_shader_framebuffer_fetch with GL_ARB_shader_image_load_store";
    case Access::Interlock:
      return capabilities.FragmentInterlock && capabilities.HasStorage()
        ? ""
        : "GL_ARB_fragment_shader_interlock with GL_ARB_shader_image_load_store";
    default:
      if (layers > 8)
      {
        return "an ordered access to pixels, which 16 layers a pass need";
      }
      return capabilities.TextureBarrier ? "" : "GL_ARB_texture_barrier";
  }
}

/// The accesses that a setting allows, best first.
std::vector<Access> GetAllowed(int synchronization)
{
  switch (synchronization)
  {
    case vtkOITMultiLayerPeelingPass::FRAMEBUFFER_FETCH:
      return { Access::Fetch };
    case vtkOITMultiLayerPeelingPass::INTERLOCK:
      return { Access::Interlock };
    case vtkOITMultiLayerPeelingPass::TEXTURE_BARRIER:
      return { Access::Barrier };
    default:
      return { Access::Fetch, Access::Interlock, Access::Barrier };
  }
}
}

vtkStandardNewMacro(vtkOITMultiLayerPeelingPass);

//------------------------------------------------------------------------------
vtkOITMultiLayerPeelingPass::vtkOITMultiLayerPeelingPass()
  : vtkOITPeelingPass(std::make_unique<vtkOITMultiLayerPeeler>())
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
std::string vtkOITMultiLayerPeelingPass::FindMissingCapability(
  const vtkOITCapabilities& capabilities)
{
  std::string missing = capabilities.GetMissingForPeeling();
  if (!missing.empty())
  {
    return missing;
  }
  for (const Access access : GetAllowed(this->Synchronization))
  {
    missing = FindMissingFor(capabilities, access, this->NumberOfLayersPerPass);
    if (missing.empty())
    {
      return {};
    }
  }
  return "multi-layer peeling: this context lacks " + missing +
    "; choose another Synchronization or NumberOfLayersPerPass, or another method";
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeelingPass::RenderTranslucent(vtkOITFrame& frame)
{
  auto& peeler = static_cast<vtkOITMultiLayerPeeler&>(this->GetPeeler());
  peeler.SetNumberOfLayers(this->NumberOfLayersPerPass);
  for (const Access access : GetAllowed(this->Synchronization))
  {
    if (FindMissingFor(*frame.Capabilities, access, this->NumberOfLayersPerPass).empty())
    {
      peeler.SetAccess(access);
      break;
    }
  }
  this->Superclass::RenderTranslucent(frame);
}
