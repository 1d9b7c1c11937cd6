// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Peeling/vtkOITPeelState.h"

#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITShaderText.h"

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
  return frame.Capabilities->FramebufferFetch && frame.Capabilities->EarlyFragmentTests;
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
void vtkOITPeelState::Begin(const vtkOITFrame& frame, const vtkOITRectangle& band,
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
  this->TestsDepth = glIsEnabled(GL_DEPTH_TEST) == GL_TRUE;
  glGetIntegerv(GL_DEPTH_FUNC, &this->DepthFunction);
  this->HasMask = false;
  this->IsReduced = false;
  this->Current = 0;
  this->Region.Begin(
    frame, { band.X - storage.X, band.Y - storage.Y, band.Width, band.Height }, countsPixels);

  vtkOpenGLRenderWindow* window = frame.Window;
  for (int i = 0; i < (this->InPlace ? 1 : 2); ++i)
  {
    this->Arrays[i].Reserve(window, storage.Width, storage.Height, layout.Layers, GL_RGBA32F);
  }
  this->MaskDepth.Reserve(window, storage.Width, storage.Height, 1, GL_DEPTH_COMPONENT32F);
  if (frame.Target.DepthBits > 0)
  {
    this->OpaqueDepth.Copy(frame, storage, band, GatheredUnit);
    this->OpaqueDepth.Unbind(frame.GLState, GatheredUnit);
  }

  vtkOpenGLState* state = frame.GLState;
  frame.ShiftViewport(band, storage);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_FALSE);
  this->StateFramebuffers[0].Bind(
    window, this->Arrays[0].GetAllLayers(), this->MaskDepth.GetLayer(0));
  for (int layer = 0; layer < layout.Layers; ++layer)
  {
    if (layout.StartsInResolve && layer != 1)
    {
      continue;
    }
    std::array<float, 4> value{};
    if (layer == 0 || (layout.HasBack && layer == 3))
    {
      value[3] = 1.0f; // transmittance
    }
    else if (layer == 2)
    {
      value = { -1.0f, 2.0f, -2.0f, -2.0f };
    }
    glClearBufferfv(GL_COLOR, layer, value.data());
  }
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
bool vtkOITPeelState::BindForGather(vtkOITFramebuffer& framebuffer,
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
    if (this->TestsDepth)
    {
      state->vtkglEnable(GL_DEPTH_TEST);
    }
    else
    {
      state->vtkglDisable(GL_DEPTH_TEST);
    }
    state->vtkglDepthFunc(this->DepthFunction);
    if (this->Frame->Target.DepthBits > 0)
    {
      depth = this->OpaqueDepth.GetAttachment();
    }
  }
  const bool isComplete = framebuffer.Bind(this->Frame->Window, colors, depth);
  this->SetScissorOfResolve();
  clear();
  this->Region.SetScissor();
  return isComplete;
}

//------------------------------------------------------------------------------
std::string vtkOITPeelState::AssembleResolve(
  const char* stage, const std::string& definitions) const
{
  std::string header = vtkOITRequireExtensions({ "GL_ARB_explicit_attrib_location" }) + definitions;
  if (this->InPlace)
  {
    header = vtkOITRequireExtensions(
               { "GL_EXT_shader_framebuffer_fetch", "GL_ARB_shader_image_load_store" }) +
      header + "#define OIT_IN_PLACE\nlayout(early_fragment_tests) in;\n";
  }
  std::string text = stage;
  vtkOITReplace(text, "//VTK::System::Dec", "//VTK::System::Dec\n" + header);
  vtkOITReplace(text, "//VTK::OIT::State", vtkOITPeelStateFS);
  vtkOITReplace(text, "//VTK::OIT::Group", vtkOITGroupFS);
  return text;
}

//------------------------------------------------------------------------------
void vtkOITPeelState::Resolve(vtkOITScreenStage& stage,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  vtkOpenGLState* state = this->Frame->GLState;
  const vtkOITTextureArray& previous = this->Arrays[this->Current];
  if (!this->InPlace)
  {
    this->Current = 1 - this->Current;
  }
  this->StateFramebuffers[this->Current].Bind(
    this->Frame->Window, this->Arrays[this->Current].GetAllLayers(), this->MaskDepth.GetLayer(0));
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
  stage.Render(this->Frame->Window, vtkOITFullScreenVS, getFragmentShader,
    [&](vtkShaderProgram* program)
    {
      if (program->IsUniformUsed("oitState"))
      {
        previous.Bind(state, StateUnit);
        program->SetUniformi("oitState", StateUnit);
      }
      program->SetUniformf(
        "oitTransmittanceThreshold", static_cast<float>(this->TransmittanceThreshold));
      setUniforms(program);
    });
  state->vtkglDepthFunc(GL_LEQUAL);
}

//------------------------------------------------------------------------------
// Where layers are peeled from both sides these take turns, so that props which are peeled from the
// front and props which are peeled from the back are both found out.
void vtkOITPeelState::Mask(std::size_t peel)
{
  vtkOpenGLState* state = this->Frame->GLState;
  const bool isFront = !this->TheLayout.HasBack || peel % 2 != 0;
  this->Side = isFront ? MaskSide::Front : MaskSide::Back;
  this->MaskFramebuffer.Bind(this->Frame->Window, {}, this->MaskDepth.GetLayer(0));
  state->vtkglDepthMask(GL_TRUE);
  this->Region.SetScissor();
  const float finished = isFront ? 1.0f : 0.0f;
  glClearBufferfv(GL_DEPTH, 0, &finished);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  this->MaskStages[isFront ? 0 : 1].Render(
    this->Frame->Window, vtkOITFullScreenVS,
    [isFront]
    {
      std::string text = vtkOITPeelMaskFS;
      vtkOITReplace(text, "//VTK::System::Dec",
        std::string("//VTK::System::Dec\n") + (isFront ? "#define OIT_MASK_FRONT\n" : ""));
      return text;
    },
    [this](vtkShaderProgram* program) { this->BindFor(program); },
    [this, peel](const std::function<void()>& draw) { this->Region.Count(peel, draw); });
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LEQUAL);
  this->HasMask = true;
}

//------------------------------------------------------------------------------
void vtkOITPeelState::BindFor(vtkShaderProgram* program) const
{
  this->Arrays[this->Current].Bind(this->Frame->GLState, StateUnit);
  program->SetUniformi("oitState", StateUnit);
}

//------------------------------------------------------------------------------
void vtkOITPeelState::SetDepthTest(vtkShaderProgram* program) const
{
  const vtkOITTarget& target = this->Frame->Target;
  const bool testsDepth = this->HasMask && this->TestsDepth && target.DepthBits > 0;
  if (testsDepth)
  {
    this->OpaqueDepth.Bind(this->Frame->GLState, OpaqueUnit);
  }
  program->SetUniformi("oitTestsDepth", testsDepth ? 1 : 0);
  program->SetUniformi("oitOpaqueDepth", OpaqueUnit);
  program->SetUniformi(
    "oitDepthBits", !target.FloatDepth && target.DepthBits <= 24 ? target.DepthBits : 0);
}

//------------------------------------------------------------------------------
void vtkOITPeelState::Composite()
{
  this->Composite(
    this->CompositeStage,
    [this]
    {
      std::string text = vtkOITPeelCompositeFS;
      if (this->TheLayout.HasBack)
      {
        vtkOITReplace(text, "//VTK::System::Dec", "//VTK::System::Dec\n#define OIT_BACK 3\n");
      }
      return text;
    },
    [this](vtkShaderProgram* program) { this->BindFor(program); });
}

//------------------------------------------------------------------------------
void vtkOITPeelState::Composite(vtkOITOutputStage& stage,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  stage.Render(*this->Frame, getFragmentShader,
    [&](vtkShaderProgram* program)
    {
      const int origin[2] = { this->Storage.X, this->Storage.Y };
      program->SetUniform2i("oitOrigin", origin);
      setUniforms(program);
    });
}

//------------------------------------------------------------------------------
bool vtkOITPeelState::IsFirstPeelComplete()
{
  vtkOpenGLState::ScopedglEnableDisable cull(this->Frame->GLState, GL_CULL_FACE);
  const bool isComplete = this->Reduce().Lost == 0;
  this->Frame->ShiftViewport(this->Band, this->Storage);
  this->IsReduced = isComplete;
  return isComplete;
}

//------------------------------------------------------------------------------
vtkOITPixelStatistics::Result vtkOITPeelState::Reduce()
{
  vtkOITTextureArray::Unbind(this->Frame->GLState, GatheredUnit);
  this->OpaqueDepth.Unbind(this->Frame->GLState, OpaqueUnit);
  if (!this->IsReduced)
  {
    this->Reduced = this->Statistics.Reduce(*this->Frame, this->Arrays[this->Current],
      { this->Band.X - this->Storage.X, this->Band.Y - this->Storage.Y, this->Band.Width,
        this->Band.Height });
  }
  return this->Reduced;
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
