// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITABufferShaders.h"

#include "Private/ABuffer/vtkOITSortingNetwork.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/GL/vtkOITOutput.h"

#include "vtkOITABufferCheckFS.h"
#include "vtkOITABufferCompositeFS.h"
#include "vtkOITABufferCountFS.h"
#include "vtkOITABufferGatherFS.h"
#include "vtkOITABufferGroupsFS.h"
#include "vtkOITABufferLeaveFS.h"
#include "vtkOITABufferMergeFS.h"
#include "vtkOITABufferNodeFS.h"
#include "vtkOITABufferReadFS.h"
#include "vtkOITABufferRegistersFS.h"
#include "vtkOITABufferResolveFS.h"
#include "vtkOITABufferSecondChanceFS.h"
#include "vtkOITABufferShadeFS.h"
#include "vtkOITABufferSortFS.h"
#include "vtkOITABufferTileVS.h"
#include "vtkOITDeferredGatherFS.h"
#include "vtkOITDeferredLightFS.h"
#include "vtkOITDeferredMaterialFS.h"
#include "vtkOITDepthTestFS.h"
#include "vtkOITFragmentFS.h"
#include "vtkOITHalfFS.h"

#include <tuple>

//------------------------------------------------------------------------------
bool vtkOITABufferShaders::operator==(const vtkOITABufferShaders& other) const
{
  const auto tie = [](const vtkOITABufferShaders& s)
  {
    return std::tie(s.Samples, s.FloatColor, s.NodesInImage, s.NodesInTexture, s.FramebufferFetch,
      s.PostDepthCoverage, s.HeadInTarget, s.ClampColor, s.FineDerivatives, s.LastOnTop,
      s.Interlock, s.HasLight, s.Volumes, s.Deferred, s.Specular, s.Physical);
  };
  return tie(*this) == tie(other);
}

//------------------------------------------------------------------------------
void vtkOITABufferShaders::AddVariant(vtkOITShaderText& text) const
{
  text.Require({ "GL_ARB_shader_image_load_store", "GL_ARB_shader_storage_buffer_object",
    "GL_ARB_shading_language_420pack", "GL_ARB_gpu_shader5" });
  text.Define("OIT_SAMPLES", this->Samples);
  text.Define("OIT_WIDE_NODES", this->HasWideNodes());
  text.Define("OIT_LAST_ON_TOP", this->LastOnTop);
  text.Define("OIT_HAS_LIGHT", this->HasLight);
  text.Define("OIT_HAS_DRAW_ORDER", this->HasDrawOrder());
  text.Define("OIT_NODE_TEXELS", this->GetTexelsPerNode());
  text.Define("OIT_FLOAT_COLOR", this->FloatColor);
  text.Define("OIT_NODES_IN_IMAGE", this->NodesInImage);
  text.Define("OIT_CLAMP_COLOR", this->ClampColor);
  text.Define("OIT_DEFERRED", this->Deferred);
  text.Insert("Half", vtkOITHalfFS);
}

//------------------------------------------------------------------------------
vtkOITShaderText vtkOITABufferShaders::GetGather() const
{
  vtkOITShaderText text({ vtkOITFragmentFS, vtkOITABufferNodeFS, vtkOITABufferGatherFS });
  this->AddVariant(text);
  text.Insert("DepthTest", vtkOITDepthTestFS).TestDepthEarly();
  text.Insert("Material", std::string(vtkOITDeferredMaterialFS) + vtkOITDeferredGatherFS);
  text.Define("OIT_HEAD_IN_TARGET", this->HeadInTarget);
  if (this->HeadInTarget)
  {
    text.Require({ "GL_EXT_shader_framebuffer_fetch" });
  }
  if (this->HasDrawOrder())
  {
    text.ReadPrimitives();
  }
  text.Define("OIT_INTERLOCK", this->Interlock);
  if (this->Interlock)
  {
    text.Require({ "GL_ARB_fragment_shader_interlock" });
  }
  if (this->Samples > 0 && this->PostDepthCoverage)
  {
    text.Require({ "GL_ARB_post_depth_coverage" });
    text.Declare("#ifndef OIT_WRITES_DEPTH\nlayout(post_depth_coverage) in;\n#endif");
  }
  // Otherwise the coverage after the depth test is not known to a shader, so it tests itself.
  text.Define("OIT_TEST_DEPTH", this->Samples > 0 && !this->PostDepthCoverage);
  return text;
}

//------------------------------------------------------------------------------
vtkOITShaderText vtkOITABufferShaders::MakeStage(const char* file) const
{
  vtkOITShaderText text({ file });
  text.Insert("Node", vtkOITABufferNodeFS);
  this->AddVariant(text);
  text.Insert("Read", vtkOITABufferReadFS);
  text.Insert("RegisterMacros", vtkOITABufferRegistersFS);
  text.Insert("Light", std::string(vtkOITDeferredMaterialFS) + vtkOITDeferredLightFS);
  text.Define("OIT_HAS_SPECULAR", this->Specular);
  text.Define("OIT_HAS_PHYSICAL", this->Physical);
  text.Define("OIT_DIRECTIONAL_FROM_POSITION", vtkOITDirectionalFromPosition);
  return text;
}

//------------------------------------------------------------------------------
vtkOITShaderText vtkOITABufferShaders::MakeOutputStage(const char* file) const
{
  vtkOITShaderText text = this->MakeStage(file);
  if (this->Samples > 0)
  {
    text.Require({ "GL_ARB_sample_shading" });
  }
  vtkOITAddOutput(text, this->FramebufferFetch);
  return text;
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetTileVertexShader()
{
  return vtkOITShaderText({ vtkOITABufferTileVS }).GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetCheck() const
{
  return this->MakeStage(vtkOITABufferCheckFS).GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetCount() const
{
  return this->MakeStage(vtkOITABufferCountFS)
    .Define("OIT_COUNTS_FRAGMENTS", this->Volumes)
    .GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetResolve(int networkSize) const
{
  vtkOITShaderText text = this->MakeOutputStage(vtkOITABufferResolveFS);
  if (this->FineDerivatives)
  {
    text.Require({ "GL_ARB_derivative_control" });
  }
  return text.Define("OIT_FINE_DERIVATIVES", this->FineDerivatives)
    .Define("OIT_NODES_IN_TEXTURE", this->NodesInTexture)
    .Define("OIT_ENDS_LONG_LISTS", networkSize > OIT_LONG_LIST && !this->Deferred)
    .Define("OIT_NETWORK_SIZE", networkSize)
    .Insert("Registers", vtkOITRegisterResolve(networkSize))
    .GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetSecondChance() const
{
  if (this->Deferred)
  {
    return this->MakeStage(vtkOITABufferLeaveFS).GetText();
  }
  return this->MakeOutputStage(vtkOITABufferSecondChanceFS)
    .Define("OIT_ENDS_LONG_LISTS")
    .Define("OIT_NODES_IN_TEXTURE", this->NodesInTexture)
    .Insert("Registers", vtkOITRegisterSelect(OIT_LONG_LIST, KeptFragments))
    .GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetWalk() const
{
  if (this->Deferred)
  {
    return this->MakeStage(vtkOITABufferLeaveFS).GetText();
  }
  return this->MakeOutputStage(vtkOITABufferSecondChanceFS)
    .Define("OIT_ENDS_LONG_LISTS")
    .Define("OIT_NODES_IN_TEXTURE", this->NodesInTexture)
    .Insert("Registers", vtkOITRegisterWalk(WalkedFragments, LongestWalk))
    .GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetSort(int runSize) const
{
  return this->MakeStage(vtkOITABufferSortFS)
    .Define("OIT_SORTS_ALL", this->SortsAll())
    .Define("OIT_RUN", runSize)
    .Insert("SortRun", vtkOITRegisterSort(runSize))
    .GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetMerge(int runs) const
{
  const vtkOITRegisterMerge text(OIT_MERGED_RUN, runs);
  return this->MakeOutputStage(vtkOITABufferMergeFS)
    .Insert("Groups", vtkOITABufferGroupsFS)
    .Insert("MergeDeclare", text.Declare)
    .Insert("MergeRun", text.Run)
    .Insert("MergeLoad", text.Load)
    .Insert("MergeCompare", text.Compare)
    .GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetShade() const
{
  return this->MakeStage(vtkOITABufferShadeFS).GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetComposite() const
{
  return this->MakeOutputStage(vtkOITABufferCompositeFS)
    .Define("OIT_VOLUMES", this->Volumes)
    .Insert("Groups", vtkOITABufferGroupsFS)
    .GetText();
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetVolume(const std::string& mapperShader) const
{
  vtkOITShaderText text = this->MakeStage(mapperShader.c_str());
  if (this->FineDerivatives)
  {
    text.Require({ "GL_ARB_derivative_control" }); // for its GLSL, which has gl_HelperInvocation
  }
  if (this->Samples > 0)
  {
    text.Require({ "GL_ARB_sample_shading" });
  }
  return text.GetText();
}
