// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITDepthCopy.h"

#include "Private/Frame/vtkOITGetInteger.h"
#include "Private/GL/vtkOITAllocation.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <string>

namespace
{
/// An internal format, with format and type of (absent) pixels that it accepts.
struct DepthFormat
{
  GLenum Internal;
  GLenum Format;
  GLenum Type;
};

DepthFormat FindFormat(const vtkOITTarget& target)
{
  const bool hasStencil = target.StencilBits > 0;
  if (target.FloatDepth)
  {
    return hasStencil
      ? DepthFormat{ GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV }
      : DepthFormat{ GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT };
  }
  if (hasStencil)
  {
    return { GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8 };
  }
  const GLenum format = target.DepthBits == 16 ? GL_DEPTH_COMPONENT16
    : target.DepthBits == 24                   ? GL_DEPTH_COMPONENT24
                                               : GL_DEPTH_COMPONENT32;
  return { format, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT };
}
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDepthCopy::Allocate(
  const vtkOITFrame& frame, const vtkOITRectangle& rectangle, int unit)
{
  const int width = rectangle.Width;
  const int height = rectangle.Height;
  const DepthFormat depth = FindFormat(frame.Target);
  const GLenum format = depth.Internal;
  const bool attached = this->Attach(frame.Window);
  frame.GLState->vtkglActiveTexture(GL_TEXTURE0 + unit);
  if (attached && this->Texture && this->Format == format &&
    this->Samples == frame.Target.Samples && this->Width >= width && this->Height >= height)
  {
    glBindTexture(this->Target, this->Texture);
    return {};
  }
  this->Release();
  this->Attach(frame.Window);
  frame.GLState->vtkglActiveTexture(GL_TEXTURE0 + unit); // making the marker bound another
  this->Format = format;
  this->Samples = frame.Target.Samples;
  this->Target = this->Samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  this->Bytes = GetBytes(rectangle, frame.Target);
  this->Width = width;
  this->Height = height;
  glGenTextures(1, &this->Texture);
  this->Serial = vtkOITAttachment::MakeSerial();
  glBindTexture(this->Target, this->Texture);
  const vtkOITAllocation allocation;
  if (this->Samples > 0)
  {
    glTexImage2DMultisample(this->Target, this->Samples, format, width, height, GL_TRUE);
  }
  else
  {
    if (glTexStorage2D)
    {
      glTexStorage2D(this->Target, 1, format, width, height);
    }
    else // before OpenGL 4.2
    {
      glTexImage2D(this->Target, 0, static_cast<GLint>(format), width, height, 0, depth.Format,
        depth.Type, nullptr);
      glTexParameteri(this->Target, GL_TEXTURE_MAX_LEVEL, 0);
    }
    glTexParameteri(this->Target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(this->Target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  glGenFramebuffers(1, &this->Framebuffer);
  vtkOITFailure failure = allocation.Check(
    "a depth buffer of " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
  if (failure)
  {
    glBindTexture(this->Target, 0);
    this->Release();
  }
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDepthCopy::Copy(const vtkOITFrame& frame, const vtkOITRectangle& storage,
  const vtkOITRectangle& rectangle, int unit)
{
  if (vtkOITFailure failure = this->Allocate(frame, storage, unit))
  {
    return failure;
  }
  const GLint source = vtkOITGetInteger(GL_DRAW_FRAMEBUFFER_BINDING);
  const GLint read = vtkOITGetInteger(GL_READ_FRAMEBUFFER_BINDING);
  vtkOpenGLState* state = frame.GLState;
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, source);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER,
    frame.Target.StencilBits > 0 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, this->Target,
    this->Texture, 0);
  const bool isComplete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  // The scissor test clips what a blit writes.
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  const vtkOITRectangle& r = rectangle;
  const int x = r.X - storage.X;
  const int y = r.Y - storage.Y;
  if (isComplete)
  {
    glBlitFramebuffer(r.X, r.Y, r.X + r.Width, r.Y + r.Height, x, y, x + r.Width, y + r.Height,
      GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, source);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, read);
  return isComplete ? vtkOITFailure() : vtkOITRefuseFramebuffer();
}

//------------------------------------------------------------------------------
void vtkOITDepthCopy::BindTo(vtkOpenGLState* state, int unit, GLuint texture) const
{
  state->vtkglActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(this->Target, texture);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITDepthCopy::GetSizeInBytes() const
{
  return this->Bytes;
}

//------------------------------------------------------------------------------
std::int64_t vtkOITDepthCopy::GetBytes(const vtkOITRectangle& rectangle, const vtkOITTarget& target)
{
  const int bytes = FindFormat(target).Internal == GL_DEPTH32F_STENCIL8 ? 8 : 4;
  return rectangle.GetArea() * bytes * std::max(1, target.Samples);
}

//------------------------------------------------------------------------------
void vtkOITDepthCopy::Delete()
{
  glDeleteTextures(1, &this->Texture);
  vtkOITDeleteFramebuffer(this->GetWindow(), this->Framebuffer);
}

//------------------------------------------------------------------------------
void vtkOITDepthCopy::Forget()
{
  this->Texture = 0;
  this->Framebuffer = 0;
  this->Bytes = 0;
  this->Width = 0;
  this->Height = 0;
}
