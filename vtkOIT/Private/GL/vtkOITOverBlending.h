// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITOverBlending_h
#define vtkOITOverBlending_h

#include "Private/Frame/vtkOITCompatibility.h"

#include "vtkOpenGLState.h"

/**
 * While one lives, colour buffers are blended over what they hold, premultiplied, in the order of
 * drawing: coincident fragments become a layer in which the last lies on top. In one of the buffers
 * red, green and blue keep the maximum instead, and alpha sums up. What has alpha 0 is added.
 *
 * Needs ARB_draw_buffers_blend.
 */
class vtkOITOverBlending
{
public:
  vtkOITOverBlending(vtkOpenGLState* state, GLuint maximumBuffer)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBlendEquationSeparatei(maximumBuffer, GL_MAX, GL_FUNC_ADD);
    glBlendFuncSeparatei(maximumBuffer, GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  }
  /// VTK's cache knows of one way of blending for all.
  ~vtkOITOverBlending()
  {
    glBlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
    glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  vtkOITOverBlending(const vtkOITOverBlending&) = delete;
  vtkOITOverBlending& operator=(const vtkOITOverBlending&) = delete;
};

#endif
