// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Auto/vtkOITDepthCheck.h"

#include "Private/GL/vtkOITSavedState.h"

#include "vtkOITDepthCheckFS.h"
#include "vtkOITFullScreenVS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
// Mappers count their units up from 0 and GL has at least 16.
constexpr int KeptUnit = 14;
constexpr int NowUnit = 15;
}

//------------------------------------------------------------------------------
void vtkOITDepthCheck::Keep(const vtkOITFrame& frame)
{
  this->Kept.Copy(frame, frame.FindStorage(frame.Rectangle), frame.Rectangle, KeptUnit);
  this->Kept.Unbind(frame.GLState, KeptUnit);
}

//------------------------------------------------------------------------------
bool vtkOITDepthCheck::IsUnchanged(const vtkOITFrame& frame)
{
  vtkOpenGLState* state = frame.GLState;
  const vtkOITSavedState saved(state, false); // the frame is drawn next when something has changed
  this->Now.Copy(frame, frame.FindStorage(frame.Rectangle), frame.Rectangle, NowUnit);
  this->Kept.Bind(state, KeptUnit);
  state->vtkglEnable(GL_SCISSOR_TEST);
  const vtkOITRectangle& r = frame.Rectangle;
  state->vtkglScissor(r.X, r.Y, r.Width, r.Height);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  this->Query.Begin(frame.Window, 0);
  const bool isDrawn = this->Stage.Render(
    frame.Window, vtkOITFullScreenVS, [] { return std::string(vtkOITDepthCheckFS); },
    [](vtkShaderProgram* program)
    {
      program->SetUniformi("oitDepth", NowUnit);
      program->SetUniformi("oitKeptDepth", KeptUnit);
    });
  vtkOITOcclusionQueries::End();
  this->Kept.Unbind(state, KeptUnit);
  this->Now.Unbind(state, NowUnit);
  return isDrawn && this->Query.GetResult(0) == 0;
}

//------------------------------------------------------------------------------
void vtkOITDepthCheck::Release()
{
  this->Kept.Release();
  this->Now.Release();
  this->Query.Release();
  this->Stage.Release();
}
