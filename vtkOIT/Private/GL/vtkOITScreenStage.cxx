// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITScreenStage.h"

#include "Private/GL/vtkOITProgram.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkOITFailure vtkOITScreenStage::Render(vtkOpenGLRenderWindow* window, const char* vertexShader,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms, int numberOfTriangles)
{
  return this->Render(window, vertexShader, getFragmentShader, setUniforms,
    [numberOfTriangles](const std::function<void()>&)
    { glDrawArrays(GL_TRIANGLES, 0, 3 * numberOfTriangles); });
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITScreenStage::Render(vtkOpenGLRenderWindow* window, const char* vertexShader,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms,
  const std::function<void(const std::function<void()>& draw)>& drawing)
{
  if (vtkOITFailure failure = this->Prepare(window, vertexShader, getFragmentShader))
  {
    return failure;
  }
  setUniforms(this->Program);
  glBindVertexArray(this->VertexArray);
  drawing([] { glDrawArrays(GL_TRIANGLES, 0, 3); });
  glBindVertexArray(0);
  return {};
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITScreenStage::Prepare(vtkOpenGLRenderWindow* window, const char* vertexShader,
  const std::function<std::string()>& getFragmentShader)
{
  this->Attach(window);
  if (this->IsPrepared())
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Program);
  }
  else if (vtkOITFailure failure =
             vtkOITReadyProgram(window, vertexShader, "", getFragmentShader(), this->Program))
  {
    return failure;
  }
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  return {};
}

//------------------------------------------------------------------------------
bool vtkOITScreenStage::IsPrepared() const
{
  return this->Program && this->Program->GetCompiled();
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
