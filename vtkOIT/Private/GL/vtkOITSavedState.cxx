// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITSavedState.h"

#include "Private/Frame/vtkOITGetInteger.h"

#include "vtkOpenGLState.h"

namespace
{
vtkOITRectangle GetRectangle(GLenum name)
{
  GLint values[4] = { 0, 0, 0, 0 };
  glGetIntegerv(name, values);
  return { values[0], values[1], values[2], values[3] };
}
}

//------------------------------------------------------------------------------
vtkOITSavedState::vtkOITSavedState(vtkOpenGLState* state, const vtkOITTarget& target)
  : State(state)
  , Neutral(state)
  , Target(target)
{
  this->ReadFramebuffer = vtkOITGetInteger(GL_READ_FRAMEBUFFER_BINDING);
  this->Renderbuffer = vtkOITGetInteger(GL_RENDERBUFFER_BINDING);
  this->VertexArray = vtkOITGetInteger(GL_VERTEX_ARRAY_BINDING);
  this->CullFaceMode = vtkOITGetInteger(GL_CULL_FACE_MODE);
  glGetBooleanv(GL_DEPTH_WRITEMASK, &this->DepthMask);
  this->Viewport = GetRectangle(GL_VIEWPORT);
  this->Scissor = GetRectangle(GL_SCISSOR_BOX);
  this->BlendFunction = { vtkOITGetInteger(GL_BLEND_SRC_RGB), vtkOITGetInteger(GL_BLEND_DST_RGB),
    vtkOITGetInteger(GL_BLEND_SRC_ALPHA), vtkOITGetInteger(GL_BLEND_DST_ALPHA) };
  this->BlendEquation = { vtkOITGetInteger(GL_BLEND_EQUATION_RGB),
    vtkOITGetInteger(GL_BLEND_EQUATION_ALPHA) };
  this->TestsScissor = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
  this->Multisamples = glIsEnabled(GL_MULTISAMPLE) == GL_TRUE;
  this->Restore(); // makes the cache true
}

//------------------------------------------------------------------------------
void vtkOITSavedState::SetAgain() const
{
  this->Restore();
  // The default framebuffer takes one name only through glDrawBuffer.
  if (this->Target.Framebuffer == 0)
  {
    glDrawBuffer(this->Target.DrawBuffers[0]);
  }
  else
  {
    this->Target.DrawToAllBuffers();
  }
  this->Neutral.SetAgain();
}

//------------------------------------------------------------------------------
vtkOITSavedState::~vtkOITSavedState()
{
  this->SetAgain();
  glBindRenderbuffer(GL_RENDERBUFFER, this->Renderbuffer);
  glBindVertexArray(this->VertexArray);
  if (this->HasStorage)
  {
    this->RestoreStorage();
  }
}

//------------------------------------------------------------------------------
void vtkOITSavedState::Restore() const
{
  vtkOpenGLState* state = this->State;
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Target.Framebuffer);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->ReadFramebuffer);
  state->vtkglActiveTexture(this->Neutral.GetActiveTexture());
  state->vtkglDepthFunc(this->Target.DepthFunction);
  state->vtkglDepthMask(this->DepthMask);
  state->vtkglCullFace(this->CullFaceMode);
  const vtkOITRectangle& v = this->Viewport;
  state->vtkglViewport(v.X, v.Y, v.Width, v.Height);
  const vtkOITRectangle& s = this->Scissor;
  state->vtkglScissor(s.X, s.Y, s.Width, s.Height);
  state->vtkglBlendFuncSeparate(
    this->BlendFunction[0], this->BlendFunction[1], this->BlendFunction[2], this->BlendFunction[3]);
  state->vtkglBlendEquationSeparate(this->BlendEquation[0], this->BlendEquation[1]);
  const std::array<GLboolean, 4>& mask = this->Neutral.GetColorMask();
  state->vtkglColorMask(mask[0], mask[1], mask[2], mask[3]);
  state->SetEnumState(GL_BLEND, this->Neutral.GetBlends());
  state->SetEnumState(GL_DEPTH_TEST, this->Target.TestsDepth);
  state->SetEnumState(GL_SCISSOR_TEST, this->TestsScissor);
  state->SetEnumState(GL_CULL_FACE, this->Target.CullsFaces);
  state->SetEnumState(GL_MULTISAMPLE, this->Multisamples);
}

//------------------------------------------------------------------------------
const vtkOITRectangle& vtkOITSavedState::GetDrawnRectangle() const
{
  return this->TestsScissor ? this->Scissor : this->Viewport;
}

//------------------------------------------------------------------------------
void vtkOITSavedState::AddStorage()
{
  if (this->HasStorage)
  {
    return;
  }
  this->HasStorage = true;
  for (int i = 0; i < BindingCount; ++i)
  {
    ImageUnit& unit = this->ImageUnits[i];
    unit.Name = vtkOITGetInteger(GL_IMAGE_BINDING_NAME, i);
    unit.Level = vtkOITGetInteger(GL_IMAGE_BINDING_LEVEL, i);
    unit.Layered = vtkOITGetInteger(GL_IMAGE_BINDING_LAYERED, i);
    unit.Layer = vtkOITGetInteger(GL_IMAGE_BINDING_LAYER, i);
    unit.Access = vtkOITGetInteger(GL_IMAGE_BINDING_ACCESS, i);
    unit.Format = vtkOITGetInteger(GL_IMAGE_BINDING_FORMAT, i);
    StorageBinding& binding = this->StorageBindings[i];
    binding.Name = vtkOITGetInteger(GL_SHADER_STORAGE_BUFFER_BINDING, i);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &binding.Start);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &binding.Size);
  }
  this->StorageBuffer = vtkOITGetInteger(GL_SHADER_STORAGE_BUFFER_BINDING);
}

//------------------------------------------------------------------------------
void vtkOITSavedState::RestoreStorage() const
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
