// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITOutput_h
#define vtkOITOutput_h

#include <string>

class vtkOpenGLState;
class vtkOITFrame;

/// How a stage with vtkOITOutputFS.glsl puts layers over the frame's target: by framebuffer fetch
/// where blending would be less accurate and shaders can read the target, otherwise by blending.
bool vtkOITWritesByFetch(const vtkOITFrame& frame);

/// What such a shader needs at its top.
std::string vtkOITGetOutputHeader(bool byFetch);

/// The blending that it needs.
void vtkOITSetOutputBlending(vtkOpenGLState* state, bool byFetch);

#endif
