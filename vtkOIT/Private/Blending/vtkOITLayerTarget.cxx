// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Blending/vtkOITLayerTarget.h"

#include "Private/GL/vtkOITOutput.h"
#include "Private/GL/vtkOITSavedState.h"
#include "Private/GL/vtkOITShaderText.h"
#include "Private/GL/vtkOITSharedDepth.h"

#include "vtkOITFullScreenVS.h"
#include "vtkOITLayerCompositeFS.h"
#include "vtkOITOutputFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <string>

namespace
{
// Mappers count their units up from 0 and GL has at least 16.
constexpr int Unit = 15;

/// How many frames are told apart: bits of an alpha, all ones.
constexpr int Stamps = 255;
}

//------------------------------------------------------------------------------
bool vtkOITLayerTarget::Begin(vtkOITFrame& frame, const vtkOITRectangle& rectangle)
{
  vtkOpenGLState* state = frame.GLState;
  const vtkOITRectangle storage = frame.FindStorage(rectangle);
  this->Layer.Reserve(frame.Window, storage.Width, storage.Height, 1, GL_RGBA32F);
  if (!vtkOITBindWithSharedDepth(
        state, this->Framebuffer.Make(frame.Window), this->Layer.GetLayer(0)))
  {
    return false;
  }
  this->Stamp = 0;
  this->Rectangle = rectangle;
  this->TargetBefore = frame.Target;
  frame.Target = vtkOITTarget::Query();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(rectangle.X, rectangle.Y, rectangle.Width, rectangle.Height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
  return true;
}

//------------------------------------------------------------------------------
bool vtkOITLayerTarget::BeginBeside(const vtkOITFrame& frame, const vtkOITRectangle& rectangle)
{
  if (!this->CanBindBeside(frame))
  {
    return false;
  }
  const vtkOITRectangle storage = frame.FindStorage(rectangle);
  const bool isKept =
    this->Layer.Reserve(frame.Window, storage.Width, storage.Height, 1, GL_RGBA32F);
  if (!isKept || this->Stamp == 0 || this->Stamp == Stamps)
  {
    this->ClearAll(frame);
  }
  ++this->Stamp;
  this->TargetBefore = frame.Target;
  return this->BindBeside(frame);
}

//------------------------------------------------------------------------------
// What the driver has refused is not tried again.
bool vtkOITLayerTarget::CanBindBeside(const vtkOITFrame& frame) const
{
  return this->BesideWorks && frame.Target.Framebuffer != 0;
}

//------------------------------------------------------------------------------
bool vtkOITLayerTarget::BindBeside(const vtkOITFrame& frame)
{
  if (!this->CanBindBeside(frame))
  {
    return false;
  }
  this->BesideWorks = vtkOITBindBeside(
    frame.GLState, this->FramebufferBeside.Make(frame.Window), this->Layer.GetLayer(0));
  return this->BesideWorks;
}

//------------------------------------------------------------------------------
// Outside of the rectangle, too: another frame's may be there.
void vtkOITLayerTarget::ClearAll(const vtkOITFrame& frame)
{
  vtkOpenGLState* state = frame.GLState;
  const vtkOITSavedState saved(state, false);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->FramebufferBeside.Make(frame.Window));
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
  vtkOITAttachTo(GL_COLOR_ATTACHMENT0, this->Layer.GetLayer(0));
  vtkOITAttachTo(GL_COLOR_ATTACHMENT1, {});
  vtkOITFramebuffer::DrawInto(1);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
  this->Stamp = 0;
}

//------------------------------------------------------------------------------
std::string vtkOITLayerTarget::GetHeaderBeside()
{
  return vtkOITRequireExtensions(
           { "GL_ARB_explicit_attrib_location", "GL_ARB_shader_bit_encoding" }) +
    "#define OIT_STAMPS " + std::to_string(Stamps) + "\n";
}

//------------------------------------------------------------------------------
void vtkOITLayerTarget::SetUniformsBeside(vtkShaderProgram* program) const
{
  program->SetUniformi("oitStamp", this->Stamp);
}

//------------------------------------------------------------------------------
// vtkOpenGLState knows of one mask for all buffers, and not of this.
void vtkOITLayerTarget::WriteBeside(bool writes)
{
  const GLboolean mask = writes ? GL_TRUE : GL_FALSE;
  glColorMaski(1, mask, mask, mask, mask);
}

//------------------------------------------------------------------------------
void vtkOITLayerTarget::End(vtkOITFrame& frame)
{
  frame.Target = this->TargetBefore;
  frame.GLState->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame.Target.Framebuffer);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITLayerTarget::GetBytes(const vtkOITFrame& frame, const vtkOITRectangle& rectangle)
{
  return frame.FindStorage(rectangle).GetArea() * vtkOITTextureArray::GetBytesPerTexel(GL_RGBA32F);
}

//------------------------------------------------------------------------------
void vtkOITLayerTarget::Release()
{
  this->Layer.Release();
  this->Framebuffer.Release();
  this->FramebufferBeside.Release();
  this->Stamp = 0;
  this->BesideWorks = true;
  this->CompositeStage.Release();
}

//------------------------------------------------------------------------------
void vtkOITLayerTarget::Composite(const vtkOITFrame& frame)
{
  const bool byFetch = vtkOITWritesByFetch(frame);
  const bool beside = byFetch && this->BindBeside(frame);
  if (byFetch != this->ByFetch || beside != this->ReadsBeside)
  {
    this->CompositeStage.Release();
    this->ByFetch = byFetch;
    this->ReadsBeside = beside;
  }
  vtkOpenGLState* state = frame.GLState;
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(
    this->Rectangle.X, this->Rectangle.Y, this->Rectangle.Width, this->Rectangle.Height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  vtkOITSetOutputBlending(state, byFetch);
  if (beside)
  {
    WriteBeside(false);
  }
  else
  {
    frame.DrawToFirstBufferOnly();
  }
  this->CompositeStage.Render(
    frame.Window, vtkOITFullScreenVS, [this] { return this->GetCompositeShader(); },
    [this, state](vtkShaderProgram* program)
    {
      if (!this->ReadsBeside)
      {
        this->Layer.Bind(state, Unit);
        program->SetUniformi("oitLayer", Unit);
      }
    });
  if (beside)
  {
    WriteBeside(true);
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame.Target.Framebuffer);
  }
  else
  {
    vtkOITTextureArray::Unbind(state, Unit);
  }
}

//------------------------------------------------------------------------------
std::string vtkOITLayerTarget::GetCompositeShader() const
{
  std::string header = vtkOITGetOutputHeader(this->ByFetch);
  if (this->ReadsBeside)
  {
    header = vtkOITRequireExtensions({ "GL_ARB_explicit_attrib_location" }) + header +
      "#define OIT_BESIDE\n";
  }
  std::string text = vtkOITLayerCompositeFS;
  vtkOITReplace(text, "//VTK::System::Dec", "//VTK::System::Dec\n" + header);
  vtkOITReplace(text, "//VTK::OIT::Output", vtkOITOutputFS);
  return text;
}
