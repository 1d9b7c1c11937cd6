// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITDualPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOITDualCompositeFS.h"
#include "vtkOITDualGatherFS.h"
#include "vtkOITDualLayersFS.h"
#include "vtkOITDualResolveFS.h"
#include "vtkOITFragmentFS.h"
#include "vtkOITHalfFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
// Layers of the state.
constexpr int StatisticsLayer = 1;
constexpr int BoundsLayer = 2;
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::Prepare(const vtkOITFrame&, bool hasFloatColor)
{
  const int layers = hasFloatColor ? 1 : this->WantedLayersPerSide;
  if (this->LayersPerSide != layers || this->FloatColor != hasFloatColor)
  {
    this->Release();
    this->LayersPerSide = layers;
    this->FloatColor = hasFloatColor;
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
vtkOITPeelState::Layout vtkOITDualPeeler::GetLayout(const vtkOITFrame&) const
{
  vtkOITPeelState::Layout layout;
  layout.Layers = 4;
  layout.HasBack = true;
  layout.StartsInResolve = true;
  return layout;
}

//------------------------------------------------------------------------------
int vtkOITDualPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  return this->GetNumberOfBuffers() * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32UI);
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::Begin(const vtkOITPeelContext& context)
{
  this->Layers.Reserve(context.Frame.Window, context.State.GetWidth(), context.State.GetHeight(),
    this->GetNumberOfBuffers(), GL_RGBA32UI);
  this->IsRest = false;
  this->FirstHasAll = false;
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::Gather(const vtkOITPeelContext& context)
{
  std::vector<vtkOITAttachment> colors = this->Layers.GetAllLayers();
  colors.push_back(
    context.State.GetArray().GetLayer(this->IsFirst ? StatisticsLayer : BoundsLayer));
  context.State.BindForGather(this->GatherFramebuffer, colors,
    [this]
    {
      const GLuint noNear[4] = { 0x7fffffff, 0, 0, 0 };
      const GLuint noFar[4] = { 0, 0, 0, 0 };
      for (int i = 0; i < this->GetNumberOfLayers(); ++i)
      {
        // What those of float colours hold is used only where there is a key.
        glClearBufferuiv(GL_COLOR, i, i < this->LayersPerSide ? noNear : noFar);
      }
    });
  context.Frame.GLState->vtkglDisable(GL_BLEND);
  if (this->IsFirst)
  {
    context.RenderGeometry();
    return;
  }
  // Bounds are only read. VTK compares the mask of the first buffer with what it knows.
  const auto bounds = static_cast<GLuint>(this->GetNumberOfBuffers());
  glColorMaski(bounds, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  context.RenderGeometry();
  glColorMaski(bounds, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::AddLayers(std::string& stage) const
{
  vtkOITReplace(stage, "//VTK::OIT::Layers", std::string(vtkOITHalfFS) + vtkOITDualLayersFS);
  vtkOITReplace(
    stage, "//VTK::OIT::LoadLayers", vtkOITRepeat("OIT_LOAD_LAYER", this->GetNumberOfLayers()));
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::Resolve(const vtkOITPeelContext& context)
{
  context.State.Resolve(
    this->ResolveStage,
    [&]
    {
      std::string text = context.State.AssembleResolve(vtkOITDualResolveFS,
        vtkOITRequireExtensions({ "GL_ARB_shader_bit_encoding" }) + this->GetDefinitions() +
          "#define OIT_READ_LAYERS\n");
      this->AddLayers(text);
      return text;
    },
    [&](vtkShaderProgram* program)
    {
      this->Layers.Bind(context.Frame.GLState, vtkOITPeelState::GatheredUnit);
      program->SetUniformi("oitLayers", vtkOITPeelState::GatheredUnit);
      program->SetUniformi("oitFirst", this->IsFirst ? 1 : 0);
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
    });
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::Peel(const vtkOITPeelContext& context, int number)
{
  this->IsFirst = number == 0;
  this->Gather(context);
  this->FirstHasAll = this->IsFirst && context.ExpectsAll && context.State.IsFirstPeelComplete();
  if (!this->FirstHasAll)
  {
    this->Resolve(context);
  }
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::PeelRest(const vtkOITPeelContext& context)
{
  this->IsRest = true;
  this->Peel(context, -1);
  this->IsRest = false;
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::Composite(const vtkOITPeelContext& context)
{
  context.State.Composite(
    this->CompositeStage,
    [this]
    {
      std::string text = vtkOITDualCompositeFS;
      vtkOITReplace(text, "//VTK::System::Dec",
        "//VTK::System::Dec\n" + vtkOITRequireExtensions({ "GL_ARB_shader_bit_encoding" }) +
          this->GetDefinitions() + "#define OIT_READ_LAYERS\n");
      this->AddLayers(text);
      return text;
    },
    [&](vtkShaderProgram* program)
    {
      this->Layers.Bind(context.Frame.GLState, vtkOITPeelState::GatheredUnit);
      program->SetUniformi("oitLayers", vtkOITPeelState::GatheredUnit);
    });
}

//------------------------------------------------------------------------------
std::string vtkOITDualPeeler::GetDefinitions() const
{
  return "#define OIT_SIDE " + std::to_string(this->LayersPerSide) + "\n#define OIT_BUFFERS " +
    std::to_string(this->GetNumberOfBuffers()) + "\n" +
    (this->FloatColor ? "#define OIT_FLOAT_COLOR\n" : "");
}

//------------------------------------------------------------------------------
bool vtkOITDualPeeler::WrapGather(std::string& fragmentShader) const
{
  std::string header =
    vtkOITRequireExtensions({ "GL_ARB_explicit_attrib_location", "GL_ARB_shader_bit_encoding",
      "GL_EXT_shader_framebuffer_fetch", "GL_ARB_shader_image_load_store" }) +
    this->GetDefinitions();
  // Reading the framebuffer would end the tests before the shader.
  header += vtkOITWritesDepth(fragmentShader) ? "#define OIT_WRITES_DEPTH\n"
                                              : "layout(early_fragment_tests) in;\n";
  std::string stage = std::string(vtkOITFragmentFS) + "//VTK::OIT::Layers\n" + vtkOITDualGatherFS;
  this->AddLayers(stage);
  const int layers = this->GetNumberOfLayers();
  vtkOITReplace(stage, "//VTK::OIT::LayerBuffers", vtkOITRepeat("OIT_LAYER_BUFFER", layers));
  vtkOITReplace(stage, "//VTK::OIT::StoreLayers", vtkOITRepeat("OIT_STORE_LAYER", layers));
  return vtkOITWrapFragmentShader(fragmentShader, header, stage);
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::SetUniforms(vtkShaderProgram* program, vtkProp*, const vtkOITPeelContext&)
{
  program->SetUniformi("oitFirst", this->IsFirst ? 1 : 0);
  program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkOITDualPeeler::Release()
{
  this->Layers.Release();
  this->GatherFramebuffer.Release();
  this->ResolveStage.Release();
  this->CompositeStage.Release();
}
