// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITAllocation.h"

namespace
{
constexpr int MostErrors = 32; // GL keeps one of each kind at most
}

//------------------------------------------------------------------------------
vtkOITAllocation::vtkOITAllocation()
{
  glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &this->UnpackBuffer);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  TakeErrors();
}

//------------------------------------------------------------------------------
vtkOITAllocation::~vtkOITAllocation()
{
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, this->UnpackBuffer);
}

//------------------------------------------------------------------------------
bool vtkOITAllocation::TakeErrors()
{
  bool ranOut = false;
  for (int i = 0; i < MostErrors; ++i)
  {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR)
    {
      break;
    }
    ranOut = ranOut || error == GL_OUT_OF_MEMORY;
  }
  return ranOut;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITAllocation::Check(const std::string& what) const
{
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR)
  {
    return {};
  }
  TakeErrors();
  return vtkOITFailure::OfMemory(
    "OpenGL has no memory for " + what + "; use a smaller window, or set a MaximumBufferSize");
}
