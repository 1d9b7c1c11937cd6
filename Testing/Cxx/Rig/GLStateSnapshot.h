// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What OpenGL's state is at a moment, asked of OpenGL itself, by name.
 */

#ifndef GLStateSnapshot_h
#define GLStateSnapshot_h

#include <map>
#include <string>
#include <vector>

class vtkOpenGLState;

namespace vtkOITTest
{
class GLStateSnapshot
{
public:
  /// Drawing a prop leaves its program, vertex array and vertex buffer bound, whatever pass it is
  /// drawn by; VTK binds its own before each use. They are compared only with WithDrawing.
  enum Extent
  {
    WithoutDrawing,
    WithDrawing
  };

  static GLStateSnapshot Take(Extent extent);

  /// "name: before -> after" for each difference.
  std::vector<std::string> FindChanges(const GLStateSnapshot& after) const;

  /// What the cache of VTK's state object holds that OpenGL does not.
  static std::vector<std::string> FindStaleCache(vtkOpenGLState* state);

private:
  std::map<std::string, std::string> Values;
};
}

#endif
