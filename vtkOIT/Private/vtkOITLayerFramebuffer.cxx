// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITLayerFramebuffer.h"

#include "vtkOITDepthCopy.h"
#include "vtkOITTextureArray.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <array>

//------------------------------------------------------------------------------
void vtkOITLayerFramebuffer::Begin(vtkOpenGLRenderWindow* window)
{
  this->Attach(window);
  if (this->Framebuffer == 0)
  {
    glGenFramebuffers(1, &this->Framebuffer);
  }
  window->GetState()->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
}

//------------------------------------------------------------------------------
bool vtkOITLayerFramebuffer::Finish(
  const vtkOITTextureArray* colors, int firstLayer, int numberOfLayers)
{
  std::array<GLenum, 8> buffers{};
  for (int i = 0; i < numberOfLayers; ++i)
  {
    glFramebufferTextureLayer(
      GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, colors->GetName(), 0, firstLayer + i);
    buffers[i] = GL_COLOR_ATTACHMENT0 + i;
  }
  for (int i = numberOfLayers; i < this->NumberOfColors; ++i)
  {
    glFramebufferTexture(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, 0, 0);
  }
  this->NumberOfColors = numberOfLayers;
  if (numberOfLayers > 0)
  {
    glDrawBuffers(numberOfLayers, buffers.data());
  }
  else
  {
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
  }
  return glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

//------------------------------------------------------------------------------
bool vtkOITLayerFramebuffer::Bind(vtkOpenGLRenderWindow* window, const vtkOITTextureArray* colors,
  int firstLayer, int numberOfLayers, const vtkOITDepthCopy* depth)
{
  this->Begin(window);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth ? depth->GetName() : 0, 0);
  return this->Finish(colors, firstLayer, numberOfLayers);
}

//------------------------------------------------------------------------------
bool vtkOITLayerFramebuffer::Bind(vtkOpenGLRenderWindow* window, const vtkOITTextureArray* colors,
  int firstLayer, int numberOfLayers, const vtkOITTextureArray* depth)
{
  this->Begin(window);
  if (depth)
  {
    glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth->GetName(), 0, 0);
  }
  else
  {
    glFramebufferTexture(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, 0, 0);
  }
  return this->Finish(colors, firstLayer, numberOfLayers);
}

//------------------------------------------------------------------------------
void vtkOITLayerFramebuffer::Delete()
{
  glDeleteFramebuffers(1, &this->Framebuffer);
}

//------------------------------------------------------------------------------
void vtkOITLayerFramebuffer::Forget()
{
  this->Framebuffer = 0;
  this->NumberOfColors = 0;
}
