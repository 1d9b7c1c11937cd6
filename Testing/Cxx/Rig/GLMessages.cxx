// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Rig/GLMessages.h"

#include "Rig/GLObjects.h"

#include <algorithm>
#include <map>

namespace vtkOITTest
{
namespace
{
// What a driver says again and again in other words does not fill the memory.
constexpr std::size_t MostMessages = 100;

std::map<std::string, int> Messages;
int Pauses = 0;

/// Whether a test is to fail for it. Being out of memory is an answer to a call and no fault of it:
/// what becomes of the picture then is tested by itself.
bool IsFault(GLenum source, GLenum type, const std::string& text)
{
  if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
  {
    return text.find("GL_OUT_OF_MEMORY") == std::string::npos;
  }
  // Warnings on a shader: VTK's own are not ours to mend.
  return source == GL_DEBUG_SOURCE_SHADER_COMPILER && text.find("oit") != std::string::npos;
}

void GLAPIENTRY Keep(
  GLenum source, GLenum type, GLuint, GLenum, GLsizei length, const GLchar* message, const void*)
{
  std::string text = length < 0 ? std::string(message) : std::string(message, length);
  if (Pauses > 0 || !IsFault(source, type, text))
  {
    return;
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (Messages.size() < MostMessages || Messages.count(text) > 0)
  {
    ++Messages[text];
  }
}
}

//------------------------------------------------------------------------------
void GLMessages::Watch()
{
  // The loader's pointer is null where the context has no messages.
  if (glDebugMessageCallback)
  {
    glDebugMessageCallback(&Keep, nullptr);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS); // a debugger's breakpoint is at the call
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> GLMessages::Take()
{
  std::vector<std::string> lines;
  for (const auto& [text, count] : Messages)
  {
    lines.push_back(text + " (" + std::to_string(count) + " times)");
  }
  Messages.clear();
  return lines;
}

//------------------------------------------------------------------------------
GLMessages::Pause::Pause()
{
  ++Pauses;
}

//------------------------------------------------------------------------------
GLMessages::Pause::~Pause()
{
  --Pauses;
}
}
