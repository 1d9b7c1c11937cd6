// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITSavedState.h"

#include "vtkOpenGLState.h"

#include <algorithm>

namespace
{
constexpr std::array<GLenum, 5> Capabilities = { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST,
  GL_CULL_FACE, GL_MULTISAMPLE };

GLint GetInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

GLint GetInteger(GLenum name, int index)
{
  GLint value = 0;
  glGetIntegeri_v(name, static_cast<GLuint>(index), &value);
  return value;
}
}

//------------------------------------------------------------------------------
// Everything is read from GL itself: the cache of vtkOpenGLState may not know what an application
// did with plain GL calls.
vtkOITSavedState::vtkOITSavedState(vtkOpenGLState* state, bool withStorage)
  : State(state)
  , WithStorage(withStorage)
{
  this->DrawFramebuffer = GetInteger(GL_DRAW_FRAMEBUFFER_BINDING);
  this->ReadFramebuffer = GetInteger(GL_READ_FRAMEBUFFER_BINDING);
  this->Renderbuffer = GetInteger(GL_RENDERBUFFER_BINDING);
  this->ActiveTexture = GetInteger(GL_ACTIVE_TEXTURE);
  this->DepthFunction = GetInteger(GL_DEPTH_FUNC);
  this->CullFaceMode = GetInteger(GL_CULL_FACE_MODE);
  glGetBooleanv(GL_DEPTH_WRITEMASK, &this->DepthMask);
  glGetIntegerv(GL_VIEWPORT, this->Viewport.data());
  glGetIntegerv(GL_SCISSOR_BOX, this->Scissor.data());
  this->BlendFunction = { GetInteger(GL_BLEND_SRC_RGB), GetInteger(GL_BLEND_DST_RGB),
    GetInteger(GL_BLEND_SRC_ALPHA), GetInteger(GL_BLEND_DST_ALPHA) };
  this->BlendEquation = { GetInteger(GL_BLEND_EQUATION_RGB), GetInteger(GL_BLEND_EQUATION_ALPHA) };
  glGetBooleanv(GL_COLOR_WRITEMASK, this->ColorMask.data());
  for (std::size_t i = 0; i < Capabilities.size(); ++i)
  {
    this->Enabled[i] = glIsEnabled(Capabilities[i]);
  }
  this->DrawBufferCount =
    std::min(GetInteger(GL_MAX_DRAW_BUFFERS), static_cast<GLint>(this->DrawBuffers.size()));
  for (int i = 0; i < this->DrawBufferCount; ++i)
  {
    this->DrawBuffers[i] = static_cast<GLenum>(GetInteger(GL_DRAW_BUFFER0 + i));
  }
  if (this->WithStorage)
  {
    this->SaveStorage();
  }
}

//------------------------------------------------------------------------------
vtkOITSavedState::~vtkOITSavedState()
{
  vtkOpenGLState* state = this->State;
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->DrawFramebuffer);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->ReadFramebuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, this->Renderbuffer);
  // The default framebuffer takes one name only through glDrawBuffer.
  if (this->DrawFramebuffer == 0)
  {
    glDrawBuffer(this->DrawBuffers[0]);
  }
  else
  {
    glDrawBuffers(this->DrawBufferCount, this->DrawBuffers.data());
  }
  state->vtkglActiveTexture(this->ActiveTexture);
  state->vtkglDepthFunc(this->DepthFunction);
  state->vtkglDepthMask(this->DepthMask);
  state->vtkglCullFace(this->CullFaceMode);
  state->vtkglViewport(this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
  state->vtkglScissor(this->Scissor[0], this->Scissor[1], this->Scissor[2], this->Scissor[3]);
  state->vtkglBlendFuncSeparate(
    this->BlendFunction[0], this->BlendFunction[1], this->BlendFunction[2], this->BlendFunction[3]);
  state->vtkglBlendEquationSeparate(this->BlendEquation[0], this->BlendEquation[1]);
  state->vtkglColorMask(
    this->ColorMask[0], this->ColorMask[1], this->ColorMask[2], this->ColorMask[3]);
  for (std::size_t i = 0; i < Capabilities.size(); ++i)
  {
    if (this->Enabled[i])
    {
      state->vtkglEnable(Capabilities[i]);
    }
    else
    {
      state->vtkglDisable(Capabilities[i]);
    }
  }
  if (this->WithStorage)
  {
    this->RestoreStorage();
  }
}

//------------------------------------------------------------------------------
void vtkOITSavedState::SaveStorage()
{
  for (int i = 0; i < BindingCount; ++i)
  {
    ImageUnit& unit = this->ImageUnits[i];
    unit.Name = GetInteger(GL_IMAGE_BINDING_NAME, i);
    unit.Level = GetInteger(GL_IMAGE_BINDING_LEVEL, i);
    unit.Layered = GetInteger(GL_IMAGE_BINDING_LAYERED, i);
    unit.Layer = GetInteger(GL_IMAGE_BINDING_LAYER, i);
    unit.Access = GetInteger(GL_IMAGE_BINDING_ACCESS, i);
    unit.Format = GetInteger(GL_IMAGE_BINDING_FORMAT, i);
    StorageBinding& binding = this->StorageBindings[i];
    binding.Name = GetInteger(GL_SHADER_STORAGE_BUFFER_BINDING, i);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &binding.Start);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &binding.Size);
  }
  this->StorageBuffer = GetInteger(GL_SHADER_STORAGE_BUFFER_BINDING);
}

//------------------------------------------------------------------------------
void vtkOITSavedState::RestoreStorage()
{
  for (int i = 0; i < BindingCount; ++i)
  {
    const ImageUnit& unit = this->ImageUnits[i];
    glBindImageTexture(i, unit.Name, unit.Level, unit.Layered ? GL_TRUE : GL_FALSE, unit.Layer,
      unit.Access, unit.Format);
    const StorageBinding& binding = this->StorageBindings[i];
    if (binding.Size > 0)
    {
      glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, binding.Name,
        static_cast<GLintptr>(binding.Start), static_cast<GLsizeiptr>(binding.Size));
    }
    else
    {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, binding.Name);
    }
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->StorageBuffer);
}
