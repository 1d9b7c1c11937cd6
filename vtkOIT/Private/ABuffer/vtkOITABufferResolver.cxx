// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITABufferResolver.h"

#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITOutput.h"

#include "vtkOITFullScreenVS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <limits>

namespace
{
// Two texture units. Mappers count theirs up from 0 and GL has at least 16.
constexpr int TileUnit = 13;

// Classes of tiles, as in vtkOITABufferTileVS.glsl.
constexpr std::array<int, 2> AllTiles = { 0, std::numeric_limits<int>::max() };
constexpr std::array<int, 2> TilesToTryAgain = { -1, vtkOITFragmentStore::TryAgain };
constexpr std::array<int, 2> TilesWithLists = { -1, vtkOITFragmentStore::HasLists };

constexpr GLbitfield Barriers =
  GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT;

// Frames with tiles for the largest network before it is worth being compiled.
constexpr int DeepFramesToCompile = 8;

// Loop iterations that one draw of Sort may spend on a list, below llvmpipe's 65535.
constexpr int SortBudget = 60000;

/// The draws of Sort for lists of `length` nodes, as first and last merge width of each.
std::vector<std::pair<int, int>> PlanSort(int length)
{
  // A merge visits each node once, and once more to find the second run of each pair.
  const int mergesPerDraw = std::clamp(SortBudget / (2 * length) - 1, 1, 20);
  std::vector<std::pair<int, int>> draws;
  int width = vtkOITABufferShaders::RunSize;
  do
  {
    draws.emplace_back(width, width << (mergesPerDraw - 1));
    width <<= mergesPerDraw;
  } while (width < length);
  return draws;
}
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::SetShaders(const vtkOITABufferShaders& shaders)
{
  this->Release();
  this->Shaders = shaders;
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::Release()
{
  this->DepthComplexity.Clear();
  this->DeepFrames = 0;
  this->CountStage.Release();
  for (vtkOITScreenStage& stage : this->ResolveStages)
  {
    stage.Release();
  }
  this->SecondChanceStage.Release();
  this->SortStage.Release();
  this->CompositeStage.Release();
}

//------------------------------------------------------------------------------
vtkOITFragmentStore::Counters vtkOITABufferResolver::Resolve(
  const vtkOITFrame& frame, vtkOITFragmentStore& store)
{
  glMemoryBarrier(Barriers);
  const bool isMultisampled = this->Shaders.Samples > 0;
  vtkOITFragmentStore::Counters counters;
  if (isMultisampled || this->DepthComplexity.IsEmpty())
  {
    counters = this->Count(frame, store);
    if (counters.Overflow)
    {
      return counters;
    }
    this->DepthComplexity.Update(store.GetTileGrid(), counters.Tiles);
  }

  const std::vector<std::uint32_t> expected =
    this->DepthComplexity.GetExpected(store.GetTileGrid());
  store.SetExpected(expected);
  this->PrepareOutput(frame, store);
  if (isMultisampled)
  {
    this->DrawLists(frame, store, counters, AllTiles);
  }
  else
  {
    this->DrawExpected(frame, store, expected);
    counters = store.ReadCounters();
    if (!counters.Overflow && (counters.Marks & vtkOITFragmentStore::TryAgain))
    {
      glMemoryBarrier(Barriers);
      this->DrawTiles(this->SecondChanceStage, frame, store, TilesToTryAgain,
        [this] { return this->Shaders.GetSecondChance(); });
      counters = store.ReadCounters();
    }
    if (!counters.Overflow && (counters.Marks & vtkOITFragmentStore::HasLists))
    {
      this->DrawLists(frame, store, counters, TilesWithLists);
    }
    if (!counters.Overflow)
    {
      this->DepthComplexity.Update(store.GetTileGrid(), counters.Tiles);
    }
  }
  store.UnbindTiles(frame.GLState, TileUnit);
  return counters;
}

//------------------------------------------------------------------------------
vtkOITFragmentStore::Counters vtkOITABufferResolver::Count(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store)
{
  frame.GLState->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // it has no output
  this->CountStage.Render(
    frame.Window, vtkOITFullScreenVS, [this] { return this->Shaders.GetCount(); },
    [&store](vtkShaderProgram* program) { store.SetUniforms(program); });
  return store.ReadCounters();
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::PrepareOutput(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store) const
{
  vtkOpenGLState* state = frame.GLState;
  frame.DrawToFirstBufferOnly();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  vtkOITSetOutputBlending(state, this->Shaders.FramebufferFetch);
  const vtkOITTileGrid& grid = store.GetTileGrid();
  constexpr int size = vtkOITTileGrid::TileSize;
  state->vtkglViewport(
    grid.FirstColumn * size, grid.FirstRow * size, grid.Columns * size, grid.Rows * size);
  store.BindTiles(state, TileUnit);
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::DrawExpected(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
  const std::vector<std::uint32_t>& expected)
{
  int smallest = 0;
  const auto isNeeded = [&](int largest)
  {
    return std::any_of(expected.begin(), expected.end(),
      [=](std::uint32_t count)
      { return smallest <= static_cast<int>(count) && static_cast<int>(count) <= largest; });
  };
  for (std::size_t i = 0; i < this->ResolveStages.size(); ++i)
  {
    const int size = vtkOITABufferShaders::NetworkSizes[i];
    const bool isDeep = size > vtkOITABufferShaders::LongList;
    if (isDeep && isNeeded(size) && this->DeepFrames < DeepFramesToCompile)
    {
      ++this->DeepFrames;
      break;
    }
    if (isNeeded(size))
    {
      this->DrawTiles(this->ResolveStages[i], frame, store, { smallest, size },
        [this, size] { return this->Shaders.GetResolve(size); });
    }
    smallest = size + 1;
  }
  constexpr int largest = std::numeric_limits<int>::max();
  if (isNeeded(largest))
  {
    this->DrawTiles(this->SecondChanceStage, frame, store, { smallest, largest },
      [this] { return this->Shaders.GetSecondChance(); });
  }
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::DrawLists(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
  vtkOITFragmentStore::Counters& counters, const std::array<int, 2>& tileClass)
{
  const std::uint32_t longest = *std::max_element(counters.Tiles.begin(), counters.Tiles.end());
  if (longest == 0)
  {
    return;
  }
  glMemoryBarrier(Barriers);
  vtkOpenGLState* state = frame.GLState;
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // Sort has no output
  for (const auto& widths : PlanSort(static_cast<int>(longest)))
  {
    this->DrawTiles(
      this->SortStage, frame, store, tileClass, [this] { return this->Shaders.GetSort(); },
      [&widths](vtkShaderProgram* program)
      {
        program->SetUniformi("oitFirstWidth", widths.first);
        program->SetUniformi("oitLastWidth", widths.second);
      });
    glMemoryBarrier(Barriers);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->DrawTiles(
    this->CompositeStage, frame, store, tileClass, [this] { return this->Shaders.GetComposite(); });
  if (this->Threshold > 0.0f)
  {
    counters.Skipped = store.ReadSkipped();
  }
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::DrawTiles(vtkOITScreenStage& stage, const vtkOITFrame& frame,
  const vtkOITFragmentStore& store, const std::array<int, 2>& tileClass,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setMore)
{
  const vtkOITTileGrid& grid = store.GetTileGrid();
  const auto setUniforms = [&](vtkShaderProgram* program)
  {
    store.SetUniforms(program);
    const int dimensions[2] = { grid.Columns, grid.Rows };
    program->SetUniformi("oitTileTexels", TileUnit);
    program->SetUniformi("oitExpectedTexels", TileUnit + 1);
    program->SetUniform2i("oitTileDimensions", dimensions);
    program->SetUniform2i("oitTileClass", tileClass.data());
    program->SetUniformf("oitThreshold", this->Threshold);
    if (setMore)
    {
      setMore(program);
    }
  };
  static const std::string vertexShader = vtkOITABufferShaders::GetTileVertexShader();
  stage.Render(frame.Window, vertexShader.c_str(), getFragmentShader, setUniforms,
    2 * grid.GetNumberOfTiles());
}
