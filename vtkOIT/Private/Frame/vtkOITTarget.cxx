// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Frame/vtkOITTarget.h"

#include "Private/Frame/vtkOITGetInteger.h"

#include <algorithm>

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
  target.Samples = vtkOITGetInteger(GL_SAMPLES);
  target.Framebuffer = static_cast<unsigned int>(vtkOITGetInteger(GL_DRAW_FRAMEBUFFER_BINDING));
  target.NumberOfDrawBuffers =
    std::min(vtkOITGetInteger(GL_MAX_DRAW_BUFFERS), static_cast<GLint>(target.DrawBuffers.size()));
  for (int i = 0; i < target.NumberOfDrawBuffers; ++i)
  {
    target.DrawBuffers[i] = static_cast<unsigned int>(vtkOITGetInteger(GL_DRAW_BUFFER0 + i));
  }
  target.TestsDepth = glIsEnabled(GL_DEPTH_TEST) == GL_TRUE;
  target.DepthFunction = static_cast<unsigned int>(vtkOITGetInteger(GL_DEPTH_FUNC));
  target.CullsFaces = glIsEnabled(GL_CULL_FACE) == GL_TRUE;

  const bool isDefault = target.Framebuffer == 0;
  const GLenum color = isDefault ? GL_BACK_LEFT : target.DrawBuffers[0];
  const GLenum depth = isDefault ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  const GLenum stencil = isDefault ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
  if (color != GL_NONE && IsAttached(color))
  {
    target.ClampsColor =
      GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_UNSIGNED_NORMALIZED;
    target.CoarseColor = target.ClampsColor &&
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
// The functions are numbered so.
int vtkOITTarget::GetDepthRelations() const
{
  return static_cast<int>(this->DepthFunction - GL_NEVER);
}

//------------------------------------------------------------------------------
// The default framebuffer has but one buffer.
void vtkOITTarget::DrawToFirstBuffer() const
{
  if (this->Framebuffer != 0)
  {
    glDrawBuffers(1, this->DrawBuffers.data());
  }
}

//------------------------------------------------------------------------------
void vtkOITTarget::DrawToAllBuffers() const
{
  if (this->Framebuffer != 0)
  {
    glDrawBuffers(this->NumberOfDrawBuffers, this->DrawBuffers.data());
  }
}
