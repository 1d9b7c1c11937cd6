// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITNeutralState_h
#define vtkOITNeutralState_h

#include "Private/Frame/vtkOITCompatibility.h"

#include <array>

class vtkOpenGLState;

/**
 * While it lives, states have their initial values that neither VTK nor a pass sets, but that change
 * what is drawn: an application may have left them otherwise, with plain GL calls. At its end they
 * are as they were.
 *
 * The logic operation on colours, polygon mode and offset, the side that is the front, primitive
 * restart, sample masks, clip distances; colour masks and blending of single draw buffers; textures
 * and samplers of the units that passes use.
 */
class vtkOITNeutralState
{
public:
  explicit vtkOITNeutralState(vtkOpenGLState* state);
  ~vtkOITNeutralState();
  vtkOITNeutralState(const vtkOITNeutralState&) = delete;
  vtkOITNeutralState& operator=(const vtkOITNeutralState&) = delete;

  /// What was found is set again, for a part of the frame that VTK draws by itself; and neutral
  /// after it.
  ///@{
  void SetAgain() const;
  void SetNeutral() const;
  ///@}

  /// What was found of the first draw buffer, and the texture unit that was active.
  ///@{
  const std::array<GLboolean, 4>& GetColorMask() const { return this->ColorMasks[0]; }
  bool GetBlends() const { return this->Blends[0] == GL_TRUE; }
  GLint GetActiveTexture() const { return this->ActiveTexture; }
  ///@}

private:
  static constexpr int Units = 4;   // see glsl/Common/vtkOITConstants.h
  static constexpr int Targets = 4; // of a unit
  static constexpr int Buffers = 8;

  void SaveTextures();
  void RestoreTextures() const;

  vtkOpenGLState* State;
  std::array<GLboolean, 14> Enabled{};
  GLint LogicOperation = GL_COPY;
  GLint FrontFace = GL_CCW;
  GLint PolygonMode[2] = { GL_FILL, GL_FILL };
  std::array<std::array<GLboolean, 4>, Buffers> ColorMasks{};
  std::array<GLboolean, Buffers> Blends{};
  bool HasBuffersApart = false; // masks or blending
  GLint ActiveTexture = GL_TEXTURE0;
  std::array<std::array<GLint, Targets>, Units> Textures{};
  std::array<GLint, Units> Samplers{};
};

#endif
