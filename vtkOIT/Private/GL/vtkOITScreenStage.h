// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITScreenStage_h
#define vtkOITScreenStage_h

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFailure.h"
#include "Private/GL/vtkOITContextObjects.h"

#include <functional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * A stage that works on pixels instead of props: triangles whose vertices the vertex shader makes
 * from gl_VertexID alone, e.g. the one of vtkOITFullScreenVS.glsl that covers the viewport.
 */
class vtkOITScreenStage : public vtkOITContextObjects
{
public:
  ~vtkOITScreenStage() override { this->Release(); }

  /// Compiles the shaders when there is no program yet, so that Render() does not fail.
  vtkOITFailure Prepare(vtkOpenGLRenderWindow* window, const char* vertexShader,
    const std::function<std::string()>& getFragmentShader);

  /// Compiles the shaders when there is no program yet, makes it current, lets `setUniforms` set
  /// its uniforms, and draws. Fails when they do not compile.
  ///@{
  vtkOITFailure Render(vtkOpenGLRenderWindow* window, const char* vertexShader,
    const std::function<std::string()>& getFragmentShader,
    const std::function<void(vtkShaderProgram*)>& setUniforms, int numberOfTriangles = 1);
  /// Draws when `drawing` calls what it is given, as often as it does.
  vtkOITFailure Render(vtkOpenGLRenderWindow* window, const char* vertexShader,
    const std::function<std::string()>& getFragmentShader,
    const std::function<void(vtkShaderProgram*)>& setUniforms,
    const std::function<void(const std::function<void()>& draw)>& drawing);
  ///@}

  /// Whether Prepare() would compile nothing.
  bool IsPrepared() const;

private:
  void Delete() override;
  void Forget() override;

  vtkShaderProgram* Program = nullptr; // owned by the window's shader cache
  GLuint VertexArray = 0;              // empty; a core profile asks for one
};

#endif
