// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITLayerFramebuffer_h
#define vtkOITLayerFramebuffer_h

#include "vtkOITCompatibility.h"
#include "vtkOITContextObjects.h"

class vtkOITDepthCopy;
class vtkOITTextureArray;
class vtkOpenGLState;

/// A framebuffer whose colour buffers are the layers of a texture array.
class vtkOITLayerFramebuffer : public vtkOITContextObjects
{
public:
  ~vtkOITLayerFramebuffer() override { this->Release(); }

  /// Binds it for drawing: layers from `firstLayer` on become the first colour buffers, all drawn
  /// to. `colors` may be nullptr for none, `depth` is a copy of the depth buffer, or an array of
  /// one layer of depth, or nullptr for none.
  ///@{
  bool Bind(vtkOpenGLRenderWindow* window, const vtkOITTextureArray* colors, int firstLayer,
    int numberOfLayers, const vtkOITDepthCopy* depth);
  bool Bind(vtkOpenGLRenderWindow* window, const vtkOITTextureArray* colors, int firstLayer,
    int numberOfLayers, const vtkOITTextureArray* depth);
  ///@}

private:
  void Delete() override;
  void Forget() override;
  void Begin(vtkOpenGLRenderWindow* window);
  bool Finish(const vtkOITTextureArray* colors, int firstLayer, int numberOfLayers);

  GLuint Framebuffer = 0;
  int NumberOfColors = 0;
};

#endif
