// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITFragmentStore.h"

#include "vtkOITCapabilities.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
constexpr std::int64_t BytesPerTexel = 16; // of the pool as a buffer texture, GL_RGBA32UI

constexpr std::int64_t RoundUp(std::int64_t value, std::int64_t step)
{
  return (value + step - 1) / step * step;
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
void vtkOITFragmentStore::Reserve(vtkOpenGLRenderWindow* window,
  const vtkOITCapabilities& capabilities, const vtkOITRectangle& rectangle, std::int64_t nodes,
  int bytesPerNode)
{
  this->Attach(window);
  if (this->CounterBuffer == 0)
  {
    glGenBuffers(1, &this->CounterBuffer);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->CounterBuffer);
    glBufferData(GL_SHADER_STORAGE_BUFFER, sizeof(Counters), nullptr, GL_DYNAMIC_READ);
  }
  this->ReserveHeads(rectangle.Width, rectangle.Height);
  if (this->PoolBytes < nodes * bytesPerNode)
  {
    // Whole pages of 64 KiB, never beyond what can be addressed.
    this->ReservePool(std::min(RoundUp(nodes * bytesPerNode, 65536), GetLargestPool(capabilities)),
      capabilities);
  }
  this->Capacity = this->PoolBytes / bytesPerNode;
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::ReserveHeads(int width, int height)
{
  if (this->Width >= width && this->Height >= height)
  {
    return;
  }
  this->Width = std::max(this->Width, width);
  this->Height = std::max(this->Height, height);
  glDeleteTextures(1, &this->Heads);
  glGenTextures(1, &this->Heads);
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glBindTexture(GL_TEXTURE_2D, this->Heads);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_R32UI, this->Width, this->Height);
  glBindTexture(GL_TEXTURE_2D, bound);
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::ReservePool(
  std::int64_t bytes, const vtkOITCapabilities& capabilities)
{
  glDeleteTextures(1, &this->PoolTexture);
  glDeleteBuffers(1, &this->Pool);
  this->PoolTexture = 0;
  glGenBuffers(1, &this->Pool);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Pool);
  while (glGetError() != GL_NO_ERROR)
  {
  }
  // Halve what the context refuses: a smaller pool costs bands, not correctness.
  glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, nullptr, GL_DYNAMIC_COPY);
  while (glGetError() == GL_OUT_OF_MEMORY && bytes > 65536)
  {
    bytes = RoundUp(bytes / 2, 65536);
    glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, nullptr, GL_DYNAMIC_COPY);
  }
  this->PoolBytes = bytes;
  this->NodesInImage = bytes > capabilities.MaximumStorageBlockSize;
  if (this->NodesInImage)
  {
    glGenTextures(1, &this->PoolTexture);
    GLint bound = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &bound);
    glBindTexture(GL_TEXTURE_BUFFER, this->PoolTexture);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, this->Pool);
    glBindTexture(GL_TEXTURE_BUFFER, bound);
  }
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::Begin(const vtkOITRectangle& rectangle)
{
  const GLuint end = 0xffffffffu;
  glClearTexSubImage(this->Heads, 0, 0, 0, 0, rectangle.Width, rectangle.Height, 1, GL_RED_INTEGER,
    GL_UNSIGNED_INT, &end);
  const Counters zero;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->CounterBuffer);
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(Counters), &zero);
  glBindImageTexture(0, this->Heads, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, this->CounterBuffer);
  if (this->NodesInImage)
  {
    glBindImageTexture(1, this->PoolTexture, 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32UI);
  }
  else
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, this->Pool);
  }
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::SetUniforms(
  vtkShaderProgram* program, const vtkOITRectangle& rectangle) const
{
  const int origin[2] = { rectangle.X, rectangle.Y };
  program->SetUniform2i("oitOrigin", origin);
  program->SetUniformi("oitCapacity", static_cast<int>(this->Capacity));
}

//------------------------------------------------------------------------------
vtkOITFragmentStore::Counters vtkOITFragmentStore::ReadCounters() const
{
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  Counters counters;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->CounterBuffer);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(Counters), &counters);
  return counters;
}

//------------------------------------------------------------------------------
std::int64_t vtkOITFragmentStore::GetSizeInBytes() const
{
  return this->PoolBytes + INT64_C(4) * this->Width * this->Height +
    (this->CounterBuffer ? static_cast<std::int64_t>(sizeof(Counters)) : 0);
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::Delete()
{
  glDeleteTextures(1, &this->Heads);
  glDeleteTextures(1, &this->PoolTexture);
  glDeleteBuffers(1, &this->Pool);
  glDeleteBuffers(1, &this->CounterBuffer);
}

//------------------------------------------------------------------------------
void vtkOITFragmentStore::Forget()
{
  this->Heads = this->Pool = this->PoolTexture = this->CounterBuffer = 0;
  this->Width = this->Height = 0;
  this->PoolBytes = this->Capacity = 0;
  this->NodesInImage = false;
}
