// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITABufferResolver_h
#define vtkOITABufferResolver_h

#include "vtkOITABufferShaders.h"
#include "vtkOITFragmentStore.h"
#include "vtkOITScreenStage.h"

#include <array>

class vtkOITFrame;
class vtkShaderProgram;

/**
 * What an A-buffer does after capture, for the current rectangle of a store:
 *
 * 1. Count() finds the depth complexity of tiles, and reads it and the counters back.
 * 2. Composite() draws each tile with the smallest sorting network that takes its pixels. What
 *    no network takes, longer lists and coincident fragments, is sorted and composited after.
 *    Multisampled framebuffers: all lists are sorted, then composited once a sample.
 */
class vtkOITABufferResolver
{
public:
  /// Programs for these shaders from now on.
  void SetShaders(const vtkOITABufferShaders& shaders);

  vtkOITFragmentStore::Counters Count(const vtkOITFrame& frame, const vtkOITFragmentStore& store);

  /// `counters` must be free of overflow. Changes blending, draw buffers, colour mask, viewport.
  void Composite(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
    const vtkOITFragmentStore::Counters& counters);

  void Release();

  /// The longest list that Sort and Composite can handle on every driver: one merge pass over it
  /// stays below llvmpipe's 65535 loop iterations of a shader.
  static constexpr int LongestList = 40000;

private:
  void DrawTiles(vtkOITScreenStage& stage, const vtkOITFrame& frame,
    const vtkOITFragmentStore& store, int smallest, int largest, bool tied,
    const std::function<std::string()>& getFragmentShader,
    const std::function<void(vtkShaderProgram*)>& setMore = {});
  void CompositeLists(
    const vtkOITFrame& frame, const vtkOITFragmentStore& store, int maximum, int smallest);

  vtkOITABufferShaders Shaders;
  vtkOITScreenStage CountStage;
  std::array<vtkOITScreenStage, vtkOITABufferShaders::NetworkSizes.size()> ResolveStages;
  vtkOITScreenStage SortStage;
  vtkOITScreenStage CompositeStage;
};

#endif
