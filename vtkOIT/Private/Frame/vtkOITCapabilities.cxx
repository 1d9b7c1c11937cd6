// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Frame/vtkOITCapabilities.h"

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITGetInteger.h"
#include "vtkOpenGLRenderWindow.h"

#include <vtksys/SystemInformation.hxx>
#include <vtksys/SystemTools.hxx>

#include <initializer_list>
#include <set>
#include <sstream>

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
  std::string hidden;
  if (vtksys::SystemTools::GetEnv("VTKOIT_HIDE_EXTENSIONS", hidden))
  {
    std::istringstream list(hidden);
    for (std::string name; list >> name;)
    {
      names.erase(name);
    }
  }
  return names;
}

/// Empty, or what is missing of the names, and what to do. Shaders stay at VTK's #version 150 and
/// enable extensions by name, so the names must be there even where the GL version includes them.
std::string FindMissing(const std::set<std::string>& extensions,
  std::initializer_list<const char*> names, const char* advice)
{
  for (const char* name : names)
  {
    if (extensions.count(name) == 0)
    {
      GLint major = 0;
      GLint minor = 0;
      glGetIntegerv(GL_MAJOR_VERSION, &major);
      glGetIntegerv(GL_MINOR_VERSION, &minor);
      return std::string("OpenGL ") + std::to_string(major) + "." + std::to_string(minor) +
        " of this context lacks " + name + advice;
    }
  }
  return {};
}

std::int64_t FindMemory(const std::set<std::string>& extensions)
{
  constexpr GLenum totalNVX = 0x9048; // KiB; GLEW and GLAD of VTK do not name them all
  constexpr GLenum freeTexturesATI = 0x87FC;
  GLint kibibytes[4] = { 0, 0, 0, 0 };
  if (extensions.count("GL_NVX_gpu_memory_info") > 0)
  {
    glGetIntegerv(totalNVX, kibibytes);
  }
  else if (extensions.count("GL_ATI_meminfo") > 0)
  {
    glGetIntegerv(freeTexturesATI, kibibytes);
  }
  if (kibibytes[0] > 0)
  {
    return std::int64_t(kibibytes[0]) * 1024;
  }
  vtksys::SystemInformation machine;
  machine.RunMemoryCheck();
  return static_cast<std::int64_t>(machine.GetTotalPhysicalMemory()) * 1024 * 1024; // from MiB
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
    this->MissingForPeeling = this->MissingForStorage;
    return;
  }
  const std::set<std::string> extensions = GetExtensions();
  const auto has = [&extensions](const char* name) { return extensions.count(name) > 0; };
  this->MissingForStorage = FindMissing(extensions,
    { "GL_ARB_shader_image_load_store", "GL_ARB_shader_storage_buffer_object",
      "GL_ARB_shading_language_420pack", "GL_ARB_gpu_shader5", "GL_ARB_texture_storage",
      "GL_ARB_clear_texture" },
    "; use a driver with OpenGL 4.4 or Mesa's llvmpipe");
  this->MissingForPeeling =
    FindMissing(extensions, { "GL_ARB_explicit_attrib_location", "GL_ARB_shader_bit_encoding" },
      "; use a driver with OpenGL 3.3 or Mesa's llvmpipe");
  // A context may have occlusion queries whose counters have no bits.
  if (vtkOITGetQueryInteger(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS) == 0)
  {
    this->MissingForCounting =
      "this context counts no samples (GL_ARB_occlusion_query2), and by such counts peeling ends; "
      "call UseOcclusionQueryOff() and SetMaximumNumberOfPeels()";
  }
  this->EarlyFragmentTests = has("GL_ARB_shader_image_load_store");
  this->FragmentInterlock = has("GL_ARB_fragment_shader_interlock");
  this->TextureBarrier = has("GL_ARB_texture_barrier");
  this->FramebufferFetch = has("GL_EXT_shader_framebuffer_fetch");
  this->DrawBuffersBlend =
    has("GL_ARB_draw_buffers_blend") && glBlendFuncSeparatei && glBlendEquationSeparatei;
  this->SampleShading = has("GL_ARB_sample_shading");
  this->PostDepthCoverage = has("GL_ARB_post_depth_coverage");
  this->FineDerivatives = has("GL_ARB_derivative_control");
  this->Memory = FindMemory(extensions);
  if (this->HasStorage())
  {
    this->MaximumStorageBlockSize = GetInteger64(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
    this->MaximumTextureBufferSize = GetInteger64(GL_MAX_TEXTURE_BUFFER_SIZE);
  }
}
