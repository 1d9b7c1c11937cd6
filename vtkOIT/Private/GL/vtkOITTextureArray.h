// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITTextureArray_h
#define vtkOITTextureArray_h

#include "Private/Frame/vtkOITFailure.h"
#include "Private/GL/vtkOITFramebuffer.h"

#include <cstdint>

class vtkOpenGLState;

/**
 * Layers of texels of one format, for what a pass keeps in each pixel: a shader reads all layers
 * through one texture unit, and a vtkOITFramebuffer draws into several at once.
 */
class vtkOITTextureArray : public vtkOITContextObjects
{
public:
  ~vtkOITTextureArray() override { this->Release(); }

  /// At least so many pixels, of exactly this format and number of layers. The contents of a new
  /// texture are undefined; see IsNew().
  vtkOITFailure Reserve(
    vtkOpenGLRenderWindow* window, int width, int height, int layers, GLenum format);

  /// Whether the last Reserve() has made a new texture.
  bool IsNew() const { return this->New; }

  /// For drawing into it.
  vtkOITAttachment GetLayer(int layer) const { return { this->Texture, layer, this->Serial }; }
  std::vector<vtkOITAttachment> GetAllLayers() const;
  int GetNumberOfLayers() const { return this->Layers; }

  /// Binds it to a texture unit, numbered from 0; a sampler2DArray (or usampler2DArray) reads it.
  void Bind(vtkOpenGLState* state, int unit) const;
  static void Unbind(vtkOpenGLState* state, int unit);

  std::int64_t GetSizeInBytes() const;

  /// Of a texel of the formats that the passes use.
  static int GetBytesPerTexel(GLenum format);

private:
  void Delete() override;
  void Forget() override;

  GLuint Texture = 0;
  std::uint64_t Serial = 0;
  GLenum Format = 0;
  int Width = 0;
  int Height = 0;
  int Layers = 0;
  bool New = false;
};

#endif
