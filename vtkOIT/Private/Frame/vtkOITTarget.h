// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITTarget_h
#define vtkOITTarget_h

#include <array>

/**
 * A framebuffer that is drawn into, and facts about it that decide how fragments are captured and
 * composited.
 */
struct vtkOITTarget
{
  /// The framebuffer, 0 the default one, and its draw buffers.
  unsigned int Framebuffer = 0;
  std::array<unsigned int, 8> DrawBuffers{};
  int NumberOfDrawBuffers = 0;
  /// Samples per pixel, 0 without multisampling.
  int Samples = 0;
  /// Fixed-point colour of at most 10 bits, linear: llvmpipe blends such a target in its own bits,
  /// so a shader that reads the destination is more accurate.
  bool CoarseColor = false;
  /// Fixed-point colour: OpenGL clamps what a shader writes to [0, 1] before it blends.
  bool ClampsColor = false;
  /// Format of the depth buffer, 0 bits without one.
  int DepthBits = 0;
  int StencilBits = 0;
  bool FloatDepth = false;
  /// The depth test and the culling of faces as they were found.
  bool TestsDepth = true;
  unsigned int DepthFunction = 0;
  bool CullsFaces = false;

  /// Asks GL about the framebuffer bound for drawing and the state as it is.
  static vtkOITTarget Query();

  /// Of the depth test: 1 the nearer passes, 2 the equal, 4 the farther.
  int GetDepthRelations() const;
  /// The bits of a fixed-point depth buffer of at most 24 bits, otherwise 0: those that a shader
  /// must compare as the hardware does.
  int GetFixedDepthBits() const
  {
    return !this->FloatDepth && this->DepthBits <= 24 ? this->DepthBits : 0;
  }

  /// Draws into the first of its buffers only, or into all; it is bound.
  ///@{
  void DrawToFirstBuffer() const;
  void DrawToAllBuffers() const;
  ///@}
};

#endif
