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
 *
 * For tests only: extensions named in the environment variable VTKOIT_HIDE_EXTENSIONS (separated
 * by blanks) count as absent, so that every capability tier can be tested on one machine.
 */
class vtkOITCapabilities
{
public:
  explicit vtkOITCapabilities(vtkOpenGLRenderWindow* window);

  /// Image load/store, storage buffers with atomics, glClearTexSubImage: what an A-buffer needs.
  bool HasStorage() const { return this->MissingForStorage.empty(); }

  /// Empty, or one line: the GL version and the first extension that is missing for storage.
  const std::string& GetMissingForStorage() const { return this->MissingForStorage; }

  /// Empty, or one line: what is missing to draw into several buffers, with the bits of floats in some.
  const std::string& GetMissingForPeeling() const { return this->MissingForPeeling; }

  /// Empty, or one line: samples that pass are not counted.
  const std::string& GetMissingForCounting() const { return this->MissingForCounting; }

  /// Fragment shaders may ask for the depth test to run before them: ARB_shader_image_load_store.
  bool EarlyFragmentTests = false;
  /// ARB_fragment_shader_interlock: fragments of a pixel enter a section of a shader one by one.
  bool FragmentInterlock = false;
  /// ARB_texture_barrier: what a draw has written can be read as a texture in the next.
  bool TextureBarrier = false;
  /// EXT_shader_framebuffer_fetch: a fragment shader reads what the colour buffer holds.
  bool FramebufferFetch = false;
  /// ARB_draw_buffers_blend: colour buffers are blended in different ways at once.
  bool DrawBuffersBlend = false;
  /// ARB_sample_shading: a shader runs for each sample of a pixel.
  bool SampleShading = false;
  /// ARB_post_depth_coverage: gl_SampleMaskIn holds only the samples that passed the depth test.
  bool PostDepthCoverage = false;
  /// ARB_derivative_control: differences between the very pixels of a pair, dFdxFine().
  bool FineDerivatives = false;
  /// Bytes that one storage buffer binding reaches.
  std::int64_t MaximumStorageBlockSize = 0;
  /// Bytes of memory that the context has: of the graphics processor where the driver tells
  /// (NVX_gpu_memory_info, ATI_meminfo), otherwise of the machine.
  std::int64_t Memory = 0;
  /// Texels of a buffer texture.
  std::int64_t MaximumTextureBufferSize = 0;

private:
  std::string MissingForStorage;
  std::string MissingForPeeling;
  std::string MissingForCounting;
};

#endif
