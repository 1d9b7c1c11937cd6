// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITSavedState_h
#define vtkOITSavedState_h

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITRectangle.h"
#include "Private/Frame/vtkOITTarget.h"
#include "Private/GL/vtkOITNeutralState.h"

#include <array>

class vtkOpenGLState;

/**
 * Saves the GL state that a pass may touch when it is made, and restores it when it is destroyed:
 * once a frame.
 *
 * States that vtkOpenGLState caches are restored through it, and its cache is made true at the
 * start, because an application may have changed them with plain GL calls: framebuffers, active
 * texture, viewport, scissor, blend function and equation, depth function and mask, colour mask,
 * cull face, and the capabilities blend, depth test, scissor test, cull face and multisample. The
 * others are restored with GL calls: draw buffers of the bound framebuffer, the bound renderbuffer
 * and vertex array, and after AddStorage() image units and storage buffers. States that a pass only
 * wants to be neutral are those of vtkOITNeutralState.
 */
class vtkOITSavedState
{
public:
  /// `target`: as it was queried just before.
  vtkOITSavedState(vtkOpenGLState* state, const vtkOITTarget& target);
  ~vtkOITSavedState();
  vtkOITSavedState(const vtkOITSavedState&) = delete;
  vtkOITSavedState& operator=(const vtkOITSavedState&) = delete;

  /// Saves image units and storage buffer bindings as well, those that engines use; before the
  /// first engine that uses them. Needs a context that has them.
  void AddStorage();

  /// What was saved is set again, for a part of the frame that VTK draws by itself.
  void SetAgain() const;
  /// And after that part.
  void SetNeutral() const { this->Neutral.SetNeutral(); }

  const vtkOITRectangle& GetViewport() const { return this->Viewport; }
  /// The scissor, or the viewport where there is none.
  const vtkOITRectangle& GetDrawnRectangle() const;

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
  static constexpr int BindingCount = 2; // from 0 on, see glsl/Common/vtkOITConstants.h

  void Restore() const;
  void RestoreStorage() const;

  vtkOpenGLState* State;
  vtkOITNeutralState Neutral;
  vtkOITTarget Target;
  bool HasStorage = false;
  GLint ReadFramebuffer = 0;
  GLint Renderbuffer = 0;
  GLint VertexArray = 0;
  GLint CullFaceMode = GL_BACK;
  GLboolean DepthMask = GL_TRUE;
  vtkOITRectangle Viewport;
  vtkOITRectangle Scissor;
  std::array<GLint, 4> BlendFunction{};
  std::array<GLint, 2> BlendEquation{};
  bool TestsScissor = false;
  bool Multisamples = false;
  std::array<ImageUnit, BindingCount> ImageUnits;
  std::array<StorageBinding, BindingCount> StorageBindings;
  GLint StorageBuffer = 0;
};

#endif
