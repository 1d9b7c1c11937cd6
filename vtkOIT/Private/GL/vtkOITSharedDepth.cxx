// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITSharedDepth.h"

#include "vtkOpenGLState.h"

namespace
{
/// What is attached to a point of the framebuffer bound for drawing.
struct Attached
{
  explicit Attached(GLenum point)
  {
    const auto get = [point](GLenum name)
    {
      GLint value = 0;
      glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, point, name, &value);
      return value;
    };
    this->Type = get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
    if (this->IsShareable())
    {
      this->Name = static_cast<GLuint>(get(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    }
    if (this->Type == GL_TEXTURE)
    {
      this->Level = get(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
    }
  }

  bool IsShareable() const { return this->Type == GL_TEXTURE || this->Type == GL_RENDERBUFFER; }
  bool IsSameAs(const Attached& other) const
  {
    return this->Type == other.Type && this->Name == other.Name;
  }
  /// Of an array, texture and all: then the framebuffer is not complete.
  void AttachTo(GLenum point) const
  {
    if (this->Type == GL_TEXTURE)
    {
      glFramebufferTexture(GL_DRAW_FRAMEBUFFER, point, this->Name, this->Level);
    }
    else
    {
      glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, point, GL_RENDERBUFFER, this->Name);
    }
  }

  GLint Type = GL_NONE;
  GLuint Name = 0;
  GLint Level = 0;
};

GLint GetBound()
{
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  return bound;
}

/// Binds `framebuffer` with the depth buffer of the one that is bound, and its stencil, if it has
/// one, so that it can be asked for its format and copied.
bool BindWithDepth(vtkOpenGLState* state, GLuint framebuffer)
{
  const Attached depth(GL_DEPTH_ATTACHMENT);
  const bool hasStencil = depth.IsSameAs(Attached(GL_STENCIL_ATTACHMENT));
  if (!depth.IsShareable())
  {
    return false;
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
  depth.AttachTo(hasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT);
  return true;
}

/// Draws into that many colours; binds `before` where that is not possible.
vtkOITFailure DrawInto(vtkOpenGLState* state, int numberOfColors, GLint before)
{
  vtkOITFramebuffer::DrawInto(numberOfColors);
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
  {
    return {};
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, before);
  return vtkOITRefuseFramebuffer();
}
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBindWithSharedDepth(
  vtkOpenGLState* state, GLuint framebuffer, const vtkOITAttachment& color)
{
  const GLint before = GetBound();
  if (before == 0 || !BindWithDepth(state, framebuffer))
  {
    return vtkOITRefuseFramebuffer();
  }
  vtkOITAttachTo(GL_COLOR_ATTACHMENT0, color);
  return DrawInto(state, 1, before);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBindBeside(
  vtkOpenGLState* state, GLuint framebuffer, const vtkOITAttachment& color)
{
  const GLint before = GetBound();
  GLint buffer = GL_NONE;
  glGetIntegerv(GL_DRAW_BUFFER0, &buffer);
  if (before == 0 || buffer == GL_NONE)
  {
    return vtkOITRefuseFramebuffer();
  }
  const Attached own(static_cast<GLenum>(buffer));
  if (!own.IsShareable() || !BindWithDepth(state, framebuffer))
  {
    return vtkOITRefuseFramebuffer();
  }
  own.AttachTo(GL_COLOR_ATTACHMENT0);
  vtkOITAttachTo(GL_COLOR_ATTACHMENT1, color);
  return DrawInto(state, 2, before);
}
