// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Blending/vtkOITLayerTarget.h"

#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/GL/vtkOITOutput.h"
#include "Private/GL/vtkOITShaderText.h"
#include "Private/GL/vtkOITSharedDepth.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITBlendBesideFS.h"
#include "vtkOITFullScreenVS.h"
#include "vtkOITLayerCompositeFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <string>

namespace
{
/// A framebuffer of ours with the depth of the frame's target.
vtkOITTarget MakeTarget(const vtkOITFrame& frame, GLuint framebuffer, int buffers)
{
  vtkOITTarget target = frame.Target;
  target.Framebuffer = framebuffer;
  target.DrawBuffers = {};
  for (int i = 0; i < buffers; ++i)
  {
    target.DrawBuffers[i] = GL_COLOR_ATTACHMENT0 + i;
  }
  return target;
}

void BindTarget(const vtkOITFrame& frame)
{
  frame.GLState->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame.Target.Framebuffer);
}

void ClearColor()
{
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 0, nothing);
}
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITLayerTarget::Reserve(const vtkOITFrame& frame, const vtkOITRectangle& rectangle)
{
  const vtkOITRectangle storage = frame.FindStorage(rectangle);
  return this->Layer.Reserve(frame.Window, storage.Width, storage.Height, 1, GL_RGBA32F);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITLayerTarget::Begin(
  const vtkOITFrame& frame, const vtkOITRectangle& rectangle, vtkOITTarget& target)
{
  if (vtkOITFailure failure = this->Reserve(frame, rectangle))
  {
    return failure;
  }
  const GLuint framebuffer = this->Framebuffer.Make(frame.Window);
  BindTarget(frame);
  if (vtkOITFailure failure =
        vtkOITBindWithSharedDepth(frame.GLState, framebuffer, this->Layer.GetLayer(0)))
  {
    return failure;
  }
  this->Stamp = 0;
  this->Rectangle = rectangle;
  target = MakeTarget(frame, framebuffer, 1);
  target.CoarseColor = false;
  frame.On(target).BeginGeometry(rectangle);
  ClearColor();
  return {};
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITLayerTarget::BeginBeside(
  const vtkOITFrame& frame, const vtkOITRectangle& rectangle, vtkOITTarget& target)
{
  if (vtkOITFailure failure = this->Reserve(frame, rectangle))
  {
    return failure;
  }
  if (this->Layer.IsNew() || this->Stamp == 0 || this->Stamp == OIT_STAMPS)
  {
    this->ClearAll(frame);
  }
  ++this->Stamp;
  target = MakeTarget(frame, this->FramebufferBeside.Make(frame.Window), 2);
  return this->BindBeside(frame);
}

//------------------------------------------------------------------------------
// What the driver has refused is not tried again, and what its compiler would refuse not at all:
// Mesa 26.1 crashes when VTK links it all the same.
vtkOITFailure vtkOITLayerTarget::BindBeside(const vtkOITFrame& frame)
{
  if (!this->BesideWorks || frame.Target.Framebuffer == 0 ||
    !frame.Capabilities->GetMissingForPeeling().empty())
  {
    return vtkOITRefuseFramebuffer();
  }
  BindTarget(frame);
  vtkOITFailure failure = vtkOITBindBeside(
    frame.GLState, this->FramebufferBeside.Make(frame.Window), this->Layer.GetLayer(0));
  this->BesideWorks = !failure;
  return failure;
}

//------------------------------------------------------------------------------
// Outside of the rectangle, too: another frame's may be there.
void vtkOITLayerTarget::ClearAll(const vtkOITFrame& frame)
{
  vtkOpenGLState* state = frame.GLState;
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->FramebufferBeside.Make(frame.Window));
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
  vtkOITAttachTo(GL_COLOR_ATTACHMENT0, this->Layer.GetLayer(0));
  vtkOITAttachTo(GL_COLOR_ATTACHMENT1, {});
  vtkOITFramebuffer::DrawInto(1);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  ClearColor();
  this->Stamp = 0;
}

//------------------------------------------------------------------------------
void vtkOITLayerTarget::AddOutputBeside(vtkOITShaderText& text)
{
  text.Require({ "GL_ARB_explicit_attrib_location", "GL_ARB_shader_bit_encoding" });
  text.Insert("Output", vtkOITBlendBesideFS);
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
vtkOITFailure vtkOITLayerTarget::Composite(const vtkOITFrame& frame)
{
  const bool byFetch = vtkOITWritesByFetch(frame);
  const bool beside = byFetch && !this->BindBeside(frame);
  if (byFetch != this->ByFetch || beside != this->ReadsBeside)
  {
    this->CompositeStage.Release();
    this->ByFetch = byFetch;
    this->ReadsBeside = beside;
  }
  if (beside)
  {
    frame.On(MakeTarget(frame, this->FramebufferBeside.GetName(), 2))
      .BeginGeometry(this->Rectangle);
    frame.GLState->vtkglDisable(GL_DEPTH_TEST);
    frame.GLState->vtkglDisable(GL_CULL_FACE);
    WriteBeside(false);
  }
  else
  {
    frame.BeginOutput(this->Rectangle);
  }
  vtkOITSetOutputBlending(frame.GLState, byFetch);
  vtkOITFailure failure = this->CompositeStage.Render(
    frame.Window, vtkOITFullScreenVS, [this] { return this->GetCompositeShader(); },
    [this, &frame](vtkShaderProgram* program)
    {
      if (!this->ReadsBeside)
      {
        this->Layer.Bind(frame.GLState, OIT_UNIT_DEPTH);
        program->SetUniformi("oitLayer", OIT_UNIT_DEPTH);
      }
    });
  if (beside)
  {
    WriteBeside(true);
    BindTarget(frame);
  }
  else
  {
    vtkOITTextureArray::Unbind(frame.GLState, OIT_UNIT_DEPTH);
  }
  return failure;
}

//------------------------------------------------------------------------------
std::string vtkOITLayerTarget::GetCompositeShader() const
{
  vtkOITShaderText text({ vtkOITLayerCompositeFS });
  if (this->ReadsBeside)
  {
    text.Require({ "GL_ARB_explicit_attrib_location" }).Define("OIT_BESIDE");
  }
  vtkOITAddOutput(text, this->ByFetch);
  return text.GetText();
}
