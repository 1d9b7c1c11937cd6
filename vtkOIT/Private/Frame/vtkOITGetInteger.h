// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITGetInteger_h
#define vtkOITGetInteger_h

#include "Private/Frame/vtkOITCompatibility.h"

/// An integer of the state of OpenGL.
inline GLint vtkOITGetInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// The same of a binding point or unit.
inline GLint vtkOITGetInteger(GLenum name, int index)
{
  GLint value = 0;
  glGetIntegeri_v(name, static_cast<GLuint>(index), &value);
  return value;
}

/// What a context says of a kind of query; 0 where it does not know the name.
inline GLint vtkOITGetQueryInteger(GLenum kind, GLenum name)
{
  GLint value = 0;
  glGetQueryiv(kind, name, &value);
  return value;
}

#endif
