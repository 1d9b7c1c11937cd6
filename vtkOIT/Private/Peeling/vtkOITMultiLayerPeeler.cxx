// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITMultiLayerPeeler.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITSettings.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITDepthTestFS.h"
#include "vtkOITFragmentFS.h"
#include "vtkOITHalfFS.h"
#include "vtkOITMultiLayerGatherFS.h"
#include "vtkOITMultiLayerResolveFS.h"
#include "vtkOITMultiLayerSlotsFS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
using Access = vtkOITMultiLayerPeeler::Access;

/// Empty, or what the context lacks for this way of access.
std::string FindMissingFor(
  const vtkOITCapabilities& capabilities, Access access, const vtkOITSettings& settings)
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
      if (settings.NumberOfLayersPerPass > 8 || settings.LastOnTop)
      {
        return std::string("an ordered access to pixels, which ") +
          (settings.LastOnTop ? "CoincidentLayers LAST_ON_TOP needs" : "16 layers a pass need");
      }
      return capabilities.TextureBarrier ? "" : "GL_ARB_texture_barrier";
  }
}

/// The ways of access that a setting (vtkOITMultiLayerPeelingPass::SynchronizationType) allows, best
/// first.
std::vector<Access> GetAllowed(int synchronization)
{
  switch (synchronization)
  {
    case 1:
      return { Access::Fetch };
    case 2:
      return { Access::Interlock };
    case 3:
      return { Access::Barrier };
    default:
      return { Access::Fetch, Access::Interlock, Access::Barrier };
  }
}

/// The one that is taken, of those that the context has.
Access Choose(const vtkOITCapabilities& capabilities, const vtkOITSettings& settings)
{
  const std::vector<Access> allowed = GetAllowed(settings.Synchronization);
  for (const Access access : allowed)
  {
    if (FindMissingFor(capabilities, access, settings).empty())
    {
      return access;
    }
  }
  return allowed.back();
}
}

//------------------------------------------------------------------------------
int vtkOITMultiLayerPeeler::GetNumberOfSlots() const
{
  return this->HasPairs() ? this->NumberOfLayers / 2 : this->NumberOfLayers;
}

//------------------------------------------------------------------------------
std::string vtkOITMultiLayerPeeler::FindMissing(
  const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const
{
  std::string missing = capabilities.GetMissingForPeeling();
  if (!missing.empty())
  {
    return missing;
  }
  for (const Access access : GetAllowed(settings.Synchronization))
  {
    missing = FindMissingFor(capabilities, access, settings);
    if (missing.empty())
    {
      return {};
    }
  }
  return "multi-layer peeling: this context lacks " + missing +
    "; choose another Synchronization or NumberOfLayersPerPass, or another method";
}

//------------------------------------------------------------------------------
bool vtkOITMultiLayerPeeler::UsesStorage(
  const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const
{
  return Choose(capabilities, settings) == Access::Interlock;
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::Prepare(const vtkOITFrame& frame, const vtkOITSettings& settings)
{
  this->NumberOfLayers = settings.NumberOfLayersPerPass;
  this->LastOnTop = settings.LastOnTop;
  this->UsedAccess = Choose(*frame.Capabilities, settings);
  const int slots = this->GetNumberOfSlots();
  vtkOITShaderText text(
    { vtkOITFragmentFS, vtkOITHalfFS, vtkOITMultiLayerSlotsFS, vtkOITMultiLayerGatherFS });
  text.Require({ "GL_ARB_explicit_attrib_location", "GL_ARB_shader_bit_encoding" });
  if (this->UsedAccess == Access::Fetch)
  {
    text.Require({ "GL_EXT_shader_framebuffer_fetch", "GL_ARB_shader_image_load_store" });
    text.TestDepthEarly();
  }
  else if (this->UsedAccess == Access::Interlock)
  {
    text.Require({ "GL_ARB_fragment_shader_interlock", "GL_ARB_shader_image_load_store",
      "GL_ARB_shading_language_420pack" });
    text.TestDepthEarly();
  }
  if (!this->HasPairs() && !this->LastOnTop)
  {
    text.ReadPrimitives();
  }
  this->AddVariant(text);
  text.Define("OIT_CLAMP_COLOR", frame.Target.ClampsColor);
  text.Insert("DepthTest", vtkOITDepthTestFS);
  text.InsertRepeated("SlotBuffers", "OIT_SLOT_BUFFER", slots);
  text.InsertRepeated("LoadSlots", "OIT_LOAD_SLOT", slots);
  text.InsertRepeated("StoreSlots", "OIT_STORE_SLOT", slots);
  const bool inPlace = vtkOITPeelState::CanWorkInPlace(frame);
  if (this->Gather.SetStage(text) || this->InPlace != inPlace)
  {
    this->Release();
    this->InPlace = inPlace;
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
vtkOITFailure vtkOITMultiLayerPeeler::Begin(const vtkOITPeelContext& context)
{
  this->DrawNumbers.clear();
  return this->Slots.Reserve(context.Frame.Window, context.State.GetWidth(),
    context.State.GetHeight(), this->GetNumberOfSlots(), GL_RGBA32UI);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITMultiLayerPeeler::RenderGeometry(const vtkOITPeelContext& context)
{
  this->Draws.clear();
  return context.RenderGeometry();
}

//------------------------------------------------------------------------------
// The paper's scheme. Fragments of a pixel that overlap in time may overwrite each other's layers,
// but each pass makes at least one more layer right, so it ends when a pass changes nothing.
vtkOITFailure vtkOITMultiLayerPeeler::GatherUnordered(const vtkOITPeelContext& context)
{
  context.Frame.GLState->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const int passes = this->IsRest ? 1 : this->NumberOfLayers + 2;
  for (int pass = 0; pass < passes; ++pass)
  {
    this->Changes.StartRow(context.Frame.Window);
    this->Changes.Begin(0);
    vtkOITFailure failure = this->RenderGeometry(context);
    this->Changes.End();
    if (failure || this->Changes.GetResult(0) == 0)
    {
      return failure;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITMultiLayerPeeler::Peel(const vtkOITPeelContext& context, int)
{
  vtkOpenGLState* gl = context.Frame.GLState;
  const bool isRest = this->IsRest;
  const bool hasPairs = this->HasPairs();
  const bool hasIdentities = !hasPairs && !this->LastOnTop;
  const int slots = this->Slots.GetNumberOfLayers();
  const auto clear = [=]
  {
    constexpr GLuint noDepth = OIT_EMPTY;
    const GLuint empty[4] = { noDepth, hasIdentities ? 0xffffffff : 0, hasPairs ? noDepth : 0, 0 };
    const GLuint zero[4] = { 0, 0, 0, 0 };
    for (int i = 0; i < slots; ++i)
    {
      glClearBufferuiv(GL_COLOR, i, isRest ? zero : empty);
    }
  };
  if (vtkOITFailure failure =
        context.State.BindForGather(this->GatherFramebuffer, this->Slots.GetAllLayers(), clear))
  {
    return failure;
  }
  gl->vtkglDisable(GL_BLEND);
  vtkOITFailure failure;
  switch (this->UsedAccess)
  {
    case Access::Fetch:
      failure = this->RenderGeometry(context);
      break;
    case Access::Interlock:
      // Images instead of colours; the depth test is the same. VTK checks the draw buffer.
      failure = context.State.BindForGather(this->ImageFramebuffer, {}, [] {});
      if (failure)
      {
        break;
      }
      glBindImageTexture(OIT_IMAGE_SLOTS, this->Slots.GetLayer(0).Texture, 0, GL_TRUE, 0,
        GL_READ_WRITE, GL_RGBA32UI);
      glMemoryBarrier(GL_ALL_BARRIER_BITS);
      failure = this->RenderGeometry(context);
      glMemoryBarrier(GL_ALL_BARRIER_BITS);
      break;
    case Access::Barrier:
      failure = this->GatherUnordered(context);
      break;
  }
  if (failure)
  {
    return failure;
  }
  return context.State.Resolve(
    this->ResolveStage,
    [&]
    {
      vtkOITShaderText text({ vtkOITMultiLayerResolveFS });
      text.Require({ "GL_ARB_shader_bit_encoding" }).Define("OIT_RESOLVE");
      this->AddVariant(text);
      text.Insert("Slots", std::string(vtkOITHalfFS) + vtkOITMultiLayerSlotsFS);
      text.InsertRepeated("LoadSlots", "OIT_LOAD_SLOT", slots);
      return text;
    },
    [&](vtkShaderProgram* program)
    {
      this->Slots.Bind(gl, OIT_UNIT_GATHERED);
      program->SetUniformi("oitSlots", OIT_UNIT_GATHERED);
      program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
    });
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::AddVariant(vtkOITShaderText& text) const
{
  text.Define("OIT_FETCH", this->UsedAccess == Access::Fetch);
  text.Define("OIT_INTERLOCK", this->UsedAccess == Access::Interlock);
  text.Define("OIT_BARRIER", this->UsedAccess == Access::Barrier);
  text.Define("OIT_PAIRS", this->HasPairs());
  text.Define("OIT_LAST_ON_TOP", this->LastOnTop);
  text.Define("OIT_SLOTS", this->GetNumberOfSlots());
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::SetUniforms(
  vtkShaderProgram* program, vtkProp* prop, const vtkOITPeelContext& context)
{
  context.State.BindFor(program);
  context.State.SetDepthTest(program, this->UsedAccess == Access::Interlock);
  program->SetUniformi("oitRest", this->IsRest ? 1 : 0);
  const int next = static_cast<int>(this->DrawNumbers.size());
  const auto number = this->DrawNumbers.emplace(std::make_pair(prop, this->Draws[prop]++), next);
  program->SetUniformi("oitDrawNumber", number.first->second);
  if (this->UsedAccess == Access::Barrier)
  {
    this->Slots.Bind(context.Frame.GLState, OIT_UNIT_GATHERED);
    program->SetUniformi("oitSlots", OIT_UNIT_GATHERED);
    glTextureBarrier(); // what the last draw has written
  }
}

//------------------------------------------------------------------------------
void vtkOITMultiLayerPeeler::Release()
{
  this->Slots.Release();
  this->GatherFramebuffer.Release();
  this->ImageFramebuffer.Release();
  this->ResolveStage.Release();
  this->Changes.Release();
}
