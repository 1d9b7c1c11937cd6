// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITABufferResolver.h"

#include "vtkOITFrame.h"

#include "vtkOITABufferPassTileVS.h"
#include "vtkOITFullScreenVS.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <limits>

namespace
{
// Mappers count their texture units up from 0 and GL has at least 16 of them.
constexpr int TileUnit = 14;

constexpr GLbitfield Barriers =
  GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT;

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
  this->CountStage.Release();
  for (vtkOITScreenStage& stage : this->ResolveStages)
  {
    stage.Release();
  }
  this->SortStage.Release();
  this->CompositeStage.Release();
}

//------------------------------------------------------------------------------
vtkOITFragmentStore::Counters vtkOITABufferResolver::Count(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store)
{
  glMemoryBarrier(Barriers);
  this->CountStage.Render(
    frame.Window, vtkOITFullScreenVS, [this] { return this->Shaders.GetCount(); },
    [&store](vtkShaderProgram* program) { store.SetUniforms(program); });
  return store.ReadCounters();
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::Composite(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
  const vtkOITFragmentStore::Counters& counters)
{
  vtkOpenGLState* state = frame.GLState;
  frame.DrawToFirstBufferOnly();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (this->Shaders.FramebufferFetch)
  {
    state->vtkglDisable(GL_BLEND);
  }
  else
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  const vtkOITTileGrid& grid = store.GetTileGrid();
  constexpr int size = vtkOITTileGrid::TileSize;
  state->vtkglViewport(grid.FirstColumn * size, grid.FirstRow * size, grid.Columns * size,
    grid.Rows * size);

  const auto maximum =
    static_cast<int>(*std::max_element(counters.Tiles.begin(), counters.Tiles.end()));
  if (maximum == 0)
  {
    return; // all fragments were hidden, or none had opacity
  }
  store.BindTiles(state, TileUnit);
  int smallest = 1;
  if (this->Shaders.Samples == 0)
  {
    for (std::size_t i = 0; i < this->ResolveStages.size(); ++i)
    {
      const int largest = vtkOITABufferShaders::NetworkSizes[i];
      const bool isNeeded =
        std::any_of(counters.Tiles.begin(), counters.Tiles.end(), [=](std::uint32_t count) {
          return static_cast<int>(count) >= smallest && static_cast<int>(count) <= largest;
        });
      if (isNeeded)
      {
        this->DrawTiles(this->ResolveStages[i], frame, store, smallest, largest, false,
          [this, largest] { return this->Shaders.GetResolve(largest); });
      }
      smallest = largest + 1;
    }
    glMemoryBarrier(Barriers);
  }
  this->CompositeLists(frame, store, maximum, smallest);
  store.UnbindTiles(state, TileUnit);
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::CompositeLists(
  const vtkOITFrame& frame, const vtkOITFragmentStore& store, int maximum, int smallest)
{
  constexpr int unlimited = std::numeric_limits<int>::max();
  frame.GLState->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // Sort has no output
  for (const auto& widths : PlanSort(maximum))
  {
    this->DrawTiles(
      this->SortStage, frame, store, smallest, unlimited, true,
      [this] { return this->Shaders.GetSort(); },
      [&widths](vtkShaderProgram* program) {
        program->SetUniformi("oitFirstWidth", widths.first);
        program->SetUniformi("oitLastWidth", widths.second);
      });
    glMemoryBarrier(Barriers);
  }
  frame.GLState->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->DrawTiles(this->CompositeStage, frame, store, smallest, unlimited, true,
    [this] { return this->Shaders.GetComposite(); });
}

//------------------------------------------------------------------------------
void vtkOITABufferResolver::DrawTiles(vtkOITScreenStage& stage, const vtkOITFrame& frame,
  const vtkOITFragmentStore& store, int smallest, int largest, bool tied,
  const std::function<std::string()>& getFragmentShader,
  const std::function<void(vtkShaderProgram*)>& setMore)
{
  const vtkOITTileGrid& grid = store.GetTileGrid();
  const auto setUniforms = [&](vtkShaderProgram* program) {
    store.SetUniforms(program);
    const int dimensions[2] = { grid.Columns, grid.Rows };
    const int range[2] = { smallest, largest };
    program->SetUniformi("oitTileTexels", TileUnit);
    program->SetUniform2i("oitTileDimensions", dimensions);
    program->SetUniform2i("oitTileClass", range);
    program->SetUniformi("oitTiedTiles", tied ? 1 : 0);
    if (setMore)
    {
      setMore(program);
    }
  };
  stage.Render(frame.Window, vtkOITABufferPassTileVS, getFragmentShader, setUniforms,
    2 * grid.GetNumberOfTiles());
}
