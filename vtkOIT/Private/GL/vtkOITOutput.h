// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITOutput_h
#define vtkOITOutput_h

#include "Private/GL/vtkOITScreenStage.h"

class vtkOITShaderText;
class vtkOpenGLState;
struct vtkOITFrame;

/// How a stage with vtkOITOutputFS.glsl puts layers over the frame's target: by framebuffer fetch
/// where blending would be less accurate and shaders can read the target, otherwise by blending.
bool vtkOITWritesByFetch(const vtkOITFrame& frame);

/// Inserts vtkOITOutputFS.glsl at //VTK::OIT::Output of such a stage.
void vtkOITAddOutput(vtkOITShaderText& text, bool byFetch);

/// The blending that it needs.
void vtkOITSetOutputBlending(vtkOpenGLState* state, bool byFetch);

/// The last stage of a pass: puts the layers of all pixels over the frame's target.
class vtkOITOutputStage
{
public:
  /// Draws over the frame's target, which is bound for output (vtkOITFrame::BeginOutput).
  /// `getFragmentShader` makes a text with //VTK::OIT::Output once, and again when the target asks
  /// for another way to write.
  vtkOITFailure Render(const vtkOITFrame& frame,
    const std::function<vtkOITShaderText()>& getFragmentShader,
    const std::function<void(vtkShaderProgram*)>& setUniforms);
  void Release() { this->Stage.Release(); }

private:
  vtkOITScreenStage Stage;
  bool ByFetch = false; // of its program
};

#endif
