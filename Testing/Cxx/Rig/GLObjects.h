// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL for tests that look behind VTK's back, whichever loader the VTK in use has.
 */

#ifndef GLObjects_h
#define GLObjects_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <string>

namespace vtkOITTest
{
/// Whether the current context has an extension, hidden from vtkOITCapabilities or not.
bool HasGLExtension(const std::string& name);

/// Objects that exist in the current context, found by asking for every name up to a bound.
struct GLObjectCounts
{
  int Textures = 0;
  int Buffers = 0;
  int Programs = 0;
  int Shaders = 0;
  int Framebuffers = 0;
  int Renderbuffers = 0;
  int Queries = 0;
  int VertexArrays = 0;

  static GLObjectCounts OfCurrentContext();
  std::string Describe() const;
  /// The number of queries may differ by less than QueryTolerance: how many are needed depends on
  /// which results are there in time, here and in VTK's own timers. To leak the fewest that a pass
  /// makes, twelve, in each of the 48 attachments of TestResources is more.
  bool operator==(const GLObjectCounts& other) const;
  static constexpr int QueryTolerance = 512;
};
}

#endif
