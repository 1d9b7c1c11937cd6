// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITReadback.h"

namespace
{
struct Parameter
{
  GLenum Name;
  GLint Value; // for plain memory
};
constexpr std::array<Parameter, 8> Plain = { { { GL_PACK_SWAP_BYTES, GL_FALSE },
  { GL_PACK_LSB_FIRST, GL_FALSE }, { GL_PACK_ROW_LENGTH, 0 }, { GL_PACK_IMAGE_HEIGHT, 0 },
  { GL_PACK_SKIP_ROWS, 0 }, { GL_PACK_SKIP_PIXELS, 0 }, { GL_PACK_SKIP_IMAGES, 0 },
  { GL_PACK_ALIGNMENT, 4 } } };
}

//------------------------------------------------------------------------------
vtkOITReadback::vtkOITReadback()
{
  for (std::size_t i = 0; i < Plain.size(); ++i)
  {
    glGetIntegerv(Plain[i].Name, &this->Parameters[i]);
    glPixelStorei(Plain[i].Name, Plain[i].Value);
  }
  glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &this->PackBuffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

//------------------------------------------------------------------------------
vtkOITReadback::~vtkOITReadback()
{
  for (std::size_t i = 0; i < Plain.size(); ++i)
  {
    glPixelStorei(Plain[i].Name, this->Parameters[i]);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, this->PackBuffer);
}
