// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITPixelStatistics.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITReadback.h"
#include "Private/GL/vtkOITShaderText.h"
#include "glsl/Common/vtkOITConstants.h"

#include "vtkOITFullScreenVS.h"
#include "vtkOITReduceFS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace
{
constexpr int BlockSize = OIT_BLOCK_SIZE;
constexpr int Unit = OIT_UNIT_STATE;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITPixelStatistics::Reduce(const vtkOITFrame& frame,
  const vtkOITTextureArray& array, const vtkOITRectangle& region, Result& result)
{
  vtkOpenGLState* state = frame.GLState;
  const int width = (region.Width + BlockSize - 1) / BlockSize;
  const int height = (region.Height + BlockSize - 1) / BlockSize;
  if (vtkOITFailure failure = this->Sums.Reserve(frame.Window, width, height, 1, GL_RGBA32F))
  {
    return failure;
  }
  if (vtkOITFailure failure = this->Framebuffer.Bind(frame.Window, { this->Sums.GetLayer(0) }))
  {
    return failure;
  }
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, this->Framebuffer.GetName());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, 0, width, height);
  const int first[2] = { region.X, region.Y };
  const int last[2] = { region.X + region.Width - 1, region.Y + region.Height - 1 };
  vtkOITFailure failure = this->Stage.Render(
    frame.Window, vtkOITFullScreenVS, [] { return vtkOITShaderText({ vtkOITReduceFS }).GetText(); },
    [&](vtkShaderProgram* program)
    {
      array.Bind(state, Unit);
      program->SetUniformi("oitState", Unit);
      program->SetUniform2i("oitFirstPixel", first);
      program->SetUniform2i("oitLastPixel", last);
    });
  vtkOITTextureArray::Unbind(state, Unit);
  if (failure)
  {
    return failure;
  }
  std::vector<std::array<float, 4>> sums(static_cast<std::size_t>(width) * height);
  {
    const vtkOITReadback readback;
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, sums.data());
  }
  result = {};
  for (const std::array<float, 4>& block : sums)
  {
    result.Fragments += static_cast<std::int64_t>(block[0]);
    result.MostFragments = std::max(result.MostFragments, static_cast<int>(block[1]));
    result.ErrorBound = std::max(result.ErrorBound, static_cast<double>(block[2]));
    result.Lost += static_cast<std::int64_t>(block[3]);
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkOITPixelStatistics::Release()
{
  this->Sums.Release();
  this->Framebuffer.Release();
  this->Stage.Release();
}
