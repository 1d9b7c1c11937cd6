// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITProgram.h"

#include "Private/Frame/vtkOITCompatibility.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <array>
#include <map>

namespace
{
using Shaders = std::map<vtkShader::Type, vtkShader*>;

/// The texts of a program, as VTK's mappers hand them to the cache.
class Texts
{
public:
  Texts(const std::string& vertex, const std::string& geometry, const std::string& fragment)
  {
    for (const vtkShader::Type type : vtkOITGetShaderTypes<vtkShader>(0))
    {
      this->Owned[type] = vtkSmartPointer<vtkShader>::New();
      this->Owned[type]->SetType(type);
      this->Given[type] = this->Owned[type];
    }
    this->Given[vtkShader::Vertex]->SetSource(vertex);
    this->Given[vtkShader::Geometry]->SetSource(geometry);
    this->Given[vtkShader::Fragment]->SetSource(fragment);
  }
  const Shaders& Get() const { return this->Given; }

private:
  std::map<vtkShader::Type, vtkSmartPointer<vtkShader>> Owned;
  Shaders Given;
};

/// Opens what the cache has for classes derived from it.
class Cache : public vtkOpenGLShaderCache
{
public:
  /// The program of texts whose marks are replaced, compiled or not.
  static vtkShaderProgram* Find(vtkOpenGLShaderCache* cache, const Shaders& shaders)
  {
    vtkShaderProgram* (vtkOpenGLShaderCache::*find)(Shaders) = &Cache::GetShaderProgram;
    return (cache->*find)(shaders);
  }
};

/// What the driver says about the shader that it has refused, or about linking; the first line.
std::string FindWords(vtkShaderProgram* program)
{
  // In the order in which VTK compiles them.
  for (vtkShader* shader :
    { program->GetVertexShader(), program->GetFragmentShader(), program->GetGeometryShader() })
  {
    if (!shader->GetSource().empty() && shader->GetHandle() == 0)
    {
      return shader->GetError().substr(0, shader->GetError().find('\n'));
    }
  }
  std::array<char, 256> log{};
  glGetProgramInfoLog(static_cast<GLuint>(program->GetHandle()), static_cast<GLsizei>(log.size()),
    nullptr, log.data());
  const std::string words = log.data();
  return words.substr(0, words.find('\n'));
}

/// As if it had never been tried: VTK does not compile a shader twice, and takes that for a failure
/// of its program when that is tried again.
vtkOITFailure Refuse(vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
{
  const std::string words = FindWords(program);
  program->SetCompiled(true); // otherwise shaders are kept
  program->ReleaseGraphicsResources(window);
  window->GetShaderCache()->ReleaseCurrentShader(); // no program is current any more
  return vtkOITFailure("a shader of vtkOIT does not compile with this OpenGL driver" +
    (words.empty() ? words : " (" + words + ")"));
}
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITReadyProgram(vtkOpenGLRenderWindow* window, const std::string& vertex,
  const std::string& geometry, const std::string& fragment, vtkShaderProgram*& program)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  const Texts texts(vertex, geometry, fragment);
  const int display = vtkObject::GetGlobalWarningDisplay();
  vtkObject::SetGlobalWarningDisplay(0); // VTK would print all of the text
  program = cache->ReadyShaderProgram(texts.Get());
  vtkObject::SetGlobalWarningDisplay(display);
  return program ? vtkOITFailure() : Refuse(window, Cache::Find(cache, texts.Get()));
}
