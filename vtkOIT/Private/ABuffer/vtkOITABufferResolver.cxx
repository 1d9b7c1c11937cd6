// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITABufferResolver.h"

#include "Private/ABuffer/vtkOITNodeRegions.h"
#include "Private/Deferred/vtkOITLights.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITOutput.h"

#include "vtkOITFullScreenVS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <limits>

namespace
{
// Classes of tiles, as in vtkOITABufferTileVS.glsl.
constexpr std::array<int, 2> AllTiles = { 1, std::numeric_limits<int>::max() }; // with fragments
constexpr std::array<int, 2> TilesToTryAgain = { -1, OIT_TRY_AGAIN };
constexpr std::array<int, 2> TilesWithLists = { -1, OIT_HAS_LISTS };

constexpr GLbitfield Barriers =
  GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT;

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

const std::string& GetTileVertexShader()
{
  static const std::string text = vtkOITABufferShaders::GetTileVertexShader();
  return text;
}
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::SetShaders(const vtkOITABufferShaders& shaders)
{
  if (!(shaders == this->Shaders))
  {
    this->Release();
    this->Shaders = shaders;
  }
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::Release()
{
  this->DepthComplexity.Clear();
  this->CheckStage.Release();
  this->CountStage.Release();
  this->TileStages.Release();
  this->SortedTiles = 0;
  this->QuickSortStage.Release();
  this->SortStage.Release();
  for (vtkOITScreenStage& stage : this->ShortSortStages)
  {
    stage.Release();
  }
  this->ShadeStage.Release();
  this->CompositeStage.Release();
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferResolver::Resolve(const vtkOITFrame& frame, vtkOITFragmentStore& store,
  vtkOITFragmentStore::Counters& counters, std::string& fault,
  const std::function<void()>& drawVolumes)
{
  glMemoryBarrier(Barriers);
  counters = {};
  if (store.GetRegions())
  {
    if (vtkOITFailure failure = this->Check(frame, store))
    {
      return failure;
    }
  }
  const bool sortsAll = this->Shaders.SortsAll();
  if (sortsAll || (this->TileStages.CompileAtOnce() && this->DepthComplexity.IsEmpty()))
  {
    vtkOITFailure failure = this->Count(frame, store, counters);
    if (failure || counters.Overflow)
    {
      return failure;
    }
    this->DepthComplexity.Update(store.GetTileGrid(), counters.Tiles);
  }
  const std::vector<std::uint32_t> expected =
    this->DepthComplexity.GetExpected(store.GetTileGrid());
  store.SetExpected(expected);
  this->PrepareOutput(frame, store);
  const bool isLit = this->Shaders.Deferred && this->Lights;
  if (isLit)
  {
    this->Lights->Bind(frame.GLState, OIT_UNIT_LIGHTS);
  }
  vtkOITFailure failure = sortsAll
    ? this->DrawLists(frame, store, counters, AllTiles, drawVolumes)
    : this->DrawExpected(frame, store, this->TileStages.FindDraws(expected, this->Shaders));
  if (!failure && !sortsAll)
  {
    const vtkOITFailure later = this->DrawWhatIsLeft(frame, store, counters);
    fault = later.GetReason();
  }
  if (isLit)
  {
    this->Lights->Unbind(frame.GLState, OIT_UNIT_LIGHTS);
  }
  store.UnbindTiles(frame.GLState, OIT_UNIT_STATE);
  return failure;
}

//------------------------------------------------------------------------------
// The pixels that the networks have left.
vtkOITFailure vtkOITABufferResolver::DrawWhatIsLeft(
  const vtkOITFrame& frame, vtkOITFragmentStore& store, vtkOITFragmentStore::Counters& counters)
{
  vtkOITFailure failure;
  counters = store.ReadCounters();
  if (!counters.Overflow && (counters.Marks & OIT_TRY_AGAIN))
  {
    glMemoryBarrier(Barriers);
    const TileDraw again = this->TileStages.FindSecondChance(this->Shaders);
    failure = this->DrawTiles(*again.Stage, frame, store, TilesToTryAgain, again.GetFragmentShader);
    counters = store.ReadCounters();
  }
  if (!failure && !counters.Overflow && (counters.Marks & OIT_HAS_LISTS))
  {
    failure = this->DrawLists(frame, store, counters, TilesWithLists);
  }
  if (!counters.Overflow)
  {
    this->DepthComplexity.Update(store.GetTileGrid(), counters.Tiles);
  }
  return failure;
}

//------------------------------------------------------------------------------
// A region is never smaller than a pixel, so the rectangle has room for a pixel of each.
vtkOITFailure vtkOITABufferResolver::Check(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store)
{
  vtkOpenGLState* state = frame.GLState;
  const vtkOITRectangle& rectangle = store.GetRectangle();
  const vtkOITTileGrid& grid = store.GetRegions()->GetGrid();
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // it has no output
  state->vtkglViewport(rectangle.X, rectangle.Y, grid.Columns, grid.Rows);
  vtkOITFailure failure = this->CheckStage.Render(
    frame.Window, vtkOITFullScreenVS, [this] { return this->Shaders.GetCheck(); },
    [&store](vtkShaderProgram* program) { store.SetCheckUniforms(program); });
  glMemoryBarrier(Barriers);
  frame.BeginOutput(rectangle);
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferResolver::Count(const vtkOITFrame& frame,
  const vtkOITFragmentStore& store, vtkOITFragmentStore::Counters& counters)
{
  frame.GLState->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // it has no output
  vtkOITFailure failure = this->CountStage.Render(
    frame.Window, vtkOITFullScreenVS, [this] { return this->Shaders.GetCount(); },
    [&store](vtkShaderProgram* program) { store.SetUniforms(program); });
  counters = store.ReadCounters();
  return failure;
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::PrepareOutput(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store) const
{
  vtkOpenGLState* state = frame.GLState;
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  vtkOITSetOutputBlending(state, this->Shaders.FramebufferFetch);
  const vtkOITTileGrid& grid = store.GetTileGrid();
  constexpr int size = vtkOITTileGrid::TileSize;
  state->vtkglViewport(
    grid.FirstColumn * size, grid.FirstRow * size, grid.Columns * size, grid.Rows * size);
  store.BindTiles(state, OIT_UNIT_STATE);
}

//------------------------------------------------------------------------------
// All programs before the first draw, so that nothing or all is drawn.
vtkOITFailure vtkOITABufferResolver::DrawExpected(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store, const std::vector<TileDraw>& draws)
{
  for (const TileDraw& draw : draws)
  {
    if (vtkOITFailure failure =
          draw.Stage->Prepare(frame.Window, GetTileVertexShader().c_str(), draw.GetFragmentShader))
    {
      return failure;
    }
  }
  for (const TileDraw& draw : draws)
  {
    if (vtkOITFailure failure =
          this->DrawTiles(*draw.Stage, frame, store, draw.TileClass, draw.GetFragmentShader))
    {
      return failure;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// Where all lists are sorted, their lengths are known from Count.
vtkOITFailure vtkOITABufferResolver::SortLists(const vtkOITFrame& frame,
  const vtkOITFragmentStore& store, const vtkOITFragmentStore::Counters& counters,
  std::array<int, 2> tileClass)
{
  const std::uint32_t longest = *std::max_element(counters.Tiles.begin(), counters.Tiles.end());
  glMemoryBarrier(Barriers);
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
      glMemoryBarrier(Barriers);
    }
  }
  glMemoryBarrier(Barriers);
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
// Volumes are drawn when nothing can fail any more.
vtkOITFailure vtkOITABufferResolver::DrawLists(const vtkOITFrame& frame,
  const vtkOITFragmentStore& store, vtkOITFragmentStore::Counters& counters,
  const std::array<int, 2>& tileClass, const std::function<void()>& drawVolumes)
{
  const bool hasLists = std::any_of(
    counters.Tiles.begin(), counters.Tiles.end(), [](std::uint32_t n) { return n > 0; });
  vtkOITFailure failure;
  const TileDraw merge = tileClass == TilesWithLists
    ? this->TileStages.FindMerge(*std::max_element(counters.Tiles.begin(), counters.Tiles.end()),
        this->SortedTiles, this->Shaders)
    : TileDraw();
  if (merge.Stage)
  {
    glMemoryBarrier(Barriers);
    failure = this->DrawTiles(*merge.Stage, frame, store, tileClass, merge.GetFragmentShader);
  }
  else if (hasLists)
  {
    failure = this->SortLists(frame, store, counters, tileClass);
    const auto longest =
      static_cast<int>(*std::max_element(counters.Tiles.begin(), counters.Tiles.end()));
    failure = failure ? failure : this->ShadeLongLists(frame, store, longest, tileClass);
  }
  if (drawVolumes && !failure)
  {
    failure = this->CompositeStage.Prepare(
      frame.Window, GetTileVertexShader().c_str(), [this] { return this->Shaders.GetComposite(); });
    if (!failure)
    {
      drawVolumes();
      glMemoryBarrier(Barriers);
      frame.BeginOutput(store.GetRectangle());
      this->PrepareOutput(frame, store);
    }
  }
  if (hasLists && !merge.Stage && !failure)
  {
    failure = this->Composite(frame, store, tileClass);
  }
  if (this->Threshold > 0.0f && hasLists)
  {
    counters.Skipped = store.ReadSkipped();
  }
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferResolver::Composite(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store, const std::array<int, 2>& tileClass)
{
  return this->DrawTiles(
    this->CompositeStage, frame, store, tileClass, [this] { return this->Shaders.GetComposite(); });
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
    glMemoryBarrier(Barriers);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITABufferResolver::DrawTiles(vtkOITScreenStage& stage, const vtkOITFrame& frame,
  const vtkOITFragmentStore& store, const std::array<int, 2>& tileClass,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setMore)
{
  const vtkOITTileGrid& grid = store.GetTileGrid();
  const auto setUniforms = [&](vtkShaderProgram* program)
  {
    store.SetUniforms(program);
    const int dimensions[2] = { grid.Columns, grid.Rows };
    program->SetUniformi("oitTileTexels", OIT_UNIT_STATE);
    program->SetUniformi("oitNodeTexels", OIT_UNIT_NODES);
    program->SetUniformi("oitExpectedTexels", OIT_UNIT_GATHERED);
    program->SetUniform2i("oitTileDimensions", dimensions);
    program->SetUniform2i("oitTileClass", tileClass.data());
    program->SetUniformf("oitThreshold", this->Threshold);
    if (this->Shaders.Deferred && this->Lights)
    {
      this->Lights->SetUniforms(program, frame, OIT_UNIT_LIGHTS);
    }
    if (setMore)
    {
      setMore(program);
    }
  };
  return stage.Render(frame.Window, GetTileVertexShader().c_str(), getFragmentShader, setUniforms,
    2 * grid.GetNumberOfTiles());
}
