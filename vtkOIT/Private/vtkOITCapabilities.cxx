// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITCapabilities.h"

#include "vtkOITCompatibility.h"
#include "vtkOpenGLRenderWindow.h"

#include <set>

namespace
{
std::set<std::string> GetExtensions()
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  std::set<std::string> names;
  for (GLint i = 0; i < count; ++i)
  {
    names.insert(reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i)));
  }
  return names;
}

std::string FindMissingForStorage(const std::set<std::string>& extensions)
{
  // Shaders stay at VTK's #version 150 and enable these by name, so the names must be there even
  // where the GL version includes them.
  for (const char* name : { "GL_ARB_shader_image_load_store", "GL_ARB_shader_storage_buffer_object",
         "GL_ARB_shading_language_420pack", "GL_ARB_gpu_shader5", "GL_ARB_clear_texture" })
  {
    if (extensions.count(name) == 0)
    {
      GLint major = 0;
      GLint minor = 0;
      glGetIntegerv(GL_MAJOR_VERSION, &major);
      glGetIntegerv(GL_MINOR_VERSION, &minor);
      return std::string("OpenGL ") + std::to_string(major) + "." + std::to_string(minor) +
        " of this context lacks " + name + "; use a driver with OpenGL 4.4 or Mesa's llvmpipe";
    }
  }
  return {};
}

std::int64_t GetInteger64(GLenum name)
{
  GLint64 value = 0;
  glGetInteger64v(name, &value);
  return value;
}
}

//------------------------------------------------------------------------------
vtkOITCapabilities::vtkOITCapabilities(vtkOpenGLRenderWindow* window)
{
  // The loader's pointers are null until a context of this process has been initialized.
  if (!window || !window->IsCurrent() || !glGetStringi)
  {
    this->MissingForStorage = "the window has no OpenGL context yet; call its Render() first";
    return;
  }
  const std::set<std::string> extensions = GetExtensions();
  this->MissingForStorage = FindMissingForStorage(extensions);
  this->FramebufferFetch = extensions.count("GL_EXT_shader_framebuffer_fetch") > 0;
  this->PostDepthCoverage = extensions.count("GL_ARB_post_depth_coverage") > 0;
  if (this->HasStorage())
  {
    this->MaximumStorageBlockSize = GetInteger64(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
    this->MaximumTextureBufferSize = GetInteger64(GL_MAX_TEXTURE_BUFFER_SIZE);
  }
}
