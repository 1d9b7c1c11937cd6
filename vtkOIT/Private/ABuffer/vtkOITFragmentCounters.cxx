// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The counters of vtkOITFragmentStore: what they begin with, and what they tell.
#include "Private/ABuffer/vtkOITCounterLayout.h"
#include "Private/ABuffer/vtkOITFragmentStore.h"
#include "Private/ABuffer/vtkOITNodeRegions.h"

#include <algorithm>
#include <cstring>

using namespace vtkOITCounterLayout;

//------------------------------------------------------------------------------
// Node 0 is never used, nor is its page where nodes come in pages.
std::uint32_t vtkOITFragmentStore::GetFirstNode() const
{
  return this->WholeFramebuffer ? OIT_PAGE_SIZE : 1u;
}

//------------------------------------------------------------------------------
int vtkOITFragmentStore::GetFirstRegionWord() const
{
  return static_cast<int>(GetTileWords(this->Grid.GetNumberOfTiles()));
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkOITFragmentStore::MakeCounters() const
{
  const auto missing = static_cast<std::uint32_t>(this->Nodes);
  std::vector<std::uint32_t> words(this->GetFirstRegionWord(), 0u);
  words[0] = this->GetFirstNode();
  words[OIT_WORD_MISSING] = missing;
  if (this->Regions)
  {
    for (const vtkOITNodeRegions::Region& region : this->Regions->GetRegions())
    {
      const std::size_t at = words.size();
      words.resize(at + OIT_REGION_WORDS, 0u);
      words[at] = region.Begin;
      words[at + OIT_WORD_MISSING] = missing;
      words[at + OIT_REGION_END] = region.End;
    }
  }
  return words;
}

//------------------------------------------------------------------------------
vtkOITFragmentStore::Counters vtkOITFragmentStore::ReadCounters() const
{
  const auto regions = this->Regions ? this->Regions->GetRegions().size() : 0;
  std::vector<std::uint32_t> words(
    GetCounterWords(this->Grid.GetNumberOfTiles(), static_cast<int>(regions)));
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->CounterBuffer);
  glGetBufferSubData(
    GL_SHADER_STORAGE_BUFFER, 0, GetBytes(static_cast<std::int64_t>(words.size())), words.data());
  const auto firstRegion = static_cast<std::size_t>(this->GetFirstRegionWord());
  Counters counters;
  counters.SharedAllocations = this->CountNodes(words, 0, this->GetFirstNode(), counters) /
    (this->WholeFramebuffer ? OIT_PAGE_SIZE : 1);
  for (std::size_t i = firstRegion; i < words.size(); i += OIT_REGION_WORDS)
  {
    const vtkOITNodeRegions::Region& region =
      this->Regions->GetRegions()[(i - firstRegion) / OIT_REGION_WORDS];
    this->CountNodes(words, i, region.Begin, counters);
  }
  counters.Overflow = words[OIT_WORD_OVERFLOW] | (words[0] > this->Nodes ? 1u : 0u);
  std::memcpy(&counters.Skipped, &words[OIT_WORD_SKIPPED], sizeof(float));
  const auto tiles = static_cast<std::size_t>(this->Grid.GetNumberOfTiles());
  counters.Tiles.reserve(tiles);
  counters.TileFragments.reserve(tiles);
  for (std::size_t tile = 0; tile < tiles; ++tile)
  {
    const std::uint32_t* word = &words[OIT_COUNTER_WORDS + OIT_TILE_WORDS * tile];
    const std::uint32_t marks = word[0] & (OIT_TRY_AGAIN | OIT_HAS_LISTS);
    counters.Tiles.push_back(marks ? word[1] : word[0]);
    counters.TileFragments.push_back(word[2]);
    counters.Marks |= marks;
    counters.MarkedTiles += (marks & OIT_HAS_LISTS) ? 1 : 0;
    counters.FragmentCount += word[2];
  }
  return counters;
}

//------------------------------------------------------------------------------
// Of the counters at a word, which began with a node. Returns their number.
std::int64_t vtkOITFragmentStore::CountNodes(const std::vector<std::uint32_t>& words,
  std::size_t at, std::uint32_t first, Counters& counters) const
{
  const std::int64_t used = static_cast<std::int64_t>(words[at]) - first;
  // Of 32 bits, as the counter may have wrapped.
  const std::uint32_t missing =
    words[at + OIT_WORD_MISSING] - static_cast<std::uint32_t>(this->Nodes);
  counters.NodeCount += used + missing;
  counters.EndOfNodes = std::max<std::int64_t>(counters.EndOfNodes, words[at]);
  return used + missing;
}

//------------------------------------------------------------------------------
float vtkOITFragmentStore::ReadSkipped() const
{
  float skipped = 0.0f;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->CounterBuffer);
  glGetBufferSubData(
    GL_SHADER_STORAGE_BUFFER, OIT_WORD_SKIPPED * sizeof(std::uint32_t), sizeof(float), &skipped);
  return skipped;
}
