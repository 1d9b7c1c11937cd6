// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/ABuffer/vtkOITFragmentReadback.h"

#include "Private/ABuffer/vtkOITABufferShaders.h"
#include "Private/ABuffer/vtkOITFragmentStore.h"
#include "Private/GL/vtkOITReadback.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr int Components = 7;

float BitsToFloat(std::uint32_t bits)
{
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

// Of a finite half float that is not negative: others are not stored.
float HalfToFloat(std::uint32_t half)
{
  const int exponent = static_cast<int>(half >> 10) & 31;
  const int mantissa = static_cast<int>(half & 1023u);
  return exponent == 0 ? std::ldexp(static_cast<float>(mantissa), -24)
                       : std::ldexp(static_cast<float>(mantissa + 1024), exponent - 25);
}
}

//------------------------------------------------------------------------------
std::string vtkOITFragmentReadback::Refuse(vtkFloatArray* array) const
{
  if (array)
  {
    array->SetNumberOfComponents(Components);
    array->SetNumberOfTuples(0);
  }
  return "the last frame captured no fragments; render one with translucent props in view first";
}

//------------------------------------------------------------------------------
std::string vtkOITFragmentReadback::Read(
  bool isWhole, std::int64_t fragments, vtkFloatArray* array) const
{
  std::string nothing = this->Refuse(array);
  if (!array)
  {
    return "no array was given for the fragments; create one, e.g. vtkFloatArray::New()";
  }
  if (this->Shaders.Samples > 0)
  {
    return "fragments cannot be read back from a multisampled framebuffer; call "
           "SetMultiSamples(0) of the render window";
  }
  vtkOpenGLRenderWindow* window = this->Store.GetWindow();
  if (!window)
  {
    return nothing;
  }
  if (!isWhole)
  {
    return "the last frame was drawn in bands, and only the last one is left; raise "
           "MaximumBufferSize, or render a smaller picture";
  }
  window->PushContext();
  const vtkOITReadback readback;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  const std::int64_t end = this->Store.ReadCounters().EndOfNodes;
  const std::vector<std::uint32_t> heads = this->ReadHeads();
  const std::vector<std::uint32_t> nodes =
    this->ReadNodes(std::min(end, this->Store.GetCapacity() + 1));
  window->PopContext();

  const vtkOITFragmentStore::Lists lists = this->Store.GetLists();
  const vtkOITRectangle& rectangle = this->Store.GetRectangle();
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(fragments) * Components);
  for (int y = rectangle.Y; y < rectangle.Y + rectangle.Height; ++y)
  {
    for (int x = rectangle.X; x < rectangle.X + rectangle.Width; ++x)
    {
      const std::size_t texel =
        static_cast<std::size_t>(y - lists.OriginY) * lists.Width + (x - lists.OriginX);
      this->Append(heads[texel] & ~OIT_LEFT, nodes, x, y, values);
    }
  }
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / Components));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return {};
}

//------------------------------------------------------------------------------
void vtkOITFragmentReadback::Append(std::uint32_t node, const std::vector<std::uint32_t>& nodes,
  int x, int y, std::vector<float>& values) const
{
  const std::size_t wordsPerNode = this->Shaders.GetBytesPerNode() / sizeof(std::uint32_t);
  while (node != 0u)
  {
    const std::uint32_t* word = &nodes[node * wordsPerNode];
    values.insert(
      values.end(), { static_cast<float>(x), static_cast<float>(y), BitsToFloat(word[0]) });
    if (this->Shaders.FloatColor)
    {
      values.insert(values.end(),
        { BitsToFloat(word[4]), BitsToFloat(word[5]), BitsToFloat(word[6]), BitsToFloat(word[7]) });
    }
    else
    {
      values.insert(values.end(),
        { HalfToFloat(word[1] & 0xffffu), HalfToFloat(word[1] >> 16),
          HalfToFloat(word[2] & 0xffffu), HalfToFloat(word[2] >> 16) });
    }
    values.back() = values.back() < OIT_LIGHT ? values.back() : 0.0f; // light has no opacity
    node = word[3];
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkOITFragmentReadback::ReadHeads() const
{
  const vtkOITFragmentStore::Lists lists = this->Store.GetLists();
  std::vector<std::uint32_t> heads(static_cast<std::size_t>(lists.Width) * lists.Height);
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glBindTexture(GL_TEXTURE_2D, lists.Heads);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, heads.data());
  glBindTexture(GL_TEXTURE_2D, bound);
  return heads;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkOITFragmentReadback::ReadNodes(std::int64_t nodes) const
{
  const std::int64_t bytes = nodes * this->Shaders.GetBytesPerNode();
  std::vector<std::uint32_t> words(static_cast<std::size_t>(bytes) / sizeof(std::uint32_t));
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Store.GetLists().Pool);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, words.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return words;
}
