// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITSharedDepth_h
#define vtkOITSharedDepth_h

#include "Private/GL/vtkOITFramebuffer.h"

class vtkOpenGLState;

/// Binds `framebuffer` for drawing into `color` under the depth test against the depth buffer of
/// the framebuffer that was bound before: the opaque geometry, without a copy. Its pixels keep
/// their places, so the colour must reach up to the last pixel that is drawn. Fails, and
/// nothing is bound, where there is no such depth buffer or the driver does not take the two
/// together.
vtkOITFailure vtkOITBindWithSharedDepth(
  vtkOpenGLState* state, GLuint framebuffer, const vtkOITAttachment& color);

/// The same, for drawing into what the framebuffer that was bound before draws into, at
/// GL_COLOR_ATTACHMENT0, and into `color` at GL_COLOR_ATTACHMENT1.
vtkOITFailure vtkOITBindBeside(
  vtkOpenGLState* state, GLuint framebuffer, const vtkOITAttachment& color);

#endif
