// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITPeelState.h"

#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITFullScreenVS.h"
#include "vtkOITGroupFS.h"
#include "vtkOITPeelCompositeFS.h"
#include "vtkOITPeelMaskFS.h"
#include "vtkOITPeelStateFS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
/// Draws at this depth, whatever the vertex shader says.
class DrawnDepth
{
public:
  explicit DrawnDepth(double depth)
  {
    glGetDoublev(GL_DEPTH_RANGE, this->Range.data());
    glDepthRange(depth, depth);
  }
  ~DrawnDepth() { glDepthRange(this->Range[0], this->Range[1]); }
  DrawnDepth(const DrawnDepth&) = delete;
  DrawnDepth& operator=(const DrawnDepth&) = delete;

private:
  std::array<double, 2> Range{};
};
}

//------------------------------------------------------------------------------
bool vtkOITPeelState::CanWorkInPlace(const vtkOITFrame& frame)
{
  return CanWorkInPlace(*frame.Capabilities);
}

//------------------------------------------------------------------------------
bool vtkOITPeelState::CanWorkInPlace(const vtkOITCapabilities& capabilities)
{
  return capabilities.FramebufferFetch && capabilities.EarlyFragmentTests;
}

//------------------------------------------------------------------------------
int vtkOITPeelState::GetBytesPerPixel(const vtkOITFrame& frame, const Layout& layout)
{
  const int state = layout.Layers * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F);
  const int depthCopy = static_cast<int>(vtkOITDepthCopy::GetBytes({ 0, 0, 1, 1 }, frame.Target));
  return state * (CanWorkInPlace(frame) ? 1 : 2) + depthCopy +
    vtkOITTextureArray::GetBytesPerTexel(GL_DEPTH_COMPONENT32F);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelState::Begin(const vtkOITFrame& frame, const vtkOITRectangle& band,
  const vtkOITRectangle& storage, const Layout& layout, double transmittanceThreshold,
  bool countsPixels)
{
  this->Frame = &frame;
  this->Band = band;
  this->Storage = storage;
  if (layout.HasBack != this->TheLayout.HasBack)
  {
    this->CompositeStage.Release();
  }
  this->TheLayout = layout;
  this->TransmittanceThreshold = transmittanceThreshold;
  this->InPlace = CanWorkInPlace(frame);
  this->HasMask = false;
  this->IsReduced = false;
  this->Current = 0;
  this->Region.Begin(
    frame, { band.X - storage.X, band.Y - storage.Y, band.Width, band.Height }, countsPixels);

  vtkOpenGLRenderWindow* window = frame.Window;
  for (int i = 0; i < (this->InPlace ? 1 : 2); ++i)
  {
    if (vtkOITFailure failure =
          this->Arrays[i].Reserve(window, storage.Width, storage.Height, layout.Layers, GL_RGBA32F))
    {
      return failure;
    }
  }
  if (vtkOITFailure failure =
        this->MaskDepth.Reserve(window, storage.Width, storage.Height, 1, GL_DEPTH_COMPONENT32F))
  {
    return failure;
  }
  frame.BeginGeometry(band);
  if (frame.Target.DepthBits > 0)
  {
    if (vtkOITFailure failure = this->OpaqueDepth.Copy(frame, storage, band, OIT_UNIT_GATHERED))
    {
      return failure;
    }
    this->OpaqueDepth.Unbind(frame.GLState, OIT_UNIT_GATHERED);
  }
  frame.BeginStorage(band, storage);
  if (vtkOITFailure failure = this->StateFramebuffers[0].Bind(
        window, this->Arrays[0].GetAllLayers(), this->MaskDepth.GetLayer(0)))
  {
    return failure;
  }
  for (int layer = 0; layer < layout.Layers; ++layer)
  {
    if (layout.StartsInResolve && layer != OIT_STATE_STATISTICS)
    {
      continue;
    }
    std::array<float, 4> value{};
    if (layer == OIT_STATE_FRONT || (layout.HasBack && layer == OIT_STATE_BACK))
    {
      value[3] = 1.0f; // transmittance
    }
    else if (layer == OIT_STATE_BOUNDS)
    {
      value = { -1.0f, 2.0f, -2.0f, -2.0f };
    }
    glClearBufferfv(GL_COLOR, layer, value.data());
  }
  return {};
}

//------------------------------------------------------------------------------
// Not in place, the state of all pixels goes into another array.
void vtkOITPeelState::SetScissorOfResolve() const
{
  if (this->InPlace)
  {
    this->Region.SetScissor();
    return;
  }
  this->Frame->GLState->vtkglScissor(this->Band.X - this->Storage.X, this->Band.Y - this->Storage.Y,
    this->Band.Width, this->Band.Height);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelState::BindForGather(vtkOITFramebuffer& framebuffer,
  const std::vector<vtkOITAttachment>& colors, const std::function<void()>& clear)
{
  vtkOpenGLState* state = this->Frame->GLState;
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  vtkOITAttachment depth;
  if (this->HasMask)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(this->Side == MaskSide::Front ? GL_GEQUAL : GL_LEQUAL);
    depth = this->MaskDepth.GetLayer(0);
  }
  else
  {
    state->SetEnumState(GL_DEPTH_TEST, this->Frame->Target.TestsDepth);
    state->vtkglDepthFunc(this->Frame->Target.DepthFunction);
    if (this->Frame->Target.DepthBits > 0)
    {
      depth = this->OpaqueDepth.GetAttachment();
    }
  }
  if (vtkOITFailure failure = framebuffer.Bind(this->Frame->Window, colors, depth))
  {
    return failure;
  }
  this->SetScissorOfResolve();
  clear();
  this->Region.SetScissor();
  return {};
}

//------------------------------------------------------------------------------
void vtkOITPeelState::AddResolve(vtkOITShaderText& text) const
{
  text.Require({ "GL_ARB_explicit_attrib_location" });
  if (this->InPlace)
  {
    text.Require({ "GL_EXT_shader_framebuffer_fetch", "GL_ARB_shader_image_load_store" });
    text.Define("OIT_IN_PLACE").TestDepthEarly();
  }
  text.Insert("State", vtkOITPeelStateFS).Insert("Group", vtkOITGroupFS);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelState::Resolve(vtkOITScreenStage& stage,
  const std::function<vtkOITShaderText()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  vtkOpenGLState* state = this->Frame->GLState;
  const vtkOITTextureArray& previous = this->Arrays[this->Current];
  if (!this->InPlace)
  {
    this->Current = 1 - this->Current;
  }
  if (vtkOITFailure failure = this->StateFramebuffers[this->Current].Bind(this->Frame->Window,
        this->Arrays[this->Current].GetAllLayers(), this->MaskDepth.GetLayer(0)))
  {
    return failure;
  }
  // Props leave the masks as they like, vtkImageActor that of depth on: the Mask would be drawn over.
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  const bool isFront = this->Side == MaskSide::Front;
  // Finished pixels have the depth that nothing passes. Not in place, they have to be copied.
  const bool skipsFinished = this->InPlace && this->HasMask;
  if (skipsFinished)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(isFront ? GL_GREATER : GL_LESS);
  }
  else
  {
    state->vtkglDisable(GL_DEPTH_TEST);
  }
  const DrawnDepth depth(isFront ? 1.0 : 0.0);
  this->SetScissorOfResolve();
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  vtkOITFailure failure = stage.Render(
    this->Frame->Window, vtkOITFullScreenVS,
    [&]
    {
      vtkOITShaderText text = getFragmentShader();
      this->AddResolve(text);
      return text.GetText();
    },
    [&](vtkShaderProgram* program)
    {
      if (program->IsUniformUsed("oitState"))
      {
        previous.Bind(state, OIT_UNIT_STATE);
        program->SetUniformi("oitState", OIT_UNIT_STATE);
      }
      program->SetUniformf(
        "oitTransmittanceThreshold", static_cast<float>(this->TransmittanceThreshold));
      program->SetUniformi("oitFirstResolve", this->HasMask ? 0 : 1);
      setUniforms(program);
    });
  state->vtkglDepthFunc(GL_LEQUAL);
  return failure;
}

//------------------------------------------------------------------------------
// Where as many layers are peeled from both sides these take turns, so that props which are peeled from the
// front and props which are peeled from the back are both found out.
vtkOITFailure vtkOITPeelState::Mask(std::size_t peel)
{
  vtkOpenGLState* state = this->Frame->GLState;
  const bool isFront = !this->TheLayout.HasBack || !this->TheLayout.MasksBack || peel % 2 != 0;
  this->Side = isFront ? MaskSide::Front : MaskSide::Back;
  if (vtkOITFailure failure =
        this->MaskFramebuffer.Bind(this->Frame->Window, {}, this->MaskDepth.GetLayer(0)))
  {
    return failure;
  }
  state->vtkglDepthMask(GL_TRUE);
  this->Region.SetScissor();
  const float finished = isFront ? 1.0f : 0.0f;
  glClearBufferfv(GL_DEPTH, 0, &finished);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  vtkOITFailure failure = this->MaskStages[isFront ? 0 : 1].Render(
    this->Frame->Window, vtkOITFullScreenVS,
    [isFront]
    { return vtkOITShaderText({ vtkOITPeelMaskFS }).Define("OIT_MASK_FRONT", isFront).GetText(); },
    [this](vtkShaderProgram* program) { this->BindFor(program); },
    [this, peel](const std::function<void()>& draw) { this->Region.Count(peel, draw); });
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LEQUAL);
  this->HasMask = true;
  return failure;
}

//------------------------------------------------------------------------------
void vtkOITPeelState::BindFor(vtkShaderProgram* program) const
{
  this->Arrays[this->Current].Bind(this->Frame->GLState, OIT_UNIT_STATE);
  program->SetUniformi("oitState", OIT_UNIT_STATE);
}

//------------------------------------------------------------------------------
void vtkOITPeelState::SetDepthTest(vtkShaderProgram* program, bool always) const
{
  const vtkOITTarget& target = this->Frame->Target;
  const bool testsDepth = target.TestsDepth && target.DepthBits > 0;
  if (testsDepth && (this->HasMask || always))
  {
    this->OpaqueDepth.Bind(this->Frame->GLState, OIT_UNIT_DEPTH);
  }
  program->SetUniformi("oitTestsDepth", testsDepth ? (this->HasMask ? 2 : 1) : 0);
  program->SetUniformi("oitOpaqueDepth", OIT_UNIT_DEPTH);
  program->SetUniformi("oitDepthBits", target.GetFixedDepthBits());
  program->SetUniformi("oitDepthFunction", target.GetDepthRelations());
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelState::Composite()
{
  return this->Composite(
    this->CompositeStage,
    [this]
    {
      return vtkOITShaderText({ vtkOITPeelCompositeFS })
        .Define("OIT_HAS_BACK", this->TheLayout.HasBack);
    },
    [this](vtkShaderProgram* program) { this->BindFor(program); });
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelState::Composite(vtkOITOutputStage& stage,
  const std::function<vtkOITShaderText()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  return stage.Render(*this->Frame, getFragmentShader,
    [&](vtkShaderProgram* program)
    {
      const int origin[2] = { this->Storage.X, this->Storage.Y };
      program->SetUniform2i("oitOrigin", origin);
      setUniforms(program);
    });
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelState::IsFirstPeelComplete(bool& isComplete)
{
  vtkOITFailure failure = this->Reduce(this->Reduced);
  isComplete = !failure && this->Reduced.Lost == 0;
  this->Frame->BeginStorage(this->Band, this->Storage);
  this->IsReduced = isComplete;
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPeelState::Reduce(vtkOITPixelStatistics::Result& result)
{
  vtkOITTextureArray::Unbind(this->Frame->GLState, OIT_UNIT_GATHERED);
  this->OpaqueDepth.Unbind(this->Frame->GLState, OIT_UNIT_DEPTH);
  if (this->IsReduced)
  {
    result = this->Reduced;
    return {};
  }
  return this->Statistics.Reduce(*this->Frame, this->Arrays[this->Current],
    { this->Band.X - this->Storage.X, this->Band.Y - this->Storage.Y, this->Band.Width,
      this->Band.Height },
    result);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITPeelState::GetSizeInBytes() const
{
  return this->Arrays[0].GetSizeInBytes() + this->Arrays[1].GetSizeInBytes() +
    this->MaskDepth.GetSizeInBytes() + this->Statistics.GetSizeInBytes() +
    this->OpaqueDepth.GetSizeInBytes();
}

//------------------------------------------------------------------------------
void vtkOITPeelState::Release()
{
  for (int i = 0; i < 2; ++i)
  {
    this->Arrays[i].Release();
    this->StateFramebuffers[i].Release();
  }
  this->Region.Release();
  this->MaskDepth.Release();
  this->Statistics.Release();
  this->OpaqueDepth.Release();
  this->MaskFramebuffer.Release();
  this->MaskStages[0].Release();
  this->MaskStages[1].Release();
  this->CompositeStage.Release();
}
