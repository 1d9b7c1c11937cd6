// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITNeutralState.h"

#include "glsl/Common/vtkOITConstants.h"

#include "vtkOpenGLState.h"

#include <algorithm>

namespace
{
constexpr std::array<GLenum, 14> Capabilities = { GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL,
  GL_PRIMITIVE_RESTART, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE,
  GL_SAMPLE_MASK, GL_RASTERIZER_DISCARD, GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE0 + 1,
  GL_CLIP_DISTANCE0 + 2, GL_CLIP_DISTANCE0 + 3, GL_CLIP_DISTANCE0 + 4, GL_CLIP_DISTANCE0 + 5 };

struct TextureTarget
{
  GLenum Name;
  GLenum Binding;
};
constexpr std::array<TextureTarget, 4> TextureTargets = {
  { { GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D }, { GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY },
    { GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER },
    { GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE } }
};

constexpr int FirstUnit = OIT_UNIT_BUCKET_TABLE;

void SetCapability(GLenum capability, bool isEnabled)
{
  if (isEnabled)
  {
    glEnable(capability);
  }
  else
  {
    glDisable(capability);
  }
}
}

//------------------------------------------------------------------------------
vtkOITNeutralState::vtkOITNeutralState(vtkOpenGLState* state)
  : State(state)
{
  for (std::size_t i = 0; i < Capabilities.size(); ++i)
  {
    this->Enabled[i] = glIsEnabled(Capabilities[i]);
  }
  glGetIntegerv(GL_LOGIC_OP_MODE, &this->LogicOperation);
  glGetIntegerv(GL_POLYGON_MODE, this->PolygonMode);
  glGetIntegerv(GL_FRONT_FACE, &this->FrontFace);
  for (int i = 0; i < Buffers; ++i)
  {
    glGetBooleani_v(GL_COLOR_WRITEMASK, i, this->ColorMasks[i].data());
    this->Blends[i] = glIsEnabledi(GL_BLEND, i);
    this->HasBuffersApart = this->HasBuffersApart || this->ColorMasks[i] != this->ColorMasks[0] ||
      this->Blends[i] != this->Blends[0];
  }
  this->SaveTextures();
  this->SetNeutral();
}

//------------------------------------------------------------------------------
vtkOITNeutralState::~vtkOITNeutralState()
{
  this->SetAgain();
  this->RestoreTextures();
}

//------------------------------------------------------------------------------
void vtkOITNeutralState::SetNeutral() const
{
  for (std::size_t i = 0; i < Capabilities.size(); ++i)
  {
    if (this->Enabled[i])
    {
      glDisable(Capabilities[i]);
    }
  }
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glFrontFace(GL_CCW);
  if (this->HasBuffersApart)
  {
    // VTK's cache knows of one mask and one blending for all.
    const std::array<GLboolean, 4>& mask = this->ColorMasks[0];
    glColorMask(mask[0], mask[1], mask[2], mask[3]);
    SetCapability(GL_BLEND, this->Blends[0] == GL_TRUE);
  }
}

//------------------------------------------------------------------------------
void vtkOITNeutralState::SetAgain() const
{
  for (std::size_t i = 0; i < Capabilities.size(); ++i)
  {
    SetCapability(Capabilities[i], this->Enabled[i] == GL_TRUE);
  }
  glLogicOp(this->LogicOperation);
  glPolygonMode(GL_FRONT_AND_BACK, this->PolygonMode[0]);
  glFrontFace(this->FrontFace);
  for (int i = 0; i < Buffers && this->HasBuffersApart; ++i)
  {
    const std::array<GLboolean, 4>& mask = this->ColorMasks[i];
    glColorMaski(i, mask[0], mask[1], mask[2], mask[3]);
    if (this->Blends[i])
    {
      glEnablei(GL_BLEND, i);
    }
    else
    {
      glDisablei(GL_BLEND, i);
    }
  }
}

//------------------------------------------------------------------------------
void vtkOITNeutralState::SaveTextures()
{
  glGetIntegerv(GL_ACTIVE_TEXTURE, &this->ActiveTexture);
  for (int unit = 0; unit < Units; ++unit)
  {
    glActiveTexture(GL_TEXTURE0 + FirstUnit + unit);
    for (int i = 0; i < Targets; ++i)
    {
      glGetIntegerv(TextureTargets[i].Binding, &this->Textures[unit][i]);
    }
    if (glBindSampler)
    {
      glGetIntegerv(GL_SAMPLER_BINDING, &this->Samplers[unit]);
      glBindSampler(FirstUnit + unit, 0);
    }
  }
  glActiveTexture(this->ActiveTexture);
}

//------------------------------------------------------------------------------
void vtkOITNeutralState::RestoreTextures() const
{
  for (int unit = 0; unit < Units; ++unit)
  {
    glActiveTexture(GL_TEXTURE0 + FirstUnit + unit);
    for (int i = 0; i < Targets; ++i)
    {
      glBindTexture(TextureTargets[i].Name, this->Textures[unit][i]);
    }
    if (glBindSampler)
    {
      glBindSampler(FirstUnit + unit, this->Samplers[unit]);
    }
  }
  glActiveTexture(this->ActiveTexture);
}
