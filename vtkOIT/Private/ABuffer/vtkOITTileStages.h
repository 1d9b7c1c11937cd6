// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITTileStages_h
#define vtkOITTileStages_h

#include "Private/ABuffer/vtkOITABufferShaders.h"
#include "Private/GL/vtkOITScreenStage.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/**
 * The programs that draw tiles of an A-buffer: a sorting network for each class of lengths, and Walk for
 * all lengths. Networks take long to compile, and a picture may be the only one: Walk takes tiles until
 * a network would have paid for its compiler, and at most one is compiled a frame.
 */
class vtkOITTileStages
{
public:
  /// In the environment VTKOIT_NETWORKS=1 has networks compiled as soon as there are tiles for them: for
  /// tests, and to measure steady frames.
  vtkOITTileStages();

  /// A draw of the tiles of one class.
  struct Draw
  {
    vtkOITScreenStage* Stage = nullptr;
    std::array<int, 2> TileClass;
    std::function<std::string()> GetFragmentShader;
  };

  /// Tiles that Walk has drawn before the network for them is compiled: on llvmpipe that takes as long as the
  /// network saves on 2500 tiles full of the longest lists, or 15000 of isosurfaces, whatever its size.
  static constexpr std::int64_t TilesToCompile = 4000;

  bool CompileAtOnce() const { return this->CompilesAtOnce; }

  /// The draws of tiles with these lengths of lists. `shaders` must outlive them.
  std::vector<Draw> FindDraws(
    const std::vector<std::uint32_t>& expected, const vtkOITABufferShaders& shaders);

  /// Of tiles with longer lists than expected; their class is not set.
  Draw FindSecondChance(const vtkOITABufferShaders& shaders);

  /// Of tiles with lists that are left, where the longest is this long: merges them in place of Sort and
  /// Composite. No Stage where these do it: for short lists and those of more runs than registers take, in
  /// the order of drawing, and until so many tiles were sorted that its compiler has paid.
  Draw FindMerge(
    std::uint32_t longest, std::int64_t sortedTiles, const vtkOITABufferShaders& shaders);

  void Release();

private:
  /// The classes of tiles are those of NetworkSizes, and one for longer lists.
  static constexpr std::size_t Classes = vtkOITABufferShaders::NetworkSizes.size() + 1;
  static constexpr std::size_t LongLists = Classes - 1;
  static std::size_t FindClass(std::uint32_t length);
  vtkOITScreenStage& GetStage(std::size_t tileClass);
  bool Earns(std::size_t tileClass, std::int64_t tiles, bool& isFree);

  std::array<vtkOITScreenStage, vtkOITABufferShaders::NetworkSizes.size()> ResolveStages;
  static constexpr std::array<int, 2> MergedRuns = { 16, 32 };
  std::array<vtkOITScreenStage, MergedRuns.size()> MergeStages;
  vtkOITScreenStage SecondChanceStage;
  vtkOITScreenStage WalkStage;
  std::array<std::int64_t, Classes> Walked{}; // tiles of each class that Walk has drawn
  const bool CompilesAtOnce;
};

#endif
