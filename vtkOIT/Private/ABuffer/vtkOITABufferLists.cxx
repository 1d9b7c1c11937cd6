// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkOITABufferResolver does with lists that no network takes: it sorts them in memory, and lights
// those that are too long to be lit while they are composited.
#include "Private/ABuffer/vtkOITABufferResolver.h"

#include "Private/Deferred/vtkOITLights.h"
#include "Private/Frame/vtkOITFrame.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Loop iterations that one draw may spend on a list, below llvmpipe's 65535.
constexpr int LoopBudget = 60000;

/// The draws of Sort for lists of `length` nodes, as first and last merge width of each.
std::vector<std::pair<int, int>> PlanSort(int length, int runSize)
{
  // A merge visits each node once, and once more to find the second run of each pair.
  const int mergesPerDraw = std::clamp(LoopBudget / (2 * length) - 1, 1, 20);
  std::vector<std::pair<int, int>> draws;
  int width = runSize;
  do
  {
    draws.emplace_back(width, width << (mergesPerDraw - 1));
    width <<= mergesPerDraw;
  } while (width < length);
  return draws;
}
}

//------------------------------------------------------------------------------
// Where all lists are sorted, their lengths are known from Count.
vtkOITFailure vtkOITABufferResolver::SortLists(const vtkOITFrame& frame,
  const vtkOITFragmentStore& store, const vtkOITFragmentStore::Counters& counters,
  std::array<int, 2> tileClass)
{
  const std::uint32_t longest = *std::max_element(counters.Tiles.begin(), counters.Tiles.end());
  WaitForStores();
  this->SortedTiles +=
    tileClass == AllTiles ? store.GetTileGrid().GetNumberOfTiles() : counters.MarkedTiles;
  vtkOpenGLState* state = frame.GLState;
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // Sort has no output
  vtkOITFailure failure;
  if (tileClass == AllTiles)
  {
    failure = this->SortShortLists(frame, store, counters);
    tileClass[0] = ShortLists.back() + 1;
  }
  if (static_cast<int>(longest) >= tileClass[0])
  {
    const bool isQuick =
      !this->TileStages.CompileAtOnce() && this->SortedTiles <= vtkOITTileStages::TilesToCompile;
    const int runSize = isQuick ? OIT_SHORT_RUN : OIT_RUN_SIZE;
    vtkOITScreenStage& stage = isQuick ? this->QuickSortStage : this->SortStage;
    for (const auto& widths : PlanSort(static_cast<int>(longest), runSize))
    {
      failure = failure ? failure : this->Sort(stage, runSize, frame, store, tileClass, widths);
      WaitForStores();
    }
  }
  WaitForStores();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferResolver::SortShortLists(const vtkOITFrame& frame,
  const vtkOITFragmentStore& store, const vtkOITFragmentStore::Counters& counters)
{
  vtkOITFailure failure;
  int smallest = 1;
  for (std::size_t i = 0; i < ShortLists.size() && !failure; ++i)
  {
    const int largest = ShortLists[i];
    const bool isNeeded = std::any_of(counters.Tiles.begin(), counters.Tiles.end(),
      [=](std::uint32_t n)
      { return smallest <= static_cast<int>(n) && static_cast<int>(n) <= largest; });
    if (isNeeded)
    {
      failure = this->Sort(
        this->ShortSortStages[i], largest, frame, store, { smallest, largest }, { largest, 0 });
    }
    smallest = largest + 1;
  }
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferResolver::Sort(vtkOITScreenStage& stage, int runSize,
  const vtkOITFrame& frame, const vtkOITFragmentStore& store, const std::array<int, 2>& tileClass,
  const std::pair<int, int>& widths)
{
  return this->DrawTiles(
    stage, frame, store, tileClass, [this, runSize] { return this->Shaders.GetSort(runSize); },
    [&widths](vtkShaderProgram* program)
    {
      program->SetUniformi("oitFirstWidth", widths.first);
      program->SetUniformi("oitLastWidth", widths.second);
    });
}

//------------------------------------------------------------------------------
// What one draw of Composite cannot light is lit before it, some fragments of each list at a time.
vtkOITFailure vtkOITABufferResolver::ShadeLongLists(const vtkOITFrame& frame,
  const vtkOITFragmentStore& store, int longest, const std::array<int, 2>& tileClass)
{
  const int lights = this->Shaders.Deferred && this->Lights ? this->Lights->GetNumberOfLights() : 0;
  if (static_cast<std::int64_t>(longest) * (1 + lights) <= LoopBudget)
  {
    return {};
  }
  const int step = std::max(1, (LoopBudget - LongestList) / (1 + lights));
  vtkOpenGLState* state = frame.GLState;
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // Shade has no output
  vtkOITFailure failure;
  for (int first = 0; first < longest && !failure; first += step)
  {
    failure = this->DrawTiles(
      this->ShadeStage, frame, store, tileClass, [this] { return this->Shaders.GetShade(); },
      [&](vtkShaderProgram* program)
      {
        program->SetUniformi("oitFirstFragment", first);
        program->SetUniformi("oitLastFragment", first + step - 1);
      });
    WaitForStores();
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return failure;
}
