// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITABufferResolver_h
#define vtkOITABufferResolver_h

#include "Private/ABuffer/vtkOITABufferShaders.h"
#include "Private/ABuffer/vtkOITDepthComplexityMap.h"
#include "Private/ABuffer/vtkOITFragmentStore.h"
#include "Private/ABuffer/vtkOITTileStages.h"
#include "Private/GL/vtkOITScreenStage.h"

#include <array>
#include <limits>
#include <utility>

struct vtkOITFrame;
class vtkOITLights;
class vtkShaderProgram;

/**
 * What an A-buffer does after capture, for the current rectangle of a store:
 *
 * 1. Each tile is drawn with the smallest sorting network that takes the depth complexity it had
 *    in the last frame, or by Walk until that network has been earned (vtkOITTileStages); beyond the
 *    largest one, as in step 3.
 * 2. Counters and tiles are read back: normally the only time that the pass waits for the GPU.
 * 3. Tiles with pixels that were left, if any, get a second chance by Walk or, where many lists are
 *    long, by SecondChance, in which the nearest fragments of longer lists may be enough; other long
 *    lists and coincident fragments are sorted and composited.
 *
 * Multisampled framebuffers: Count, then all lists are sorted and composited once a sample. Frames
 * with volumes: Count, all lists are sorted, volumes are drawn, what they leave is composited.
 * Deferred shading: networks sort and light, and what they do not take is sorted, lit and composited;
 * there is no Walk and no second chance.
 */
class vtkOITABufferResolver
{
public:
  /// Programs for these shaders from now on.
  void SetShaders(const vtkOITABufferShaders& shaders);

  /// Draws into the framebuffer, unless the store has overflowed: then nothing is drawn. Changes
  /// blending, colour mask and viewport. When it fails, nothing is drawn; `fault` tells what was
  /// left out of what was drawn. `drawVolumes`, with shaders for volumes: draws them, once all lists
  /// are sorted.
  vtkOITFailure Resolve(const vtkOITFrame& frame, vtkOITFragmentStore& store,
    vtkOITFragmentStore::Counters& counters, std::string& fault,
    const std::function<void()>& drawVolumes = {});

  /// Behind a transmittance of at most this, long lists need not be composited. Default 0.
  void SetThreshold(float threshold) { this->Threshold = threshold; }

  /// With shaders for deferred shading: the lights, which must outlive the next Resolve().
  void SetLights(vtkOITLights* lights) { this->Lights = lights; }

  void Release();

  /// The longest list that Sort and Composite can handle on every driver: one merge over it stays
  /// below llvmpipe's 65535 loop iterations of a shader.
  static constexpr int LongestList = 40000;

private:
  /// Of tiles as in vtkOITABufferTileVS.glsl: those with fragments.
  static constexpr std::array<int, 2> AllTiles = { 1, std::numeric_limits<int>::max() };

  /// What shaders stored before is what the next ones load.
  static void WaitForStores();
  vtkOITFailure Check(const vtkOITFrame& frame, const vtkOITFragmentStore& store);
  vtkOITFailure Count(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
    vtkOITFragmentStore::Counters& counters);
  void PrepareOutput(const vtkOITFrame& frame, const vtkOITFragmentStore& store) const;
  using TileDraw = vtkOITTileStages::Draw;
  vtkOITFailure DrawExpected(
    const vtkOITFrame& frame, const vtkOITFragmentStore& store, const std::vector<TileDraw>& draws);
  vtkOITFailure DrawWhatIsLeft(
    const vtkOITFrame& frame, vtkOITFragmentStore& store, vtkOITFragmentStore::Counters& counters);
  vtkOITFailure SortLists(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
    const vtkOITFragmentStore::Counters& counters, std::array<int, 2> tileClass);
  vtkOITFailure SortShortLists(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
    const vtkOITFragmentStore::Counters& counters);
  vtkOITFailure Sort(vtkOITScreenStage& stage, int runSize, const vtkOITFrame& frame,
    const vtkOITFragmentStore& store, const std::array<int, 2>& tileClass,
    const std::pair<int, int>& widths);
  vtkOITFailure Composite(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
    const std::array<int, 2>& tileClass);
  vtkOITFailure ShadeLongLists(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
    int longest, const std::array<int, 2>& tileClass);
  vtkOITFailure DrawLists(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
    vtkOITFragmentStore::Counters& counters, const std::array<int, 2>& tileClass,
    const std::function<void()>& drawVolumes = {});
  vtkOITFailure DrawTiles(vtkOITScreenStage& stage, const vtkOITFrame& frame,
    const vtkOITFragmentStore& store, const std::array<int, 2>& tileClass,
    const std::function<std::string()>& getFragmentShader,
    const std::function<void(vtkShaderProgram*)>& setMore = {});

  vtkOITABufferShaders Shaders;
  float Threshold = 0.0f;
  vtkOITDepthComplexityMap DepthComplexity;
  vtkOITScreenStage CheckStage;
  vtkOITScreenStage CountStage;
  vtkOITTileStages TileStages;
  std::int64_t SortedTiles = 0; // with lists that networks left
  vtkOITScreenStage QuickSortStage;
  vtkOITScreenStage SortStage;
  /// The same for tiles with short lists only, with less to do.
  static constexpr std::array<int, 2> ShortLists = { 4, 8 };
  std::array<vtkOITScreenStage, ShortLists.size()> ShortSortStages;
  vtkOITScreenStage ShadeStage;
  vtkOITScreenStage CompositeStage;
  vtkOITLights* Lights = nullptr;
};

#endif
