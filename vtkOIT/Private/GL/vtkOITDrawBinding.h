// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDrawBinding_h
#define vtkOITDrawBinding_h

#include "Private/Frame/vtkOITGetInteger.h"

#include <array>

/// The framebuffer bound for drawing, and which of its buffers are drawn into.
struct vtkOITDrawBinding
{
  GLint Framebuffer = 0;
  std::array<GLenum, 8> Buffers{};

  static vtkOITDrawBinding Query()
  {
    vtkOITDrawBinding binding;
    binding.Framebuffer = vtkOITGetInteger(GL_DRAW_FRAMEBUFFER_BINDING);
    for (std::size_t i = 0; i < binding.Buffers.size(); ++i)
    {
      binding.Buffers[i] =
        static_cast<GLenum>(vtkOITGetInteger(GL_DRAW_BUFFER0 + static_cast<GLenum>(i)));
    }
    return binding;
  }
  /// Not for the default framebuffer, which has but one buffer.
  void SetAgain() const
  {
    if (this->Framebuffer != 0)
    {
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(this->Framebuffer));
      glDrawBuffers(static_cast<GLsizei>(this->Buffers.size()), this->Buffers.data());
    }
  }
};

#endif
