// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITFragmentStore.h"

#include "Private/ABuffer/vtkOITCounterLayout.h"
#include "Private/ABuffer/vtkOITNodeRegions.h"
#include "Private/Frame/vtkOITCapabilities.h"
#include "Private/GL/vtkOITAllocation.h"
#include "Private/GL/vtkOITFramebuffer.h"
#include "Private/GL/vtkOITSharedDepth.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <string>

using namespace vtkOITCounterLayout;

namespace
{
constexpr std::int64_t BytesPerTexel = 16; // of the pool as a buffer texture, GL_RGBA32UI

GLuint MakeBufferTexture(GLenum format, GLuint buffer)
{
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &bound);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_BUFFER, texture);
  glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
  glBindTexture(GL_TEXTURE_BUFFER, bound);
  return texture;
}

/// A storage buffer of integers and its texture, instead of those of before.
void RemakeCounters(GLuint& buffer, GLuint& texture, GLsizeiptr bytes, GLenum usage)
{
  glDeleteTextures(1, &texture);
  glDeleteBuffers(1, &buffer);
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, nullptr, usage);
  texture = MakeBufferTexture(GL_R32UI, buffer);
}
}

//------------------------------------------------------------------------------
std::int64_t vtkOITFragmentStore::GetLargestPool(const vtkOITCapabilities& capabilities)
{
  // 2^31 - 1 nodes at most, because shaders get the capacity as an int.
  return std::min<std::int64_t>(std::max(capabilities.MaximumStorageBlockSize,
                                  capabilities.MaximumTextureBufferSize * BytesPerTexel),
    (INT64_C(1) << 31) * BytesPerTexel - BytesPerTexel);
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITFragmentStore::Reserve(vtkOpenGLRenderWindow* window,
  const vtkOITCapabilities& capabilities, const vtkOITRectangle& rectangle, std::int64_t fragments,
  int bytesPerNode, std::int64_t maximumPoolBytes)
{
  this->Attach(window);
  vtkOITFailure failure = this->ReserveCounters(rectangle);
  if (!failure)
  {
    failure = this->ReserveHeads(rectangle.Width + (this->WholeFramebuffer ? rectangle.X : 0),
      rectangle.Height + (this->WholeFramebuffer ? rectangle.Y : 0));
  }
  // In pages of 64 KiB, so that a slowly growing scene does not reallocate every frame.
  const std::int64_t bytes =
    std::min(RoundUp((fragments + 1) * bytesPerNode, 65536), maximumPoolBytes);
  if (!failure && this->PoolBytes < bytes)
  {
    failure = this->ReservePool(bytes, capabilities);
  }
  if (failure)
  {
    this->Release();
  }
  // Whole pages, so that a page that is given out is there as a whole.
  const std::int64_t nodes = this->PoolBytes / bytesPerNode;
  this->Nodes = this->WholeFramebuffer ? nodes / OIT_PAGE_SIZE * OIT_PAGE_SIZE : nodes;
  return failure;
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITFragmentStore::ReserveCounters(const vtkOITRectangle& rectangle)
{
  const int tiles = vtkOITTileGrid(rectangle).GetNumberOfTiles();
  const int regions = vtkOITTileGrid(rectangle, OIT_REGION_SIZE).GetNumberOfTiles();
  const std::int64_t words = GetCounterWords(tiles, this->WholeFramebuffer ? regions : 0);
  if (this->TileCapacity >= tiles && this->CounterWords >= words)
  {
    return {};
  }
  const vtkOITAllocation allocation;
  this->TileCapacity = std::max(this->TileCapacity, tiles);
  this->CounterWords = std::max(this->CounterWords, words);
  RemakeCounters(
    this->CounterBuffer, this->CounterTexture, GetBytes(this->CounterWords), GL_DYNAMIC_READ);
  RemakeCounters(this->ExpectedBuffer, this->ExpectedTexture, GetExpectedBytes(this->TileCapacity),
    GL_DYNAMIC_DRAW);
  return allocation.Check("the counters of an A-buffer");
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITFragmentStore::ReserveHeads(int width, int height)
{
  if (this->Width >= width && this->Height >= height)
  {
    return {};
  }
  const vtkOITAllocation allocation;
  this->Width = std::max(this->Width, width);
  this->Height = std::max(this->Height, height);
  glDeleteTextures(1, &this->Heads);
  glGenTextures(1, &this->Heads);
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glBindTexture(GL_TEXTURE_2D, this->Heads);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_R32UI, this->Width, this->Height);
  glBindTexture(GL_TEXTURE_2D, bound);
  return allocation.Check("the list heads of " + std::to_string(this->Width) + " x " +
    std::to_string(this->Height) + " pixels");
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITFragmentStore::ReservePool(
  std::int64_t bytes, const vtkOITCapabilities& capabilities)
{
  glDeleteTextures(1, &this->PoolTexture);
  glDeleteBuffers(1, &this->Pool);
  this->PoolTexture = 0;
  glGenBuffers(1, &this->Pool);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Pool);
  vtkOITAllocation::TakeErrors();
  // Halve what the context refuses: a smaller pool costs bands, not correctness.
  glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, nullptr, GL_DYNAMIC_COPY);
  bool isRefused = vtkOITAllocation::TakeErrors();
  for (; isRefused && bytes > 65536; isRefused = vtkOITAllocation::TakeErrors())
  {
    bytes = RoundUp(bytes / 2, 65536);
    glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, nullptr, GL_DYNAMIC_COPY);
  }
  if (isRefused)
  {
    return vtkOITFailure::OfMemory("OpenGL has no memory for the fragments of an A-buffer");
  }
  this->PoolBytes = bytes;
  this->NodesInImage = bytes > capabilities.MaximumStorageBlockSize;
  if (bytes / BytesPerTexel <= capabilities.MaximumTextureBufferSize)
  {
    this->PoolTexture = MakeBufferTexture(GL_RGBA32UI, this->Pool);
  }
  if (vtkOITAllocation::TakeErrors())
  {
    glDeleteTextures(1, &this->PoolTexture);
    this->PoolTexture = 0; // stages read the storage buffer then
  }
  if (this->NodesInImage && this->PoolTexture == 0)
  {
    return vtkOITFailure::OfMemory("OpenGL has no memory for the fragments of an A-buffer");
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::Begin(const vtkOITRectangle& rectangle)
{
  this->Rectangle = rectangle;
  this->Grid = vtkOITTileGrid(rectangle);
  const GLuint end = 0;
  glClearTexSubImage(this->Heads, 0, this->WholeFramebuffer ? rectangle.X : 0,
    this->WholeFramebuffer ? rectangle.Y : 0, 0, rectangle.Width, rectangle.Height, 1,
    GL_RED_INTEGER, GL_UNSIGNED_INT, &end);
  const std::vector<std::uint32_t> words = this->MakeCounters();
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->CounterBuffer);
  glBufferSubData(
    GL_SHADER_STORAGE_BUFFER, 0, GetBytes(static_cast<std::int64_t>(words.size())), words.data());
  glBindImageTexture(OIT_IMAGE_HEADS, this->Heads, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, OIT_BUFFER_COUNTERS, this->CounterBuffer);
  if (this->NodesInImage)
  {
    glBindImageTexture(
      OIT_IMAGE_NODES, this->PoolTexture, 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32UI);
  }
  else
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, OIT_BUFFER_NODES, this->Pool);
  }
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITFragmentStore::BindHeadFramebuffer(vtkOpenGLState* state)
{
  if (this->HeadFramebuffer == 0)
  {
    glGenFramebuffers(1, &this->HeadFramebuffer);
  }
  return vtkOITBindWithSharedDepth(state, this->HeadFramebuffer, { this->Heads, -1, 0 });
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::SetUniforms(vtkShaderProgram* program) const
{
  const int origin[2] = { this->WholeFramebuffer ? 0 : this->Rectangle.X,
    this->WholeFramebuffer ? 0 : this->Rectangle.Y };
  const int corner[2] = { this->Rectangle.X, this->Rectangle.Y };
  const int size[2] = { this->Rectangle.Width, this->Rectangle.Height };
  const int firstTile[2] = { this->Grid.FirstColumn, this->Grid.FirstRow };
  program->SetUniform2i("oitOrigin", origin);
  program->SetUniform2i("oitCorner", corner);
  program->SetUniform2i("oitSize", size);
  program->SetUniform2i("oitFirstTile", firstTile);
  program->SetUniformi("oitTileColumns", this->Grid.Columns);
  program->SetUniformi("oitCapacity", static_cast<int>(this->Nodes));
  float strides[3] = { 0.0f, 0.0f, 0.0f };
  if (this->Regions)
  {
    const vtkOITTileGrid& grid = this->Regions->GetGrid();
    const int row = OIT_REGION_WORDS * grid.Columns;
    strides[0] = OIT_REGION_WORDS;
    strides[1] = static_cast<float>(row);
    strides[2] = static_cast<float>(
      this->GetFirstRegionWord() - OIT_REGION_WORDS * grid.FirstColumn - row * grid.FirstRow);
  }
  program->SetUniform3f("oitRegionStrides", strides);
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::SetCheckUniforms(vtkShaderProgram* program) const
{
  this->SetUniforms(program);
  program->SetUniformi("oitRegionColumns", this->Regions->GetGrid().Columns);
  program->SetUniformi("oitFirstRegionWord", this->GetFirstRegionWord());
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::SetExpected(const std::vector<std::uint32_t>& tiles)
{
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->ExpectedBuffer);
  glBufferSubData(
    GL_SHADER_STORAGE_BUFFER, 0, GetExpectedBytes(static_cast<int>(tiles.size())), tiles.data());
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::BindTiles(vtkOpenGLState* state, int textureUnit) const
{
  state->vtkglActiveTexture(GL_TEXTURE0 + textureUnit);
  glBindTexture(GL_TEXTURE_BUFFER, this->CounterTexture);
  state->vtkglActiveTexture(GL_TEXTURE0 + textureUnit + 1);
  glBindTexture(GL_TEXTURE_BUFFER, this->ExpectedTexture);
  if (this->PoolTexture != 0)
  {
    state->vtkglActiveTexture(GL_TEXTURE0 + OIT_UNIT_NODES);
    glBindTexture(GL_TEXTURE_BUFFER, this->PoolTexture);
  }
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::UnbindTiles(vtkOpenGLState* state, int textureUnit) const
{
  for (const int unit : { textureUnit, textureUnit + 1, OIT_UNIT_NODES })
  {
    state->vtkglActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, 0);
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkOITFragmentStore::GetSizeInBytes() const
{
  return this->PoolBytes + INT64_C(4) * this->Width * this->Height +
    (this->CounterBuffer ? GetBytes(this->CounterWords) + GetExpectedBytes(this->TileCapacity) : 0);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITFragmentStore::GetFixedBytes(const vtkOITRectangle& rectangle)
{
  const auto count = [&rectangle](int size)
  { return (rectangle.Width / size + 2) * (rectangle.Height / size + 2); };
  const int tiles = count(vtkOITTileGrid::TileSize);
  return 4 * rectangle.GetArea() + GetBytes(GetCounterWords(tiles, count(OIT_REGION_SIZE))) +
    GetExpectedBytes(tiles);
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::Delete()
{
  vtkOITDeleteFramebuffer(this->GetWindow(), this->HeadFramebuffer);
  glDeleteTextures(1, &this->Heads);
  glDeleteTextures(1, &this->PoolTexture);
  glDeleteTextures(1, &this->CounterTexture);
  glDeleteTextures(1, &this->ExpectedTexture);
  glDeleteBuffers(1, &this->Pool);
  glDeleteBuffers(1, &this->CounterBuffer);
  glDeleteBuffers(1, &this->ExpectedBuffer);
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::Forget()
{
  this->HeadFramebuffer = this->Heads = this->Pool = this->PoolTexture = this->CounterBuffer =
    this->CounterTexture = 0;
  this->ExpectedBuffer = this->ExpectedTexture = 0;
  this->TileCapacity = 0;
  this->CounterWords = 0;
  this->Regions = nullptr;
  this->Width = this->Height = 0;
  this->PoolBytes = this->Nodes = 0;
  this->NodesInImage = false;
}
