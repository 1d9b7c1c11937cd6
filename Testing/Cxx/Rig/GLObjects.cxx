// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rig/GLObjects.h"

#include <cstdlib>
#include <sstream>

namespace vtkOITTest
{
namespace
{
// Mesa hands out the smallest free names, so leaked objects stay below this for a long time.
constexpr GLuint LargestName = 16384;

template <typename IsObject>
int Count(IsObject isObject)
{
  int count = 0;
  for (GLuint name = 1; name <= LargestName; ++name)
  {
    count += isObject(name) ? 1 : 0;
  }
  return count;
}
}

//------------------------------------------------------------------------------
bool HasGLExtension(const std::string& name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
  {
    if (name == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i)))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
GLObjectCounts GLObjectCounts::OfCurrentContext()
{
  GLObjectCounts counts;
  counts.Textures = Count([](GLuint name) { return glIsTexture(name); });
  counts.Buffers = Count([](GLuint name) { return glIsBuffer(name); });
  counts.Programs = Count([](GLuint name) { return glIsProgram(name); });
  counts.Shaders = Count([](GLuint name) { return glIsShader(name); });
  counts.Framebuffers = Count([](GLuint name) { return glIsFramebuffer(name); });
  counts.Renderbuffers = Count([](GLuint name) { return glIsRenderbuffer(name); });
  counts.Queries = Count([](GLuint name) { return glIsQuery(name); });
  counts.VertexArrays = Count([](GLuint name) { return glIsVertexArray(name); });
  return counts;
}

//------------------------------------------------------------------------------
std::string GLObjectCounts::Describe() const
{
  std::ostringstream text;
  text << this->Textures << " textures, " << this->Buffers << " buffers, " << this->Programs
       << " programs, " << this->Shaders << " shaders, " << this->Framebuffers << " framebuffers, "
       << this->Renderbuffers << " renderbuffers, " << this->Queries << " queries, "
       << this->VertexArrays << " vertex arrays";
  return text.str();
}

//------------------------------------------------------------------------------
bool GLObjectCounts::operator==(const GLObjectCounts& other) const
{
  GLObjectCounts same = *this;
  same.Queries = other.Queries;
  return same.Describe() == other.Describe() &&
    std::abs(this->Queries - other.Queries) < QueryTolerance;
}
}
