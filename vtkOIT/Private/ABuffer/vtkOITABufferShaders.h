// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITABufferShaders_h
#define vtkOITABufferShaders_h

#include <array>
#include <string>

/**
 * The variant of the A-buffer's shaders that a frame needs, and their text. Changes only when the
 * pass's properties, the kind of framebuffer or the kind of pool change.
 */
struct vtkOITABufferShaders
{
  int Samples = 0;
  bool FloatColor = false;
  bool NodesInImage = false;
  bool FramebufferFetch = false;
  bool PostDepthCoverage = false;
  bool HeadInTarget = false;

  bool operator==(const vtkOITABufferShaders& other) const;
  bool operator!=(const vtkOITABufferShaders& other) const { return !(*this == other); }

  /// A node takes two texels instead of one.
  bool HasWideNodes() const { return this->FloatColor || this->Samples > 0; }
  int GetBytesPerNode() const { return this->HasWideNodes() ? 32 : 16; }

  /// Multisampled: the coverage after the depth test is not known to a shader, so it tests itself.
  bool NeedsDepthTest() const { return this->Samples > 0 && !this->PostDepthCoverage; }

  /// Changes a mapper's fragment shader into the Gather stage. False when it has no main().
  bool WrapGather(std::string& fragmentShader) const;

  /// The vertex shader of stages that draw tiles, and the fragment shaders of all.
  ///@{
  static std::string GetTileVertexShader();
  std::string GetCount() const;
  std::string GetResolve(int networkSize) const;
  std::string GetSecondChance() const;
  std::string GetSort() const;
  std::string GetComposite() const;
  ///@}

  /// Fragments of a pixel that the sorting networks in registers take, ascending.
  static constexpr std::array<int, 8> NetworkSizes = { 4, 6, 8, 12, 16, 24, 32, 64 };

  /// Fragments up to which all are composited, whatever the threshold; what SecondChance sorts at
  /// once. Larger networks take seconds to compile.
  static constexpr int LongList = 32;

  /// Nearest fragments of longer lists that SecondChance keeps. The more, the fainter they may be
  /// to reach a threshold; the less of its network is left for loading others.
  static constexpr int KeptFragments = 24;

  /// Nodes of the runs that Sort starts from.
  static constexpr int RunSize = 16;

private:
  std::string GetDefinitions() const;
  std::string GetHeader() const;
  std::string GetOutputHeader() const;
  std::string Assemble(const char* stage, const std::string& header) const;
};

#endif
