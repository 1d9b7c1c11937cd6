// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITABufferShaders.h"

#include "Private/GL/vtkOITOutput.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOITABufferCompositeFS.h"
#include "vtkOITABufferCountFS.h"
#include "vtkOITABufferGatherFS.h"
#include "vtkOITABufferNodeFS.h"
#include "vtkOITABufferReadFS.h"
#include "vtkOITABufferRegistersFS.h"
#include "vtkOITABufferResolveFS.h"
#include "vtkOITABufferSecondChanceFS.h"
#include "vtkOITABufferSortFS.h"
#include "vtkOITABufferTileVS.h"
#include "vtkOITDepthTestFS.h"
#include "vtkOITHalfFS.h"
#include "vtkOITOutputFS.h"

#include <tuple>

namespace
{
/// For stages that have lists in registers which may end at the threshold.
std::string DefineLongList()
{
  return "#define OIT_LONG_LIST " + std::to_string(vtkOITABufferShaders::LongList) + "u\n";
}
}

//------------------------------------------------------------------------------
bool vtkOITABufferShaders::operator==(const vtkOITABufferShaders& other) const
{
  const auto tie = [](const vtkOITABufferShaders& s)
  {
    return std::tie(s.Samples, s.FloatColor, s.NodesInImage, s.FramebufferFetch,
      s.PostDepthCoverage, s.HeadInTarget);
  };
  return tie(*this) == tie(other);
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetDefinitions() const
{
  std::string text = "#define OIT_SAMPLES " + std::to_string(this->Samples) + "\n";
  text += this->HasWideNodes() ? "#define OIT_WIDE_NODES\n" : "";
  text += this->FloatColor ? "#define OIT_FLOAT_COLOR\n" : "";
  text += this->NodesInImage ? "#define OIT_NODES_IN_IMAGE\n" : "";
  return text;
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetHeader() const
{
  return vtkOITRequireExtensions(
           { "GL_ARB_shader_image_load_store", "GL_ARB_shader_storage_buffer_object",
             "GL_ARB_shading_language_420pack", "GL_ARB_gpu_shader5" }) +
    this->GetDefinitions();
}

//------------------------------------------------------------------------------
bool vtkOITABufferShaders::WrapGather(std::string& fragmentShader) const
{
  const bool writesDepth = vtkOITWritesDepth(fragmentShader);
  std::string header = this->GetHeader();
  if (writesDepth)
  {
    header += "#define OIT_WRITES_DEPTH\n";
  }
  if (this->HeadInTarget)
  {
    header = vtkOITRequireExtensions({ "GL_EXT_shader_framebuffer_fetch" }) + header +
      "#define OIT_HEAD_IN_TARGET\n";
  }
  else if (writesDepth || this->NeedsDepthTest())
  {
    header += "#define OIT_TEST_DEPTH\n";
  }
  if (!writesDepth)
  {
    if (this->Samples > 0 && this->PostDepthCoverage)
    {
      header = vtkOITRequireExtensions({ "GL_ARB_post_depth_coverage" }) + header +
        "layout(post_depth_coverage) in;\n";
    }
    header += "layout(early_fragment_tests) in;\n";
  }
  std::string stage = std::string(vtkOITABufferNodeFS) + vtkOITABufferGatherFS;
  vtkOITReplace(stage, "//VTK::OIT::Half", vtkOITHalfFS);
  vtkOITReplace(stage, "//VTK::OIT::DepthTest", vtkOITDepthTestFS);
  return vtkOITWrapFragmentShader(fragmentShader, header, stage);
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetOutputHeader() const
{
  std::string header = this->GetHeader();
  if (this->Samples > 0)
  {
    header = vtkOITRequireExtensions({ "GL_ARB_sample_shading" }) + header;
  }
  return vtkOITGetOutputHeader(this->FramebufferFetch) + header;
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::Assemble(const char* stage, const std::string& header) const
{
  std::string text = stage;
  vtkOITReplace(text, "//VTK::System::Dec", "//VTK::System::Dec\n" + header);
  vtkOITReplace(text, "//VTK::OIT::Node", vtkOITABufferNodeFS);
  vtkOITReplace(text, "//VTK::OIT::Half", vtkOITHalfFS);
  vtkOITReplace(text, "//VTK::OIT::Read", vtkOITABufferReadFS);
  vtkOITReplace(text, "//VTK::OIT::RegisterMacros", vtkOITABufferRegistersFS);
  vtkOITReplace(text, "//VTK::OIT::Output", vtkOITOutputFS);
  return text;
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetTileVertexShader()
{
  std::string sizes;
  for (int size : NetworkSizes)
  {
    sizes += (sizes.empty() ? "" : ", ") + std::to_string(size);
  }
  std::string text = vtkOITABufferTileVS;
  vtkOITReplace(text, "//VTK::System::Dec",
    "//VTK::System::Dec\n#define OIT_NETWORK_COUNT " + std::to_string(NetworkSizes.size()) +
      "\n#define OIT_NETWORK_SIZES " + sizes + "\n");
  return text;
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetCount() const
{
  return this->Assemble(vtkOITABufferCountFS, this->GetHeader());
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetResolve(int networkSize) const
{
  std::string text = this->Assemble(vtkOITABufferResolveFS,
    this->GetOutputHeader() + (networkSize > LongList ? DefineLongList() : std::string()));
  vtkOITReplace(text, "//VTK::OIT::Registers", vtkOITRegisterResolve(networkSize));
  return text;
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetSecondChance() const
{
  std::string text =
    this->Assemble(vtkOITABufferSecondChanceFS, this->GetOutputHeader() + DefineLongList());
  vtkOITReplace(text, "//VTK::OIT::Registers", vtkOITRegisterSelect(LongList, KeptFragments));
  return text;
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetSort() const
{
  std::string text = this->Assemble(vtkOITABufferSortFS,
    this->GetHeader() + "#define OIT_RUN_SIZE " + std::to_string(RunSize) + "\n");
  vtkOITReplace(text, "//VTK::OIT::SortRun", vtkOITRegisterSort(RunSize));
  return text;
}

//------------------------------------------------------------------------------
std::string vtkOITABufferShaders::GetComposite() const
{
  return this->Assemble(vtkOITABufferCompositeFS, this->GetOutputHeader());
}
