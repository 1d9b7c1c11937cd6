// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/GL/vtkOITTextureArray.h"

#include "Private/GL/vtkOITAllocation.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <string>

namespace
{
/// Format and type of (absent) pixels that glTexImage3D accepts for an internal format.
struct Upload
{
  GLenum Format;
  GLenum Type;
};

Upload GetUpload(GLenum format)
{
  switch (format)
  {
    case GL_RGBA32UI:
      return { GL_RGBA_INTEGER, GL_UNSIGNED_INT };
    case GL_DEPTH_COMPONENT32F:
      return { GL_DEPTH_COMPONENT, GL_FLOAT };
    default:
      return { GL_RGBA, GL_FLOAT };
  }
}
}

//------------------------------------------------------------------------------
int vtkOITTextureArray::GetBytesPerTexel(GLenum format)
{
  switch (format)
  {
    case GL_DEPTH_COMPONENT32F:
    case GL_R32F:
      return 4;
    case GL_RGBA16F:
    case GL_RG32F:
      return 8;
    default: // GL_RGBA32F, GL_RGBA32UI
      return 16;
  }
}

//------------------------------------------------------------------------------
vtkOITFailure vtkOITTextureArray::Reserve(
  vtkOpenGLRenderWindow* window, int width, int height, int layers, GLenum format)
{
  this->New = !(this->Attach(window) && this->Texture && this->Format == format &&
    this->Layers == layers && this->Width >= width && this->Height >= height);
  if (!this->New)
  {
    return {};
  }
  this->Release();
  this->Attach(window);
  this->Format = format;
  this->Width = width;
  this->Height = height;
  this->Layers = layers;
  glGenTextures(1, &this->Texture);
  this->Serial = vtkOITAttachment::MakeSerial();
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Texture);
  const Upload upload = GetUpload(format);
  const vtkOITAllocation allocation;
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(format), width, height, layers, 0,
    upload.Format, upload.Type, nullptr);
  vtkOITFailure failure = allocation.Check(std::to_string(layers) + " layers of " +
    std::to_string(width) + " x " + std::to_string(height) + " pixels");
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
  if (failure)
  {
    this->Release();
  }
  return failure;
}

//------------------------------------------------------------------------------
std::vector<vtkOITAttachment> vtkOITTextureArray::GetAllLayers() const
{
  std::vector<vtkOITAttachment> layers;
  for (int i = 0; i < this->Layers; ++i)
  {
    layers.push_back(this->GetLayer(i));
  }
  return layers;
}

//------------------------------------------------------------------------------
void vtkOITTextureArray::Bind(vtkOpenGLState* state, int unit) const
{
  state->vtkglActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Texture);
}

//------------------------------------------------------------------------------
void vtkOITTextureArray::Unbind(vtkOpenGLState* state, int unit)
{
  state->vtkglActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

//------------------------------------------------------------------------------
std::int64_t vtkOITTextureArray::GetSizeInBytes() const
{
  return this->Texture == 0
    ? 0
    : std::int64_t(this->Width) * this->Height * this->Layers * GetBytesPerTexel(this->Format);
}

//------------------------------------------------------------------------------
void vtkOITTextureArray::Delete()
{
  glDeleteTextures(1, &this->Texture);
}

//------------------------------------------------------------------------------
void vtkOITTextureArray::Forget()
{
  this->Texture = 0;
  this->Format = 0;
  this->Width = 0;
  this->Height = 0;
  this->Layers = 0;
}
