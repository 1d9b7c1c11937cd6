// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITFramebuffer_h
#define vtkOITFramebuffer_h

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFailure.h"
#include "Private/GL/vtkOITContextObjects.h"

#include <cstdint>
#include <vector>

/// What a framebuffer draws into: a layer of a texture array, or a texture of two dimensions.
struct vtkOITAttachment
{
  GLuint Texture = 0;       // 0: nothing
  GLint Layer = -1;         // -1: not an array
  std::uint64_t Serial = 0; // of the texture: GL gives names of deleted ones to new ones

  bool operator==(const vtkOITAttachment& other) const
  {
    return this->Texture == other.Texture && this->Layer == other.Layer &&
      this->Serial == other.Serial;
  }

  /// The serial number for a new texture.
  static std::uint64_t MakeSerial();
};

/// The failure of a framebuffer that is not complete.
vtkOITFailure vtkOITRefuseFramebuffer();

/// Attaches to a point of the framebuffer bound for drawing.
void vtkOITAttachTo(GLenum point, const vtkOITAttachment& attachment);

/// Deletes it, in its context, which is current. OpenGL ends its binding, and VTK's state is told:
/// it would take a new framebuffer of the same name for bound.
void vtkOITDeleteFramebuffer(vtkOpenGLRenderWindow* window, GLuint framebuffer);

/// A framebuffer of the textures that a pass draws into.
class vtkOITFramebuffer : public vtkOITContextObjects
{
public:
  ~vtkOITFramebuffer() override { this->Release(); }

  /// Binds it for drawing into all of `colors` (at most 8), under the depth test against `depth`.
  /// Fails when the driver does not accept the textures together.
  vtkOITFailure Bind(vtkOpenGLRenderWindow* window, const std::vector<vtkOITAttachment>& colors,
    const vtkOITAttachment& depth = {});

  /// Of the colours bound, draws only into the first so many.
  static void DrawInto(int numberOfColors);

  GLuint GetName() const { return this->Framebuffer; }
  /// The name, of a new framebuffer if there was none, for attaching to it otherwise.
  GLuint Make(vtkOpenGLRenderWindow* window);

private:
  void Delete() override;
  void Forget() override;

  GLuint Framebuffer = 0;
  std::vector<vtkOITAttachment> Colors;
  vtkOITAttachment Depth;
  bool IsComplete = false;
};

#endif
