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
void vtkOITAddOutput(vtkOITShaderText& text, bool byFetch)
{
  text.Insert("Output", vtkOITOutputFS).Define("OIT_FRAMEBUFFER_FETCH", byFetch);
  if (byFetch)
  {
    text.Require({ "GL_EXT_shader_framebuffer_fetch" });
  }
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
vtkOITFailure vtkOITOutputStage::Render(const vtkOITFrame& frame,
  const std::function<vtkOITShaderText()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  const bool byFetch = vtkOITWritesByFetch(frame);
  if (byFetch != this->ByFetch)
  {
    this->Stage.Release();
    this->ByFetch = byFetch;
  }
  vtkOITSetOutputBlending(frame.GLState, byFetch);
  return this->Stage.Render(
    frame.Window, vtkOITFullScreenVS,
    [&]
    {
      vtkOITShaderText text = getFragmentShader();
      vtkOITAddOutput(text, byFetch);
      return text.GetText();
    },
    setUniforms);
}
