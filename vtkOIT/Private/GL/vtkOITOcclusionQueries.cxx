// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITOcclusionQueries.h"

#include "Private/Frame/vtkOITGetInteger.h"
#include "Private/GL/vtkOITAllocation.h"

//------------------------------------------------------------------------------
bool vtkOITOcclusionQueries::CanCount()
{
  return vtkOITGetQueryInteger(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS) > 0 &&
    vtkOITGetQueryInteger(GL_SAMPLES_PASSED, GL_CURRENT_QUERY) == 0;
}

//------------------------------------------------------------------------------
void vtkOITOcclusionQueries::StartRow(vtkOpenGLRenderWindow* window)
{
  this->Attach(window);
  this->Delete();
  this->Names.clear();
  this->Counts = CanCount();
  this->Failed = false;
}

//------------------------------------------------------------------------------
void vtkOITOcclusionQueries::Begin(std::size_t number)
{
  if (this->Counts)
  {
    const std::size_t known = this->Names.size();
    if (number >= known)
    {
      this->Names.resize(number + 1);
      glGenQueries(static_cast<GLsizei>(number + 1 - known), this->Names.data() + known);
    }
    glBeginQuery(GL_SAMPLES_PASSED, this->Names[number]);
    // A query that has not begun counts nothing and must not end. The error is ours: VTK would print it.
    if (vtkOITAllocation::TakeErrors())
    {
      this->Failed = true;
      this->Counts = false;
    }
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
  GLuint isAvailable = GL_TRUE; // what fails, can be had at once
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
  constexpr GLuint none = ~0u; // OpenGL leaves the value alone when it fails
  GLuint samples = none;
  glGetQueryObjectuiv(this->Names[number], GL_QUERY_RESULT, &samples);
  if (samples == none)
  {
    this->Failed = true;
    vtkOITAllocation::TakeErrors();
    return -1;
  }
  return static_cast<std::int64_t>(samples);
}

//------------------------------------------------------------------------------
void vtkOITOcclusionQueries::Delete()
{
  glDeleteQueries(static_cast<GLsizei>(this->Names.size()), this->Names.data());
}
