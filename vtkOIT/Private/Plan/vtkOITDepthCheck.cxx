// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Plan/vtkOITDepthCheck.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITShaderText.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITDepthCheckFS.h"
#include "vtkOITFullScreenVS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkOITFailure vtkOITDepthCheck::Keep(const vtkOITFrame& frame)
{
  frame.BeginGeometry(frame.Rectangle);
  vtkOITFailure failure =
    this->Kept.Copy(frame, frame.FindStorage(frame.Rectangle), frame.Rectangle, OIT_UNIT_GATHERED);
  if (!failure)
  {
    this->Kept.Unbind(frame.GLState, OIT_UNIT_GATHERED);
  }
  return failure;
}

//------------------------------------------------------------------------------
bool vtkOITDepthCheck::IsUnchanged(const vtkOITFrame& frame)
{
  vtkOpenGLState* state = frame.GLState;
  frame.BeginOutput(frame.Rectangle);
  if (this->Now.Copy(frame, frame.FindStorage(frame.Rectangle), frame.Rectangle, OIT_UNIT_DEPTH))
  {
    return false;
  }
  this->Kept.Bind(state, OIT_UNIT_GATHERED);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  this->Query.StartRow(frame.Window);
  this->Query.Begin(0);
  const vtkOITFailure failure = this->Stage.Render(
    frame.Window, vtkOITFullScreenVS,
    [] { return vtkOITShaderText({ vtkOITDepthCheckFS }).GetText(); },
    [](vtkShaderProgram* program)
    {
      program->SetUniformi("oitDepth", OIT_UNIT_DEPTH);
      program->SetUniformi("oitKeptDepth", OIT_UNIT_GATHERED);
    });
  this->Query.End();
  this->Kept.Unbind(state, OIT_UNIT_GATHERED);
  this->Now.Unbind(state, OIT_UNIT_DEPTH);
  return !failure && this->Query.GetResult(0) == 0;
}

//------------------------------------------------------------------------------
void vtkOITDepthCheck::Release()
{
  this->Kept.Release();
  this->Now.Release();
  this->Query.Release();
  this->Stage.Release();
}
