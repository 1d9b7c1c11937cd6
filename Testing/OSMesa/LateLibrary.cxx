// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The library of TestLateLibrary: it uses VTK and calls OpenGL itself.
#include "vtkOpenGLRenderWindow.h"
#include "vtk_glew.h"

extern "C" __attribute__((visibility("default"))) const char* GetRenderer()
{
  vtkOpenGLRenderWindow::GetGlobalMaximumNumberOfMultiSamples(); // so that VTK is needed
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}
