// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITOutput.h"

#include "vtkOITCapabilities.h"
#include "vtkOITCompatibility.h"
#include "vtkOITFrame.h"
#include "vtkOITShaderText.h"

#include "vtkOpenGLState.h"

//------------------------------------------------------------------------------
bool vtkOITWritesByFetch(const vtkOITFrame& frame)
{
  return frame.Capabilities->FramebufferFetch && frame.Target.CoarseColor &&
    frame.Target.Samples == 0;
}

//------------------------------------------------------------------------------
std::string vtkOITGetOutputHeader(bool byFetch)
{
  return byFetch ? vtkOITRequireExtensions({ "GL_EXT_shader_framebuffer_fetch" }) +
      "#define OIT_FRAMEBUFFER_FETCH\n"
                 : std::string();
}

//------------------------------------------------------------------------------
void vtkOITSetOutputBlending(vtkOpenGLState* state, bool byFetch)
{
  if (byFetch)
  {
    state->vtkglDisable(GL_BLEND);
    return;
  }
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}
