// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITMultiLayerPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOITDepthTestFS.h"
#include "vtkOITFragmentFS.h"
#include "vtkOITHalfFS.h"
#include "vtkOITMultiLayerGatherFS.h"
#include "vtkOITMultiLayerResolveFS.h"
#include "vtkOITMultiLayerSlotsFS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
int vtkOITMultiLayerPeeler::GetNumberOfSlots() const
{
  return this->HasPairs() ? this->NumberOfLayers / 2 : this->NumberOfLayers;
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::Prepare(const vtkOITFrame& frame, bool)
{
  const bool inPlace = vtkOITPeelState::CanWorkInPlace(frame);
  if (this->ShaderLayers != this->NumberOfLayers || this->UsedAccess != this->WantedAccess ||
    this->InPlace != inPlace)
  {
    this->Release();
    this->ShaderLayers = this->NumberOfLayers;
    this->UsedAccess = this->WantedAccess;
    this->InPlace = inPlace;
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
vtkOITPeelState::Layout vtkOITMultiLayerPeeler::GetLayout(const vtkOITFrame&) const
{
  vtkOITPeelState::Layout layout;
  layout.Layers = 5; // and the group of coincident fragments that goes on in the next peel
  return layout;
}

//------------------------------------------------------------------------------
int vtkOITMultiLayerPeeler::GetBytesPerPixel(const vtkOITFrame&) const
{
  return this->GetNumberOfSlots() * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32UI);
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::Begin(const vtkOITPeelContext& context)
{
  this->Slots.Reserve(context.Frame.Window, context.State.GetWidth(), context.State.GetHeight(),
    this->GetNumberOfSlots(), GL_RGBA32UI);
  this->DrawNumbers.clear();
  this->IsRest = false;
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::RenderGeometry(const vtkOITPeelContext& context)
{
  this->Draws.clear();
  context.RenderGeometry();
}

//------------------------------------------------------------------------------
// The paper's scheme. Fragments of a pixel that overlap in time may overwrite each other's layers,
// but each pass makes at least one more layer right, so it ends when a pass changes nothing.
void vtkOITMultiLayerPeeler::GatherUnordered(const vtkOITPeelContext& context)
{
  context.Frame.GLState->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const int passes = this->IsRest ? 1 : this->NumberOfLayers + 2;
  for (int pass = 0; pass < passes; ++pass)
  {
    this->Changes.Begin(context.Frame.Window, 0);
    this->RenderGeometry(context);
    vtkOITOcclusionQueries::End();
    if (this->Changes.GetResult(0) == 0)
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::Peel(const vtkOITPeelContext& context, int)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  const bool isRest = this->IsRest;
  const bool hasPairs = this->HasPairs();
  const int slots = this->Slots.GetNumberOfLayers();
  const auto clear = [=]
  {
    constexpr GLuint noDepth = 0x3fffffff;
    const GLuint empty[4] = { noDepth, hasPairs ? 0 : 0xffffffff, hasPairs ? noDepth : 0, 0 };
    const GLuint zero[4] = { 0, 0, 0, 0 };
    for (int i = 0; i < slots; ++i)
    {
      glClearBufferuiv(GL_COLOR, i, isRest ? zero : empty);
    }
  };
  context.State.BindForGather(this->GatherFramebuffer, this->Slots.GetAllLayers(), clear);
  gl->vtkglDisable(GL_BLEND);
  switch (this->UsedAccess)
  {
    case Access::Fetch:
      this->RenderGeometry(context);
      break;
    case Access::Interlock:
      // Images instead of colour buffers; the depth test is the same.
      vtkOITFramebuffer::DrawInto(0);
      glBindImageTexture(
        0, this->Slots.GetLayer(0).Texture, 0, GL_TRUE, 0, GL_READ_WRITE, GL_RGBA32UI);
      glMemoryBarrier(GL_ALL_BARRIER_BITS);
      this->RenderGeometry(context);
      glMemoryBarrier(GL_ALL_BARRIER_BITS);
      break;
    case Access::Barrier:
      this->GatherUnordered(context);
      break;
  }
  context.State.Resolve(
    this->ResolveStage,
    [&]
    {
      std::string text = context.State.AssembleResolve(vtkOITMultiLayerResolveFS,
        vtkOITRequireExtensions({ "GL_ARB_shader_bit_encoding" }) + this->GetDefinitions() +
          "#define OIT_RESOLVE\n");
      vtkOITReplace(text, "//VTK::OIT::Slots", std::string(vtkOITHalfFS) + vtkOITMultiLayerSlotsFS);
      vtkOITReplace(text, "//VTK::OIT::LoadSlots", vtkOITRepeat("OIT_LOAD_SLOT", slots));
      return text;
    },
    [&](vtkShaderProgram* program)
    {
      this->Slots.Bind(gl, vtkOITPeelState::GatheredUnit);
      program->SetUniformi("oitSlots", vtkOITPeelState::GatheredUnit);
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
    });
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::PeelRest(const vtkOITPeelContext& context)
{
  this->IsRest = true;
  this->Peel(context, -1);
  this->IsRest = false;
}

//------------------------------------------------------------------------------
std::string vtkOITMultiLayerPeeler::GetDefinitions() const
{
  const char* access = this->UsedAccess == Access::Fetch ? "#define OIT_FETCH\n"
    : this->UsedAccess == Access::Interlock              ? "#define OIT_INTERLOCK\n"
                                                         : "#define OIT_BARRIER\n";
  return access + std::string(this->HasPairs() ? "#define OIT_PAIRS\n" : "") +
    "#define OIT_SLOTS " + std::to_string(this->GetNumberOfSlots()) + "\n";
}

//------------------------------------------------------------------------------
bool vtkOITMultiLayerPeeler::WrapGather(std::string& fragmentShader) const
{
  std::string header =
    vtkOITRequireExtensions({ "GL_ARB_explicit_attrib_location", "GL_ARB_shader_bit_encoding" });
  if (this->UsedAccess == Access::Fetch)
  {
    header += vtkOITRequireExtensions(
      { "GL_EXT_shader_framebuffer_fetch", "GL_ARB_shader_image_load_store" });
  }
  else if (this->UsedAccess == Access::Interlock)
  {
    header += vtkOITRequireExtensions({ "GL_ARB_fragment_shader_interlock",
      "GL_ARB_shader_image_load_store", "GL_ARB_shading_language_420pack" });
  }
  header += this->GetDefinitions();
  if (vtkOITWritesDepth(fragmentShader))
  {
    header += "#define OIT_WRITES_DEPTH\n";
  }
  else if (this->UsedAccess != Access::Barrier)
  {
    header += "layout(early_fragment_tests) in;\n";
  }
  const int slots = this->GetNumberOfSlots();
  std::string stage = std::string(vtkOITFragmentFS) + vtkOITHalfFS + vtkOITMultiLayerSlotsFS +
    vtkOITMultiLayerGatherFS;
  vtkOITReplace(stage, "//VTK::OIT::DepthTest", vtkOITDepthTestFS);
  vtkOITReplace(stage, "//VTK::OIT::SlotBuffers", vtkOITRepeat("OIT_SLOT_BUFFER", slots));
  vtkOITReplace(stage, "//VTK::OIT::LoadSlots", vtkOITRepeat("OIT_LOAD_SLOT", slots));
  vtkOITReplace(stage, "//VTK::OIT::StoreSlots", vtkOITRepeat("OIT_STORE_SLOT", slots));
  return vtkOITWrapFragmentShader(fragmentShader, header, stage);
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::SetUniforms(
  vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context)
{
  context.State.BindFor(program);
  context.State.SetDepthTest(program);
  program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
  const int next = static_cast<int>(this->DrawNumbers.size());
  const auto number = this->DrawNumbers.emplace(std::make_pair(prop, this->Draws[prop]++), next);
  program->SetUniformi("oitDrawNumber", number.first->second);
  if (this->UsedAccess == Access::Barrier)
  {
    this->Slots.Bind(context.Frame.GLState, vtkOITPeelState::GatheredUnit);
    program->SetUniformi("oitSlots", vtkOITPeelState::GatheredUnit);
    glTextureBarrier(); // what the last draw has written
  }
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::Release()
{
  this->Slots.Release();
  this->GatherFramebuffer.Release();
  this->ResolveStage.Release();
  this->Changes.Release();
}
