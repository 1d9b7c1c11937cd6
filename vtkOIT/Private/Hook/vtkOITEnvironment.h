// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITEnvironment_h
#define vtkOITEnvironment_h

#include <string>

/**
 * What the environment asks of vtkOIT in a program that does not know it:
 *
 * - VTKOIT_AUTOLOAD: 1 (default) for all renderers, `respect` for those with depth peeling on, 0 for
 *   none.
 * - VTKOIT_METHOD: a method's name, default `auto`.
 * - VTKOIT_LOG: 1 to say what was reached; default 0.
 *
 * An empty value is the default.
 */
struct vtkOITEnvironment
{
  bool On = true;
  bool Respect = false;
  bool Log = false;
  std::string Method = "auto"; // not looked at: whether there is one of that name
  std::string Error;           // one line, where a value is wrong; Off then

  static vtkOITEnvironment Read();
};

#endif
