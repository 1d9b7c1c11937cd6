// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITCapabilities_h
#define vtkOITCapabilities_h

#include <cstdint>
#include <string>

class vtkOpenGLRenderWindow;

/**
 * What the GL context of a window offers to order-independent transparency. The context must be
 * current when an object is made.
 */
class vtkOITCapabilities
{
public:
  explicit vtkOITCapabilities(vtkOpenGLRenderWindow* window);

  /// Image load/store, storage buffers with atomics, glClearTexSubImage: what an A-buffer needs.
  bool HasStorage() const { return this->MissingForStorage.empty(); }

  /// Empty, or one line: the GL version and the first extension that is missing for storage.
  const std::string& GetMissingForStorage() const { return this->MissingForStorage; }

  /// EXT_shader_framebuffer_fetch: a fragment shader reads what the colour buffer holds.
  bool FramebufferFetch = false;
  /// ARB_post_depth_coverage: gl_SampleMaskIn holds only the samples that passed the depth test.
  bool PostDepthCoverage = false;
  /// Bytes that one storage buffer binding reaches.
  std::int64_t MaximumStorageBlockSize = 0;
  /// Texels of a buffer texture.
  std::int64_t MaximumTextureBufferSize = 0;

private:
  std::string MissingForStorage;
};

#endif
