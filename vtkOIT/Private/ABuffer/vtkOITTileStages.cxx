// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITTileStages.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace
{
bool IsOne(const char* value)
{
  return value && std::strcmp(value, "1") == 0;
}
}

//------------------------------------------------------------------------------
vtkOITTileStages::vtkOITTileStages()
  : CompilesAtOnce(IsOne(std::getenv("VTKOIT_NETWORKS")))
{
}

//------------------------------------------------------------------------------
void vtkOITTileStages::Release()
{
  this->Walked = {};
  for (vtkOITScreenStage& stage : this->ResolveStages)
  {
    stage.Release();
  }
  for (vtkOITScreenStage& stage : this->MergeStages)
  {
    stage.Release();
  }
  this->SecondChanceStage.Release();
  this->WalkStage.Release();
}

//------------------------------------------------------------------------------
std::size_t vtkOITTileStages::FindClass(std::uint32_t length)
{
  const auto& sizes = vtkOITABufferShaders::NetworkSizes;
  return static_cast<std::size_t>(
    std::lower_bound(sizes.begin(), sizes.end(), static_cast<int>(length)) - sizes.begin());
}

//------------------------------------------------------------------------------
vtkOITScreenStage& vtkOITTileStages::GetStage(std::size_t tileClass)
{
  return tileClass == LongLists ? this->SecondChanceStage : this->ResolveStages[tileClass];
}

//------------------------------------------------------------------------------
// Whether tiles of a class are drawn by its own program from now on. `isFree`: this frame has compiled none yet.
bool vtkOITTileStages::Earns(std::size_t tileClass, std::int64_t tiles, bool& isFree)
{
  if (this->GetStage(tileClass).IsPrepared())
  {
    return true;
  }
  this->Walked[tileClass] += tiles;
  const bool earns = this->CompilesAtOnce || (isFree && this->Walked[tileClass] > TilesToCompile);
  isFree = isFree && !earns;
  return earns;
}

//------------------------------------------------------------------------------
std::vector<vtkOITTileStages::Draw> vtkOITTileStages::FindDraws(
  const std::vector<std::uint32_t>& expected, const vtkOITABufferShaders& shaders)
{
  std::array<std::int64_t, Classes> tiles{};
  for (const std::uint32_t length : expected)
  {
    ++tiles[FindClass(length)];
  }
  bool isFree = true;
  std::vector<Draw> draws;
  int smallest = 0;
  for (std::size_t i = 0; i < Classes; ++i)
  {
    const int size = vtkOITABufferShaders::NetworkSizes[std::min(i, LongLists - 1)];
    const int largest = i < LongLists ? size : std::numeric_limits<int>::max();
    vtkOITScreenStage& stage = this->GetStage(i);
    if (tiles[i] > 0 && this->Earns(i, tiles[i], isFree))
    {
      draws.push_back({ &stage, { smallest, largest }, [&shaders, i, size] {
                         return i < LongLists ? shaders.GetResolve(size)
                                              : shaders.GetSecondChance();
                       } });
    }
    else if (tiles[i] > 0 && !draws.empty() && draws.back().Stage == &this->WalkStage)
    {
      draws.back().TileClass[1] = largest; // no tiles are between
    }
    else if (tiles[i] > 0)
    {
      draws.push_back(
        { &this->WalkStage, { smallest, largest }, [&shaders] { return shaders.GetWalk(); } });
    }
    smallest = largest < std::numeric_limits<int>::max() ? largest + 1 : largest;
  }
  return draws;
}

//------------------------------------------------------------------------------
vtkOITTileStages::Draw vtkOITTileStages::FindSecondChance(const vtkOITABufferShaders& shaders)
{
  const bool hasNetwork = this->SecondChanceStage.IsPrepared();
  return { hasNetwork ? &this->SecondChanceStage : &this->WalkStage, {},
    [&shaders, hasNetwork] { return hasNetwork ? shaders.GetSecondChance() : shaders.GetWalk(); } };
}

//------------------------------------------------------------------------------
// Short lists are left because of coincident fragments. They take less by Sort.
vtkOITTileStages::Draw vtkOITTileStages::FindMerge(
  std::uint32_t longest, std::int64_t sortedTiles, const vtkOITABufferShaders& shaders)
{
  const bool isEarned = this->CompilesAtOnce || sortedTiles > TilesToCompile;
  const bool isLong = FindClass(longest) == LongLists;
  // Mesa 26.1's llvmpipe gives NaN for float colours of nodes in an image that Merge has stored.
  const bool canMerge =
    isLong && isEarned && !shaders.LastOnTop && !shaders.Deferred && !shaders.NodesInImage;
  for (std::size_t i = 0; i < MergedRuns.size() && canMerge; ++i)
  {
    const int runs = MergedRuns[i];
    if (static_cast<int>(longest) <= runs * OIT_MERGED_RUN)
    {
      return { &this->MergeStages[i], {}, [&shaders, runs] { return shaders.GetMerge(runs); } };
    }
  }
  return { nullptr, {}, {} };
}
