// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Frame/vtkOITFrame.h"

#include "Private/Frame/vtkOITCompatibility.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <utility>

namespace
{
GLint GetAttachment(GLenum attachment, GLenum name)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
  return value;
}

bool IsAttached(GLenum attachment)
{
  return GetAttachment(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
}
}

//------------------------------------------------------------------------------
vtkOITTarget vtkOITTarget::Query()
{
  vtkOITTarget target;
  glGetIntegerv(GL_SAMPLES, &target.Samples);
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  GLint drawBuffer = GL_NONE;
  glGetIntegerv(GL_DRAW_BUFFER0, &drawBuffer);
  target.Framebuffer = static_cast<unsigned int>(framebuffer);
  target.DrawBuffer = static_cast<unsigned int>(drawBuffer);
  const bool isDefault = framebuffer == 0;
  const GLenum color = isDefault ? GL_BACK_LEFT : static_cast<GLenum>(drawBuffer);
  const GLenum depth = isDefault ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  const GLenum stencil = isDefault ? GL_STENCIL : GL_STENCIL_ATTACHMENT;

  if (color != GL_NONE && IsAttached(color))
  {
    target.CoarseColor =
      GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_UNSIGNED_NORMALIZED &&
      GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) <= 10 &&
      GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) == GL_LINEAR;
  }
  if (IsAttached(depth))
  {
    target.DepthBits = GetAttachment(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    target.FloatDepth = GetAttachment(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
  }
  if (IsAttached(stencil))
  {
    target.StencilBits = GetAttachment(stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
  }
  return target;
}

//------------------------------------------------------------------------------
vtkOITFrame::vtkOITFrame(const vtkRenderState* state, std::vector<vtkProp*> translucentProps)
  : State(state->GetRenderer())
{
  this->DrawOnly(std::move(translucentProps));
  this->State.SetFrameBuffer(state->GetFrameBuffer());
  this->State.SetRequiredKeys(state->GetRequiredKeys());
  this->Window = vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetVTKWindow());
  this->GLState = this->Window ? this->Window->GetState() : nullptr;
}

//------------------------------------------------------------------------------
void vtkOITFrame::DrawOnly(std::vector<vtkProp*> props)
{
  this->Props = std::move(props);
  this->State.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));
}

//------------------------------------------------------------------------------
void vtkOITFrame::DrawToFirstBufferOnly() const
{
  if (this->Target.Framebuffer != 0) // the default framebuffer has but one
  {
    const GLenum buffer = this->Target.DrawBuffer;
    glDrawBuffers(1, &buffer);
  }
}

//------------------------------------------------------------------------------
vtkOITRectangle vtkOITFrame::FindStorage(const vtkOITRectangle& band) const
{
  constexpr int step = 64;
  const auto extend = [](int end, int largest)
  { return std::min((end + step - 1) / step * step, largest); };
  return { 0, 0, extend(band.X + band.Width, this->Viewport.X + this->Viewport.Width),
    extend(band.Y + band.Height, this->Viewport.Y + this->Viewport.Height) };
}

//------------------------------------------------------------------------------
void vtkOITFrame::ShiftViewport(const vtkOITRectangle& band, const vtkOITRectangle& storage) const
{
  const vtkOITRectangle& viewport = this->Viewport;
  this->GLState->vtkglViewport(
    viewport.X - storage.X, viewport.Y - storage.Y, viewport.Width, viewport.Height);
  this->GLState->vtkglEnable(GL_SCISSOR_TEST);
  this->GLState->vtkglScissor(band.X - storage.X, band.Y - storage.Y, band.Width, band.Height);
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkOITFindTranslucentProps(const vtkRenderState* state)
{
  vtkProp** first = state->GetPropArray();
  std::vector<vtkProp*> props;
  std::copy_if(first, first + state->GetPropArrayCount(), std::back_inserter(props),
    [state](vtkProp* prop)
    {
      return prop->GetVisibility() && prop->HasTranslucentPolygonalGeometry() &&
        prop->HasKeys(state->GetRequiredKeys());
    });
  return props;
}
