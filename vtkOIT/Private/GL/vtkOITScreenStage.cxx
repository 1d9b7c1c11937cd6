// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITScreenStage.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
bool vtkOITScreenStage::Render(vtkOpenGLRenderWindow* window, const char* vertexShader,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms, int numberOfTriangles)
{
  return this->Render(window, vertexShader, getFragmentShader, setUniforms,
    [numberOfTriangles](const std::function<void()>&)
    { glDrawArrays(GL_TRIANGLES, 0, 3 * numberOfTriangles); });
}

//------------------------------------------------------------------------------
bool vtkOITScreenStage::Render(vtkOpenGLRenderWindow* window, const char* vertexShader,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms,
  const std::function<void(const std::function<void()>& draw)>& drawing)
{
  this->Attach(window);
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (!this->Program)
  {
    this->Program = cache->ReadyShaderProgram(vertexShader, getFragmentShader().c_str(), "");
    glGenVertexArrays(1, &this->VertexArray);
  }
  else
  {
    cache->ReadyShaderProgram(this->Program);
  }
  if (!this->Program)
  {
    return false;
  }
  setUniforms(this->Program);
  GLint bound = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
  glBindVertexArray(this->VertexArray);
  drawing([] { glDrawArrays(GL_TRIANGLES, 0, 3); });
  glBindVertexArray(bound);
  return true;
}

//------------------------------------------------------------------------------
void vtkOITScreenStage::Delete()
{
  glDeleteVertexArrays(1, &this->VertexArray);
}

//------------------------------------------------------------------------------
void vtkOITScreenStage::Forget()
{
  this->Program = nullptr;
  this->VertexArray = 0;
}
