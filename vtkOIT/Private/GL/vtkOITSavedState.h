// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITSavedState_h
#define vtkOITSavedState_h

#include "Private/Frame/vtkOITCompatibility.h"

#include <array>

class vtkOpenGLState;

/**
 * Saves the GL state that a pass may touch when it is made, and restores it when it is destroyed.
 *
 * States that vtkOpenGLState caches are restored through it, so that its cache stays true:
 * framebuffers, active texture, viewport, scissor, blend function and equation, depth function and
 * mask, colour mask, cull face, and the capabilities blend, depth test, scissor test, cull face
 * and multisample. The others are restored with GL calls: draw buffers of the bound framebuffer,
 * image units, indexed and generic storage buffers, the bound renderbuffer.
 *
 * A pass uses image units and storage buffer bindings from 0 to BindingCount - 1 only.
 */
class vtkOITSavedState
{
public:
  /// `withStorage`: the context has image units and storage buffers, so save those too.
  vtkOITSavedState(vtkOpenGLState* state, bool withStorage);
  ~vtkOITSavedState();
  vtkOITSavedState(const vtkOITSavedState&) = delete;
  vtkOITSavedState& operator=(const vtkOITSavedState&) = delete;

  static constexpr int BindingCount = 3;

private:
  struct ImageUnit
  {
    GLint Name = 0;
    GLint Level = 0;
    GLint Layered = 0;
    GLint Layer = 0;
    GLint Access = GL_READ_ONLY;
    GLint Format = GL_R8;
  };
  struct StorageBinding
  {
    GLint Name = 0;
    GLint64 Start = 0;
    GLint64 Size = 0;
  };

  void SaveStorage();
  void RestoreStorage();

  vtkOpenGLState* State;
  bool WithStorage;
  GLint DrawFramebuffer = 0;
  GLint ReadFramebuffer = 0;
  GLint Renderbuffer = 0;
  GLint ActiveTexture = GL_TEXTURE0;
  GLint DepthFunction = GL_LEQUAL;
  GLint CullFaceMode = GL_BACK;
  GLboolean DepthMask = GL_TRUE;
  std::array<GLint, 4> Viewport{};
  std::array<GLint, 4> Scissor{};
  std::array<GLint, 4> BlendFunction{};
  std::array<GLint, 2> BlendEquation{};
  std::array<GLboolean, 4> ColorMask{};
  std::array<GLboolean, 5> Enabled{};
  std::array<GLenum, 8> DrawBuffers{};
  GLint DrawBufferCount = 0;
  std::array<ImageUnit, BindingCount> ImageUnits;
  std::array<StorageBinding, BindingCount> StorageBindings;
  GLint StorageBuffer = 0;
};

#endif
