// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITFragmentStore_h
#define vtkOITFragmentStore_h

#include "Private/ABuffer/vtkOITTileGrid.h"
#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITFailure.h"
#include "Private/Frame/vtkOITRectangle.h"
#include "Private/GL/vtkOITContextObjects.h"

#include "glsl/Common/vtkOITConstants.h"

#include <algorithm>
#include <cstdint>
#include <vector>

class vtkOITCapabilities;
class vtkOITNodeRegions;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

/**
 * The memory of an A-buffer: list heads (one texel a pixel), the pool of nodes, the counters and
 * the depth complexity of tiles. The layout is that of glsl/ABuffer/vtkOITABufferNodeFS.glsl.
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
    /// Nodes that were asked for; those of pages are counted as a whole.
    std::int64_t NodeCount = 0;
    /// All nodes that were used are before this one.
    std::int64_t EndOfNodes = 0;
    /// How often the counter was used that all threads share.
    std::int64_t SharedAllocations = 0;
    /// Fragments of all pixels, once they are resolved without multisampling.
    std::int64_t FragmentCount = 0;
    std::uint32_t Overflow = 0;
    /// Largest number of fragments of a pixel, for each tile. In tiles with a mark it is known
    /// only after the second chance.
    std::vector<std::uint32_t> Tiles;
    /// Fragments of each tile, where FragmentCount is known.
    std::vector<std::uint32_t> TileFragments;
    /// The largest transmittance in front of fragments that were not composited; 0 for none.
    float Skipped = 0.0f;
    /// All marks of tiles: OIT_TRY_AGAIN, OIT_HAS_LISTS.
    std::uint32_t Marks = 0;
    /// Tiles with OIT_HAS_LISTS.
    int MarkedTiles = 0;
  };

  /// Makes room for the rectangle's heads and for at least `fragments` fragments, as far as the
  /// context has the memory and the pool stays within `maximumPoolBytes`: see GetCapacity(). What
  /// the pool held is lost when it grows. Fails when there is no memory for a pool at all.
  vtkOITFailure Reserve(vtkOpenGLRenderWindow* window, const vtkOITCapabilities& capabilities,
    const vtkOITRectangle& rectangle, std::int64_t fragments, int bytesPerNode,
    std::int64_t maximumPoolBytes);

  /// Parts of the pool for regions of the next Begin()'s rectangle; null (default): none. Kept by the caller
  /// until the lists are not needed any more.
  void SetRegions(const vtkOITNodeRegions* regions) { this->Regions = regions; }
  const vtkOITNodeRegions* GetRegions() const { return this->Regions; }

  /// Sets the uniforms of Check, for as many pixels as there are regions.
  void SetCheckUniforms(vtkShaderProgram* program) const;

  /// Empties the lists of the rectangle, resets the counters, and binds everything: image units
  /// and storage buffers 0 and 1. The rectangle is the current one until the next call.
  void Begin(const vtkOITRectangle& rectangle);

  /// The framebuffer's pixel of the heads' first texel: the lower left corner of the rectangle, or
  /// that of the framebuffer (default off), which BindHeadFramebuffer() needs. Before Reserve().
  void SetWholeFramebuffer(bool whole) { this->WholeFramebuffer = whole; }

  /// Sets the uniforms of a program that includes vtkOITABufferNodeFS.glsl.
  void SetUniforms(vtkShaderProgram* program) const;

  /// Waits for the shaders that count.
  Counters ReadCounters() const;
  float ReadSkipped() const;

  /// Binds a framebuffer whose colour buffer are the list heads and whose depth buffer is that of
  /// the framebuffer bound for drawing, so that Gather gets the heads by framebuffer fetch. Fails,
  /// and nothing is bound, where that is not possible. After Begin().
  vtkOITFailure BindHeadFramebuffer(vtkOpenGLState* state);

  const vtkOITRectangle& GetRectangle() const { return this->Rectangle; }

  /// The GL objects of the lists, for reading them back: the texture of heads (GL_R32UI, of the
  /// given width and height), the framebuffer's pixel of its first texel, and the pool.
  struct Lists
  {
    GLuint Heads;
    int Width;
    int Height;
    int OriginX;
    int OriginY;
    GLuint Pool;
  };
  Lists GetLists() const
  {
    return { this->Heads, this->Width, this->Height, this->WholeFramebuffer ? 0 : this->Rectangle.X,
      this->WholeFramebuffer ? 0 : this->Rectangle.Y, this->Pool };
  }
  const vtkOITTileGrid& GetTileGrid() const { return this->Grid; }

  /// The depth complexity that is expected of the current rectangle's tiles.
  void SetExpected(const std::vector<std::uint32_t>& tiles);

  /// Whether BindTiles() binds the pool, too: it is not larger than a buffer texture may be.
  bool GetNodesInTexture() const { return this->PoolTexture != 0; }

  /// Binds counters and expected depth complexity as buffer textures of 32-bit integers, to
  /// `textureUnit` and the next one; and the pool, to OIT_UNIT_NODES.
  void BindTiles(vtkOpenGLState* state, int textureUnit) const;
  void UnbindTiles(vtkOpenGLState* state, int textureUnit) const;

  /// Fragments that the pool takes.
  std::int64_t GetCapacity() const { return std::max<std::int64_t>(0, this->Nodes - 1); }

  /// Nodes of the pool, those included that are never used.
  std::int64_t GetNodes() const { return this->Nodes; }

  std::int64_t GetPoolBytes() const { return this->PoolBytes; }

  /// The pool is larger than a storage block may be, so shaders reach it as an image.
  bool GetNodesInImage() const { return this->NodesInImage; }

  /// Pool, heads and counters.
  std::int64_t GetSizeInBytes() const;

  /// The largest pool that the context can address, in bytes.
  static std::int64_t GetLargestPool(const vtkOITCapabilities& capabilities);

  /// Bytes that a rectangle of this size takes beside the pool, wherever it lies.
  static std::int64_t GetFixedBytes(const vtkOITRectangle& rectangle);

private:
  void Delete() override;
  void Forget() override;
  vtkOITFailure ReserveHeads(int width, int height);
  vtkOITFailure ReserveCounters(const vtkOITRectangle& rectangle);
  std::uint32_t GetFirstNode() const;
  int GetFirstRegionWord() const;
  std::vector<std::uint32_t> MakeCounters() const;
  std::int64_t CountNodes(const std::vector<std::uint32_t>& words, std::size_t at,
    std::uint32_t first, Counters& counters) const;
  vtkOITFailure ReservePool(std::int64_t bytes, const vtkOITCapabilities& capabilities);

  GLuint Heads = 0;
  GLuint HeadFramebuffer = 0;
  GLuint Pool = 0;
  GLuint PoolTexture = 0;
  GLuint CounterBuffer = 0;
  GLuint CounterTexture = 0;
  GLuint ExpectedBuffer = 0;
  GLuint ExpectedTexture = 0;
  std::int64_t CounterWords = 0; // of the buffer
  int TileCapacity = 0;          // of the expected depth complexity
  const vtkOITNodeRegions* Regions = nullptr;
  vtkOITRectangle Rectangle;
  vtkOITTileGrid Grid;
  bool WholeFramebuffer = false;
  int Width = 0;
  int Height = 0;
  std::int64_t PoolBytes = 0;
  std::int64_t Nodes = 0; // of the pool, the unused first one included
  bool NodesInImage = false;
};

#endif
