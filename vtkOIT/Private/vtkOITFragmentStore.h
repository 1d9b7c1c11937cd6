// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITFragmentStore_h
#define vtkOITFragmentStore_h

#include "vtkOITCompatibility.h"
#include "vtkOITContextObjects.h"
#include "vtkOITRectangle.h"

#include <cstdint>

class vtkOITCapabilities;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * The memory of an A-buffer: list heads (one texel a pixel), the pool of nodes, and the counters.
 * The layout is that of glsl/vtkOITABufferPassNodeFS.glsl.
 *
 * Heads and pool only grow; Release() frees them. 4 bytes per pixel, and the bytes of a node per
 * fragment.
 */
class vtkOITFragmentStore : public vtkOITContextObjects
{
public:
  ~vtkOITFragmentStore() override { this->Release(); }

  struct Counters
  {
    std::uint32_t FragmentCount = 0;
    std::uint32_t Overflow = 0;
    std::uint32_t MaximumDepthComplexity = 0;
    std::uint32_t Padding = 0;
  };

  /// Makes room for the rectangle's heads and for at least `nodes` nodes, where the context has the
  /// memory. The pool may stay smaller: see GetCapacity(). What it held is lost when it grows.
  void Reserve(vtkOpenGLRenderWindow* window, const vtkOITCapabilities& capabilities,
    const vtkOITRectangle& rectangle, std::int64_t nodes, int bytesPerNode);

  /// Empties the lists of the rectangle, resets the counters, and binds everything: image units
  /// and storage buffers 0 and 1.
  void Begin(const vtkOITRectangle& rectangle);

  /// Sets the uniforms of a program that includes vtkOITABufferPassNodeFS.glsl.
  void SetUniforms(vtkShaderProgram* program, const vtkOITRectangle& rectangle) const;

  /// Waits for the shaders that count.
  Counters ReadCounters() const;

  /// Nodes of the pool.
  std::int64_t GetCapacity() const { return this->Capacity; }

  /// The pool is larger than a storage block may be, so shaders reach it as an image.
  bool GetNodesInImage() const { return this->NodesInImage; }

  /// Pool, heads and counters.
  std::int64_t GetSizeInBytes() const;

  /// The largest pool that the context can address, in bytes.
  static std::int64_t GetLargestPool(const vtkOITCapabilities& capabilities);

private:
  void Delete() override;
  void Forget() override;
  void ReserveHeads(int width, int height);
  void ReservePool(std::int64_t bytes, const vtkOITCapabilities& capabilities);

  GLuint Heads = 0;
  GLuint Pool = 0;
  GLuint PoolTexture = 0;
  GLuint CounterBuffer = 0;
  int Width = 0;
  int Height = 0;
  std::int64_t PoolBytes = 0;
  std::int64_t Capacity = 0;
  bool NodesInImage = false;
};

#endif
