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

/// In the order in which VTK compiles them.
std::array<vtkShader*, 3> GetShaders(vtkShaderProgram* program)
{
  return { program->GetVertexShader(), program->GetFragmentShader(), program->GetGeometryShader() };
}

/// What the driver says about the shader that it has refused, or about linking; the first line.
std::string FindWords(vtkShaderProgram* program)
{
  std::string words = program->GetError();
  for (vtkShader* shader : GetShaders(program))
  {
    if (!shader->GetSource().empty() && shader->GetHandle() == 0)
    {
      words = shader->GetError();
      break;
    }
  }
  return words.substr(0, words.find('\n'));
}

/// VTK does not compile a shader twice, and takes that for a failure of its program when that is
/// tried again.
vtkOITFailure Refuse(vtkShaderProgram* program)
{
  const std::string words = FindWords(program);
  for (vtkShader* shader : GetShaders(program))
  {
    shader->Cleanup();
  }
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
  return program ? vtkOITFailure() : Refuse(Cache::Find(cache, texts.Get()));
}
