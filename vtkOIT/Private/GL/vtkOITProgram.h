// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITProgram_h
#define vtkOITProgram_h

#include "Private/Frame/vtkOITFailure.h"

#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// Makes the program of these texts, with VTK's marks in them, current. It is that of the window's
/// shader cache, so VTK finds it there, too. Where it does not compile or link, the reason has the
/// driver's first words; VTK prints nothing, and the next call tries again, which VTK's own ones
/// never do. `geometry` may be empty.
vtkOITFailure vtkOITReadyProgram(vtkOpenGLRenderWindow* window, const std::string& vertex,
  const std::string& geometry, const std::string& fragment, vtkShaderProgram*& program);

#endif
