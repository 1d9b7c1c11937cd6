// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITSharedDepth.h"

#include "vtkOpenGLState.h"

//------------------------------------------------------------------------------
bool vtkOITBindWithSharedDepth(
  vtkOpenGLState* state, GLuint framebuffer, const vtkOITAttachment& color)
{
  const auto get = [](GLenum attachment, GLenum name)
  {
    GLint value = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
    return value;
  };
  constexpr GLenum depth = GL_DEPTH_ATTACHMENT;
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  const GLint type = bound ? get(depth, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) : GL_NONE;
  if (type != GL_TEXTURE && type != GL_RENDERBUFFER)
  {
    return false;
  }
  const auto name = static_cast<GLuint>(get(depth, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  const GLint level = type == GL_TEXTURE ? get(depth, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL) : 0;
  // With its stencil, if it has one, so that it can be asked for its format and copied.
  const GLenum stencil = GL_STENCIL_ATTACHMENT;
  const bool hasStencil = get(stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == type &&
    static_cast<GLuint>(get(stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)) == name;
  const GLenum point = hasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : depth;

  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  vtkOITAttachTo(GL_COLOR_ATTACHMENT0, color);
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
  if (type == GL_TEXTURE)
  {
    glFramebufferTexture(GL_DRAW_FRAMEBUFFER, point, name, level);
  }
  else
  {
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
  }
  vtkOITFramebuffer::DrawInto(1);
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
  {
    return true;
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, bound);
  return false;
}
