// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITLights_h
#define vtkOITLights_h

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFailure.h"
#include "Private/GL/vtkOITContextObjects.h"

#include <array>
#include <cstdint>
#include <vector>

struct vtkOITFrame;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkRenderer;
class vtkShaderProgram;

/**
 * The lights of a renderer in a buffer, in view coordinates, as glsl/Deferred/vtkOITDeferredLightFS.glsl
 * reads them: their number and kind are data, so that no shader depends on them. 64 bytes a light.
 */
class vtkOITLights : public vtkOITContextObjects
{
public:
  ~vtkOITLights() override { this->Release(); }

  /// Takes those that are switched on, and copies them to the context.
  vtkOITFailure Update(const vtkOITFrame& frame);
  int GetNumberOfLights() const { return this->Ends[2]; }
  /// Whether there are so many that it pays to light fragments after they were sorted; `isDone`: it was
  /// done in the last frame, which half as many are enough for.
  bool Pays(bool isDone) const;

  /// Binds them as a buffer texture of the unit.
  void Bind(vtkOpenGLState* state, int textureUnit) const;
  void Unbind(vtkOpenGLState* state, int textureUnit) const;

  /// Sets the uniforms of a program that includes vtkOITDeferredLightFS.glsl, and whose fragment
  /// (0, 0) is the pixel (x, y) of the framebuffer.
  void SetUniforms(vtkShaderProgram* program, const vtkOITFrame& frame, int textureUnit, int x = 0,
    int y = 0) const;

  std::int64_t GetSizeInBytes() const { return this->Capacity; }

private:
  void Delete() override;
  void Forget() override;
  void Find(vtkRenderer* renderer);
  vtkOITFailure Upload();

  std::vector<float> Texels;
  std::array<int, 3> Ends{}; // of the directional, the positional and the spot lights
  bool IsHeadlight = false;  // the only one, which VTK lights by in a way of its own
  GLuint Buffer = 0;
  GLuint Texture = 0;
  GLsizeiptr Capacity = 0;
};

#endif
