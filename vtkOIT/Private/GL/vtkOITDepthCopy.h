// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDepthCopy_h
#define vtkOITDepthCopy_h

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFailure.h"
#include "Private/Frame/vtkOITFrame.h"
#include "Private/GL/vtkOITContextObjects.h"
#include "Private/GL/vtkOITFramebuffer.h"

#include <cstdint>

class vtkOpenGLState;

/**
 * A texture with the depth of the bound framebuffer, for shaders that must do the depth test
 * themselves. It has exactly the format of the depth buffer, which glBlitFramebuffer asks for, and
 * its number of samples.
 */
class vtkOITDepthCopy : public vtkOITContextObjects
{
public:
  ~vtkOITDepthCopy() override { this->Release(); }

  /// Copies the rectangle out of the framebuffer bound for drawing, which stays bound. The texture
  /// covers `storage`, whose lower left corner becomes texel (0, 0); texels outside of the
  /// rectangle are undefined. Ends with the texture bound to `unit`, numbered from 0.
  vtkOITFailure Copy(const vtkOITFrame& frame, const vtkOITRectangle& storage,
    const vtkOITRectangle& rectangle, int unit);
  void Bind(vtkOpenGLState* state, int unit) const { this->BindTo(state, unit, this->Texture); }
  void Unbind(vtkOpenGLState* state, int unit) const { this->BindTo(state, unit, 0); }

  vtkOITAttachment GetAttachment() const { return { this->Texture, -1, this->Serial }; }
  std::int64_t GetSizeInBytes() const;

  /// Bytes that a copy of the rectangle takes.
  static std::int64_t GetBytes(const vtkOITRectangle& rectangle, const vtkOITTarget& target);

private:
  void BindTo(vtkOpenGLState* state, int unit, GLuint texture) const;
  void Delete() override;
  void Forget() override;
  vtkOITFailure Allocate(const vtkOITFrame& frame, const vtkOITRectangle& rectangle, int unit);

  GLuint Texture = 0;
  std::uint64_t Serial = 0;
  GLuint Framebuffer = 0;
  GLenum Target = GL_TEXTURE_2D;
  GLenum Format = 0;
  int Samples = 0;
  std::int64_t Bytes = 0;
  int Width = 0;
  int Height = 0;
};

#endif
