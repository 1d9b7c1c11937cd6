// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Frame/vtkOITFrame.h"

#include "Private/Frame/vtkOITCompatibility.h"

#include "vtkOpenGLState.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkOITFrame vtkOITFrame::Inside(const vtkOITRectangle& rectangle) const
{
  vtkOITFrame frame = *this;
  frame.Rectangle = this->Rectangle.Intersect(rectangle);
  return frame;
}

//------------------------------------------------------------------------------
vtkOITFrame vtkOITFrame::On(const vtkOITTarget& target) const
{
  vtkOITFrame frame = *this;
  frame.Target = target;
  return frame;
}

//------------------------------------------------------------------------------
vtkOITRectangle vtkOITFrame::FindStorage(const vtkOITRectangle& band) const
{
  constexpr int step = 64;
  const auto extend = [](int end, int largest)
  { return std::min((end + step - 1) / step * step, largest); };
  return { 0, 0, extend(band.X + band.Width, this->Viewport.X + this->Viewport.Width),
    extend(band.Y + band.Height, this->Viewport.Y + this->Viewport.Height) };
}

//------------------------------------------------------------------------------
void vtkOITFrame::BeginGeometry(const vtkOITRectangle& band) const
{
  vtkOpenGLState* state = this->GLState;
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Target.Framebuffer);
  this->Target.DrawToAllBuffers();
  this->BeginStorage(band, { 0, 0, 0, 0 });
}

//------------------------------------------------------------------------------
void vtkOITFrame::BeginStorage(const vtkOITRectangle& band, const vtkOITRectangle& storage) const
{
  vtkOpenGLState* state = this->GLState;
  const vtkOITRectangle& viewport = this->Viewport;
  state->vtkglViewport(
    viewport.X - storage.X, viewport.Y - storage.Y, viewport.Width, viewport.Height);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(band.X - storage.X, band.Y - storage.Y, band.Width, band.Height);
  state->SetEnumState(GL_DEPTH_TEST, this->Target.TestsDepth);
  state->vtkglDepthFunc(this->Target.DepthFunction);
  state->SetEnumState(GL_CULL_FACE, this->Target.CullsFaces);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

//------------------------------------------------------------------------------
void vtkOITFrame::BeginOutput(const vtkOITRectangle& band) const
{
  vtkOpenGLState* state = this->GLState;
  this->BeginGeometry(band);
  this->Target.DrawToFirstBuffer();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
}
