// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITOcclusionQueries.h"

#include "Private/Frame/vtkOITGetInteger.h"

//------------------------------------------------------------------------------
bool vtkOITOcclusionQueries::CanCount()
{
  return vtkOITGetQueryInteger(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS) > 0 &&
    vtkOITGetQueryInteger(GL_SAMPLES_PASSED, GL_CURRENT_QUERY) == 0;
}

//------------------------------------------------------------------------------
void vtkOITOcclusionQueries::Begin(vtkOpenGLRenderWindow* window, std::size_t number)
{
  this->Attach(window);
  while (this->Names.size() <= number)
  {
    GLuint name = 0;
    glGenQueries(1, &name);
    this->Names.push_back(name);
  }
  if (number == 0)
  {
    this->Counts = CanCount();
  }
  if (this->Counts)
  {
    glBeginQuery(GL_SAMPLES_PASSED, this->Names[number]);
  }
}

//------------------------------------------------------------------------------
void vtkOITOcclusionQueries::End()
{
  if (this->Counts)
  {
    glEndQuery(GL_SAMPLES_PASSED);
  }
}

//------------------------------------------------------------------------------
bool vtkOITOcclusionQueries::IsAvailable(std::size_t number) const
{
  if (!this->Counts)
  {
    return true;
  }
  GLuint isAvailable = GL_FALSE;
  glGetQueryObjectuiv(this->Names[number], GL_QUERY_RESULT_AVAILABLE, &isAvailable);
  return isAvailable != GL_FALSE;
}

//------------------------------------------------------------------------------
std::int64_t vtkOITOcclusionQueries::GetResult(std::size_t number) const
{
  if (!this->Counts)
  {
    return -1;
  }
  GLuint samples = 0;
  glGetQueryObjectuiv(this->Names[number], GL_QUERY_RESULT, &samples);
  return samples;
}

//------------------------------------------------------------------------------
void vtkOITOcclusionQueries::Delete()
{
  glDeleteQueries(static_cast<GLsizei>(this->Names.size()), this->Names.data());
}
