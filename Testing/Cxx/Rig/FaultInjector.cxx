// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rig/FaultInjector.h"

#include "Rig/GLObjects.h"

#if defined(__linux__)
#include "vtkOITPass.h"
#include "vtkOITPassFactory.h"
#include "vtkSmartPointer.h"

#include <dlfcn.h>

#include <cstring>
#include <set>
#endif

namespace vtkOITTest
{
namespace
{
std::array<int, FaultInjector::NumberOfKinds> Calls{};
int Faults = 0;
FaultInjector::Kind FailingKind = FaultInjector::NumberOfKinds;
int FirstToFail = 0;
bool FailsFromThenOn = false;

/// Counts a call; true when it is to fail.
bool Hit(FaultInjector::Kind kind)
{
  const int number = ++Calls[kind];
  const bool fails =
    kind == FailingKind && (FailsFromThenOn ? number >= FirstToFail : number == FirstToFail);
  Faults += fails ? 1 : 0;
  return fails;
}
}

#if defined(__linux__)
namespace
{
/// Where the library is that has this code or data.
void* FindLibrary(const void* address)
{
  Dl_info info{};
  return dladdr(const_cast<void*>(address), &info) ? info.dli_fbase : nullptr;
}

/// The library of vtkOIT, by the table of virtual functions of one of its classes.
void* FindOwnLibrary()
{
  const auto pass = vtkSmartPointer<vtkOITPass>::Take(vtkOITPassFactory::CreatePass("abuffer"));
  const void* table = nullptr;
  const void* object = pass.Get();
  std::memcpy(&table, object, sizeof(table));
  return FindLibrary(table);
}

bool IsOurs(const void* caller)
{
  static void* own = FindOwnLibrary();
  return FindLibrary(caller) == own;
}
#define IS_OURS() IsOurs(__builtin_return_address(0))

std::set<GLuint> OwnShaders;
std::set<GLuint> OwnPrograms;

//------------------------------------------------------------------------------
// The functions behind the pointers.
#define REAL(name) decltype(gl##name) Real##name = nullptr;
REAL(BufferData)
REAL(BufferStorage)
REAL(TexImage3D)
REAL(TexStorage2D)
REAL(TexStorage3D)
REAL(TexImage2DMultisample)
REAL(TexStorage2DMultisample)
REAL(TexBuffer)
REAL(RenderbufferStorage)
REAL(RenderbufferStorageMultisample)
REAL(CheckFramebufferStatus)
REAL(ShaderSource)
REAL(AttachShader)
REAL(DeleteShader)
REAL(DeleteProgram)
REAL(GetShaderiv)
REAL(GetProgramiv)
REAL(MapBuffer)
REAL(MapBufferRange)
REAL(GenQueries)
REAL(BeginQuery)
REAL(EndQuery)
REAL(GetQueryObjectuiv)
#undef REAL

constexpr GLsizeiptr TooLarge = static_cast<GLsizeiptr>(1) << 60;

/// As if memory had run out: by asking for more than there is.
void RunOutOfMemory()
{
  GLint bound = 0;
  GLuint buffer = 0;
  glGetIntegerv(GL_COPY_WRITE_BUFFER, &bound); // the same number as that of its binding
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
  RealBufferData(GL_COPY_WRITE_BUFFER, TooLarge, nullptr, GL_STATIC_DRAW);
  glBindBuffer(GL_COPY_WRITE_BUFFER, static_cast<GLuint>(bound));
  glDeleteBuffers(1, &buffer);
}

/// Of a call of vtkOIT; true when it has failed.
bool FailsToAllocate(FaultInjector::Kind kind, bool isOurs)
{
  const bool fails = isOurs && Hit(kind);
  if (fails)
  {
    RunOutOfMemory();
  }
  return fails;
}

//------------------------------------------------------------------------------
void GLAPIENTRY MyBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
  const bool fails = IS_OURS() && Hit(FaultInjector::Buffer);
  RealBufferData(target, fails ? TooLarge : size, fails ? nullptr : data, usage);
}

void GLAPIENTRY MyBufferStorage(GLenum target, GLsizeiptr size, const void* data, GLbitfield flags)
{
  if (!FailsToAllocate(FaultInjector::Buffer, IS_OURS()))
  {
    RealBufferStorage(target, size, data, flags);
  }
}

void GLAPIENTRY MyTexImage3D(GLenum target, GLint level, GLint internal, GLsizei width,
  GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels)
{
  if (!FailsToAllocate(FaultInjector::Texture, IS_OURS()))
  {
    RealTexImage3D(target, level, internal, width, height, depth, border, format, type, pixels);
  }
}

void GLAPIENTRY MyTexStorage2D(
  GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height)
{
  if (!FailsToAllocate(FaultInjector::Texture, IS_OURS()))
  {
    RealTexStorage2D(target, levels, format, width, height);
  }
}

void GLAPIENTRY MyTexStorage3D(
  GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height, GLsizei depth)
{
  if (!FailsToAllocate(FaultInjector::Texture, IS_OURS()))
  {
    RealTexStorage3D(target, levels, format, width, height, depth);
  }
}

void GLAPIENTRY MyTexImage2DMultisample(
  GLenum target, GLsizei samples, GLenum format, GLsizei width, GLsizei height, GLboolean isFixed)
{
  if (!FailsToAllocate(FaultInjector::Texture, IS_OURS()))
  {
    RealTexImage2DMultisample(target, samples, format, width, height, isFixed);
  }
}

void GLAPIENTRY MyTexStorage2DMultisample(
  GLenum target, GLsizei samples, GLenum format, GLsizei width, GLsizei height, GLboolean isFixed)
{
  if (!FailsToAllocate(FaultInjector::Texture, IS_OURS()))
  {
    RealTexStorage2DMultisample(target, samples, format, width, height, isFixed);
  }
}

void GLAPIENTRY MyTexBuffer(GLenum target, GLenum format, GLuint buffer)
{
  if (!FailsToAllocate(FaultInjector::Texture, IS_OURS()))
  {
    RealTexBuffer(target, format, buffer);
  }
}

void GLAPIENTRY MyRenderbufferStorage(GLenum target, GLenum format, GLsizei width, GLsizei height)
{
  if (!FailsToAllocate(FaultInjector::Renderbuffer, IS_OURS()))
  {
    RealRenderbufferStorage(target, format, width, height);
  }
}

void GLAPIENTRY MyRenderbufferStorageMultisample(
  GLenum target, GLsizei samples, GLenum format, GLsizei width, GLsizei height)
{
  if (!FailsToAllocate(FaultInjector::Renderbuffer, IS_OURS()))
  {
    RealRenderbufferStorageMultisample(target, samples, format, width, height);
  }
}

GLenum GLAPIENTRY MyCheckFramebufferStatus(GLenum target)
{
  const bool fails = IS_OURS() && Hit(FaultInjector::Framebuffer);
  return fails ? GL_FRAMEBUFFER_UNSUPPORTED : RealCheckFramebufferStatus(target);
}

void* GLAPIENTRY MyMapBuffer(GLenum target, GLenum access)
{
  const bool fails = FailsToAllocate(FaultInjector::Map, IS_OURS());
  return fails ? nullptr : RealMapBuffer(target, access);
}

void* GLAPIENTRY MyMapBufferRange(
  GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access)
{
  const bool fails = FailsToAllocate(FaultInjector::Map, IS_OURS());
  return fails ? nullptr : RealMapBufferRange(target, offset, length, access);
}

//------------------------------------------------------------------------------
// A query that could not begin cannot end, and has no result; without the errors that OpenGL would add.
bool IsQueryMissing = false;

void GLAPIENTRY MyGenQueries(GLsizei count, GLuint* names)
{
  if (!FailsToAllocate(FaultInjector::Query, IS_OURS()))
  {
    RealGenQueries(count, names);
  }
}

void GLAPIENTRY MyBeginQuery(GLenum target, GLuint name)
{
  IsQueryMissing = name == 0 || FailsToAllocate(FaultInjector::Query, IS_OURS());
  if (!IsQueryMissing)
  {
    RealBeginQuery(target, name);
  }
}

void GLAPIENTRY MyEndQuery(GLenum target)
{
  if (!IsQueryMissing)
  {
    RealEndQuery(target);
  }
  IsQueryMissing = false;
}

void GLAPIENTRY MyGetQueryObjectuiv(GLuint name, GLenum what, GLuint* value)
{
  if (glIsQuery(name) && !FailsToAllocate(FaultInjector::Query, IS_OURS()))
  {
    RealGetQueryObjectuiv(name, what, value);
  }
}

//------------------------------------------------------------------------------
// VTK compiles and links for us, so shaders are told apart by their texts.
void GLAPIENTRY MyShaderSource(
  GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths)
{
  if (count > 0 && std::strstr(texts[0], "oit"))
  {
    OwnShaders.insert(shader);
  }
  RealShaderSource(shader, count, texts, lengths);
}

void GLAPIENTRY MyAttachShader(GLuint program, GLuint shader)
{
  if (OwnShaders.count(shader) > 0)
  {
    OwnPrograms.insert(program);
  }
  RealAttachShader(program, shader);
}

void GLAPIENTRY MyDeleteShader(GLuint shader)
{
  OwnShaders.erase(shader);
  RealDeleteShader(shader);
}

void GLAPIENTRY MyDeleteProgram(GLuint program)
{
  OwnPrograms.erase(program);
  RealDeleteProgram(program);
}

void GLAPIENTRY MyGetShaderiv(GLuint shader, GLenum name, GLint* value)
{
  RealGetShaderiv(shader, name, value);
  if (name == GL_COMPILE_STATUS && OwnShaders.count(shader) > 0 && Hit(FaultInjector::Compile))
  {
    *value = GL_FALSE;
  }
}

void GLAPIENTRY MyGetProgramiv(GLuint program, GLenum name, GLint* value)
{
  RealGetProgramiv(program, name, value);
  if (name == GL_LINK_STATUS && OwnPrograms.count(program) > 0 && Hit(FaultInjector::Link))
  {
    *value = GL_FALSE;
  }
}

template <typename Function>
void Replace(Function& pointer, Function& real, Function mine)
{
  if (pointer && pointer != mine)
  {
    real = pointer;
    pointer = mine;
  }
}
}

//------------------------------------------------------------------------------
std::string FaultInjector::FindMissing()
{
  return {};
}

//------------------------------------------------------------------------------
void FaultInjector::Install()
{
#define REPLACE(name) Replace<decltype(gl##name)>(gl##name, Real##name, &My##name);
  REPLACE(BufferData)
  REPLACE(BufferStorage)
  REPLACE(TexImage3D)
  REPLACE(TexStorage2D)
  REPLACE(TexStorage3D)
  REPLACE(TexImage2DMultisample)
  REPLACE(TexStorage2DMultisample)
  REPLACE(TexBuffer)
  REPLACE(RenderbufferStorage)
  REPLACE(RenderbufferStorageMultisample)
  REPLACE(CheckFramebufferStatus)
  REPLACE(ShaderSource)
  REPLACE(AttachShader)
  REPLACE(DeleteShader)
  REPLACE(DeleteProgram)
  REPLACE(GetShaderiv)
  REPLACE(GetProgramiv)
  REPLACE(MapBuffer)
  REPLACE(MapBufferRange)
  REPLACE(GenQueries)
  REPLACE(BeginQuery)
  REPLACE(EndQuery)
  REPLACE(GetQueryObjectuiv)
#undef REPLACE
}
#else
//------------------------------------------------------------------------------
std::string FaultInjector::FindMissing()
{
  return "only on Linux is it known here which library calls OpenGL";
}

//------------------------------------------------------------------------------
void FaultInjector::Install() {}
#endif

//------------------------------------------------------------------------------
const char* FaultInjector::GetName(Kind kind)
{
  static constexpr std::array<const char*, NumberOfKinds> names{ "buffer", "texture",
    "renderbuffer", "framebuffer", "compile", "link", "map", "query" };
  return names[kind];
}

//------------------------------------------------------------------------------
void FaultInjector::Reset()
{
  Fail(NumberOfKinds, 0, false);
}

//------------------------------------------------------------------------------
void FaultInjector::Fail(Kind kind, int number, bool fromThenOn)
{
  Calls = {};
  Faults = 0;
  FailingKind = kind;
  FirstToFail = number;
  FailsFromThenOn = fromThenOn;
}

//------------------------------------------------------------------------------
int FaultInjector::GetNumberOfCalls(Kind kind)
{
  return Calls[kind];
}

//------------------------------------------------------------------------------
int FaultInjector::GetNumberOfFaults()
{
  return Faults;
}
}
