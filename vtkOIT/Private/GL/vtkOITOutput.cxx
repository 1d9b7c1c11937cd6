// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITOutput.h"

#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITShaderText.h"

#include "vtkOITFullScreenVS.h"
#include "vtkOITOutputFS.h"

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

//------------------------------------------------------------------------------
void vtkOITOutputStage::Render(const vtkOITFrame& frame,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  const bool byFetch = vtkOITWritesByFetch(frame);
  if (byFetch != this->ByFetch)
  {
    this->Stage.Release();
    this->ByFetch = byFetch;
  }
  vtkOpenGLState* state = frame.GLState;
  vtkOITSetOutputBlending(state, byFetch);
  state->vtkglDisable(GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  this->Stage.Render(
    frame.Window, vtkOITFullScreenVS,
    [&]
    {
      std::string text = getFragmentShader();
      vtkOITReplace(
        text, "//VTK::System::Dec", "//VTK::System::Dec\n" + vtkOITGetOutputHeader(byFetch));
      vtkOITReplace(text, "//VTK::OIT::Output", vtkOITOutputFS);
      return text;
    },
    setUniforms);
}
