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

namespace
{
// Classes of tiles, as in vtkOITABufferTileVS.glsl.
constexpr std::array<int, 2> TilesToTryAgain = { -1, OIT_TRY_AGAIN };
constexpr std::array<int, 2> TilesWithLists = { -1, OIT_HAS_LISTS };

const std::string& GetTileVertexShader()
{
  static const std::string text = vtkOITABufferShaders::GetTileVertexShader();
  return text;
}
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::WaitForStores()
{
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
    GL_TEXTURE_FETCH_BARRIER_BIT);
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
  WaitForStores();
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
    WaitForStores();
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
  WaitForStores();
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
    WaitForStores();
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
      WaitForStores();
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
