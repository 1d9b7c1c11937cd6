// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITFramebuffer.h"

#include "Private/Frame/vtkOITGetInteger.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace
{
/// Before GL 4.1 a buffer to draw into or to read that is not there makes a framebuffer incomplete.
bool NeedsBuffers()
{
  const GLint major = vtkOITGetInteger(GL_MAJOR_VERSION);
  const GLint minor = vtkOITGetInteger(GL_MINOR_VERSION);
  return major < 4 || (major == 4 && minor < 1);
}
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITRefuseFramebuffer()
{
  return vtkOITFailure("the OpenGL driver does not draw into such a framebuffer");
}

//------------------------------------------------------------------------------
std::uint64_t vtkOITAttachment::MakeSerial()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}

//------------------------------------------------------------------------------
void vtkOITAttachTo(GLenum point, const vtkOITAttachment& attachment)
{
  if (attachment.Layer >= 0)
  {
    glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, point, attachment.Texture, 0, attachment.Layer);
  }
  else
  {
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, point, GL_TEXTURE_2D, attachment.Texture, 0);
  }
}

//------------------------------------------------------------------------------
void vtkOITDeleteFramebuffer(vtkOpenGLRenderWindow* window, GLuint framebuffer)
{
  constexpr std::array<std::array<GLenum, 2>, 2> targets{
    { { GL_DRAW_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER_BINDING },
      { GL_READ_FRAMEBUFFER, GL_READ_FRAMEBUFFER_BINDING } }
  };
  for (const std::array<GLenum, 2>& target : targets)
  {
    const auto bound = static_cast<GLuint>(vtkOITGetInteger(target[1]));
    if (framebuffer != 0 && bound == framebuffer)
    {
      window->GetState()->vtkglBindFramebuffer(target[0], 0);
    }
  }
  glDeleteFramebuffers(1, &framebuffer);
}

//------------------------------------------------------------------------------
GLuint vtkOITFramebuffer::Make(vtkOpenGLRenderWindow* window)
{
  this->Attach(window);
  if (this->Framebuffer == 0)
  {
    glGenFramebuffers(1, &this->Framebuffer);
  }
  return this->Framebuffer;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITFramebuffer::Bind(vtkOpenGLRenderWindow* window,
  const std::vector<vtkOITAttachment>& colors, const vtkOITAttachment& depth)
{
  this->Attach(window);
  const bool isNew = this->Framebuffer == 0;
  if (isNew)
  {
    glGenFramebuffers(1, &this->Framebuffer);
  }
  window->GetState()->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  if (isNew || !this->IsComplete || this->Colors != colors || !(this->Depth == depth))
  {
    const std::size_t count = std::max(colors.size(), this->Colors.size());
    for (std::size_t i = 0; i < count; ++i)
    {
      vtkOITAttachTo(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i),
        i < colors.size() ? colors[i] : vtkOITAttachment());
    }
    vtkOITAttachTo(GL_DEPTH_ATTACHMENT, depth);
    this->Colors = colors;
    this->Depth = depth;
    // Without colours, too: when VTK binds a framebuffer it takes the first colour for drawn into.
    DrawInto(std::max(1, static_cast<int>(colors.size())));
    this->IsComplete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (!this->IsComplete && colors.empty() && NeedsBuffers())
    {
      window->GetState()->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Framebuffer);
      DrawInto(0);
      glReadBuffer(GL_NONE);
      this->IsComplete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
      if (!this->IsComplete)
      {
        DrawInto(1); // as VTK takes it to be
        glReadBuffer(GL_COLOR_ATTACHMENT0);
      }
    }
  }
  else if (!colors.empty())
  {
    DrawInto(static_cast<int>(colors.size()));
  }
  return this->IsComplete ? vtkOITFailure() : vtkOITRefuseFramebuffer();
}

//------------------------------------------------------------------------------
void vtkOITFramebuffer::DrawInto(int numberOfColors)
{
  std::array<GLenum, 8> buffers{};
  for (int i = 0; i < numberOfColors; ++i)
  {
    buffers[i] = GL_COLOR_ATTACHMENT0 + i;
  }
  // GL_NONE is 0, what the array has in the first place.
  glDrawBuffers(std::max(1, numberOfColors), buffers.data());
}

//------------------------------------------------------------------------------
void vtkOITFramebuffer::Delete()
{
  vtkOITDeleteFramebuffer(this->GetWindow(), this->Framebuffer);
}

//------------------------------------------------------------------------------
void vtkOITFramebuffer::Forget()
{
  this->Framebuffer = 0;
  this->Colors.clear();
  this->Depth = {};
}
