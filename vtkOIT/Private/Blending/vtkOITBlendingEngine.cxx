// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Blending/vtkOITBlendingEngine.h"

#include "Private/Blending/vtkOITLayerTarget.h"
#include "Private/Engine/vtkOITGeometry.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/Frame/vtkOITStatistics.h"
#include "Private/GL/vtkOITOutput.h"

#include "vtkOITBlendFS.h"
#include "vtkOITFragmentFS.h"

#include "vtkOpenGLState.h"

//------------------------------------------------------------------------------
void vtkOITBlendingEngine::SetStage(const vtkOITFrame& frame)
{
  vtkOITShaderText text({ vtkOITFragmentFS, vtkOITBlendFS });
  if (this->LayerBeside)
  {
    vtkOITLayerTarget::AddOutputBeside(text);
  }
  text.Define("OIT_CLAMP_COLOR", frame.Target.ClampsColor);
  vtkOITAddOutput(text, vtkOITWritesByFetch(frame));
  this->Gather.SetStage(text);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITBlendingEngine::Draw(const vtkOITFrame& frame, const vtkOITSettings&,
  vtkOITGeometry& geometry, vtkOITStatistics& statistics)
{
  this->SetStage(frame);
  frame.BeginGeometry(this->Steps->Rectangle.Intersect(frame.Rectangle));
  if (!this->LayerBeside)
  {
    frame.Target.DrawToFirstBuffer();
  }
  vtkOpenGLState* state = frame.GLState;
  vtkOITSetOutputBlending(state, vtkOITWritesByFetch(frame));
  vtkOITFailure failure;
  bool hasDrawn = false;
  for (const vtkOITBlendSteps::Step& step : this->Steps->Steps)
  {
    this->Gather.SetUniforms(
      [this, state, &step, &hasDrawn](vtkShaderProgram* program, vtkProp* prop)
      {
        hasDrawn = true;
        if (this->LayerBeside)
        {
          this->LayerBeside->SetUniformsBeside(program);
        }
        // An actor may have been told to write depth; translucent ones must not.
        state->vtkglDepthMask(GL_FALSE);
        if (step.Side != vtkOITBlendSteps::Faces::All)
        {
          const bool cullsFront =
            (step.Side == vtkOITBlendSteps::Faces::Far) != this->Steps->IsInsideOut(prop);
          state->vtkglEnable(GL_CULL_FACE);
          state->vtkglCullFace(cullsFront ? GL_FRONT : GL_BACK);
        }
      });
    const bool isTop =
      this->LayerBeside && this->Steps->EndsWithTopLayers() && &step == &this->Steps->Steps.back();
    if (isTop)
    {
      vtkOITLayerTarget::WriteBeside(false);
    }
    failure = geometry.Draw(step.Props, this->Gather);
    if (isTop)
    {
      vtkOITLayerTarget::WriteBeside(true);
    }
    if (failure)
    {
      if (!hasDrawn)
      {
        failure.Undrawn = { frame.Rectangle };
      }
      break;
    }
  }
  this->Gather.SetUniforms({});
  statistics.NumberOfFragments = -1;
  statistics.MaximumDepthComplexity = -1;
  return failure;
}
