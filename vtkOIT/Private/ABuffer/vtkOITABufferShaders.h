// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITABufferShaders_h
#define vtkOITABufferShaders_h

#include "Private/GL/vtkOITShaderText.h"

#include "glsl/Common/vtkOITConstants.h"

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
  bool NodesInTexture = false; // in stages that only read them
  bool FramebufferFetch = false;
  bool PostDepthCoverage = false;
  bool HeadInTarget = false;
  bool ClampColor = false;
  bool FineDerivatives = false;
  bool LastOnTop = false;
  bool Interlock = false; // in Gather, for the order of drawing
  bool HasLight = false;  // some props add light
  bool Volumes = false;   // rays of volumes walk the lists
  bool Deferred = false;  // nodes have materials, which are lit after sorting
  bool Specular = false;  // some material may reflect lights
  bool Physical = false;  // some material is lit by physically based rendering

  bool operator==(const vtkOITABufferShaders& other) const;

  /// A node takes two texels instead of one.
  bool HasWideNodes() const { return this->FloatColor || this->Samples > 0; }
  /// Nodes are not in the order of drawing by themselves, so they keep it in one texel more.
  bool HasDrawOrder() const { return this->LastOnTop && !this->HeadInTarget && !this->Interlock; }
  int GetTexelsPerNode() const
  {
    return 1 + (this->HasWideNodes() || this->Deferred ? 1 : 0) + (this->HasDrawOrder() ? 1 : 0);
  }
  int GetBytesPerNode() const { return 16 * this->GetTexelsPerNode(); }
  /// All lists are sorted in memory, not only those that networks in registers leave.
  bool SortsAll() const { return this->Volumes || this->Samples > 0; }

  /// The stage on fragments of props.
  vtkOITShaderText GetGather() const;

  /// The vertex shader of stages that draw tiles, and the fragment shaders of all.
  ///@{
  static std::string GetTileVertexShader();
  std::string GetCheck() const;
  std::string GetCount() const;
  std::string GetResolve(int networkSize) const;
  std::string GetSecondChance() const;
  /// In place of Resolve and SecondChance until their programs are compiled. With deferred shading both
  /// this and SecondChance are Leave, which leaves pixels for Sort and Composite.
  std::string GetWalk() const;
  /// `runSize`: fragments of the runs that it starts from, OIT_RUN_SIZE, OIT_SHORT_RUN or the length
  /// of short lists.
  std::string GetSort(int runSize) const;
  /// In place of Sort and Composite, for lists of up to `runs` runs of OIT_MERGED_RUN fragments. Not for
  /// volumes, multisampling, nodes in an image, deferred shading and LastOnTop.
  std::string GetMerge(int runs) const;
  /// Lights some fragments of lists that Sort has sorted, for deferred shading.
  std::string GetShade() const;
  std::string GetComposite() const;
  /// Of a volume mapper, to which March was added (vtkOITVolumeText).
  std::string GetVolume(const std::string& mapperShader) const;
  ///@}

  /// Fragments of a pixel that the sorting networks in registers take, ascending. The largest
  /// takes seconds to compile.
  static constexpr std::array<int, OIT_NETWORK_COUNT> NetworkSizes = { OIT_NETWORK_SIZES };

  /// Nearest fragments of longer lists that SecondChance keeps. The more, the fainter they may be
  /// to reach a threshold; the less of its network is left for loading others.
  static constexpr int KeptFragments = 24;

  /// Fragments that Walk keeps in registers, and the longest list that it takes to its end. The more it
  /// keeps, the fewer walks, and the longer it compiles.
  ///@{
  static constexpr int WalkedFragments = 8;
  static constexpr int LongestWalk = 128;
  ///@}

private:
  void AddVariant(vtkOITShaderText& text) const;
  vtkOITShaderText MakeStage(const char* file) const;
  vtkOITShaderText MakeOutputStage(const char* file) const;
};

#endif
