// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a context of OpenGL says against its calls by KHR_debug: errors, undefined behaviour, and
 * what its compiler says of names of ours.
 *
 * An error code tells that something was wrong since somebody asked the last time, and VTK asks
 * nearly never; a message tells of every call.
 */

#ifndef GLMessages_h
#define GLMessages_h

#include <string>
#include <vector>

namespace vtkOITTest
{
class GLMessages
{
public:
  /// From now on the messages of the current context are kept, where it has any: with OpenGL 4.3
  /// or KHR_debug. To be called again when a window has made a context, as VTK 9.6 takes the
  /// messages of its contexts to print them.
  static void Watch();

  /// The different messages since the last call, each one line with the number of times.
  static std::vector<std::string> Take();

  /// While it lives nothing is kept: errors that a test makes on purpose are none.
  class Pause
  {
  public:
    Pause();
    ~Pause();
    Pause(const Pause&) = delete;
    void operator=(const Pause&) = delete;
  };
};
}

#endif
