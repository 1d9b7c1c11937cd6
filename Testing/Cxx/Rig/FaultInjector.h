// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Makes OpenGL calls of vtkOIT fail: the one of a number, or that one and all after it.
 *
 * VTK calls OpenGL through pointers that its loader, GLEW or GLAD, has as global variables. They
 * are replaced by functions that count, and where a call is to fail do what a driver does: leave a
 * GL_OUT_OF_MEMORY, or give back another status. Calls of VTK itself go through: a call is ours
 * when its return address is in the library of vtkOIT, a shader when its text contains "oit", a
 * program when one of its shaders is ours.
 */

#ifndef FaultInjector_h
#define FaultInjector_h

#include <array>
#include <string>

namespace vtkOITTest
{
class FaultInjector
{
public:
  enum Kind
  {
    Buffer,       // glBufferData, glBufferStorage: no memory
    Texture,      // glTexImage*, glTexStorage*, glTexBuffer: no memory
    Renderbuffer, // glRenderbufferStorage*: no memory
    Framebuffer,  // glCheckFramebufferStatus: not supported
    Compile,      // glGetShaderiv(GL_COMPILE_STATUS): false
    Link,         // glGetProgramiv(GL_LINK_STATUS): false
    Map,          // glMapBuffer*: no address
    Query,        // glGenQueries: no names; glBeginQuery: not begun; glGetQueryObjectuiv: no value
    NumberOfKinds
  };
  static const char* GetName(Kind kind);

  /// Empty, or why calls cannot be told apart here.
  static std::string FindMissing();

  /// Replaces the pointers, where that is not done: to be called again when a window has made a
  /// context, as its loader sets them.
  static void Install();

  /// Counts from 0 again. Nothing fails.
  static void Reset();
  /// Counts from 0 again: the call of this kind and number, from 1, fails, or from it on all.
  static void Fail(Kind kind, int number, bool fromThenOn);

  /// Calls of vtkOIT, and those that have failed, since then.
  static int GetNumberOfCalls(Kind kind);
  static int GetNumberOfFaults();
};
}

#endif
