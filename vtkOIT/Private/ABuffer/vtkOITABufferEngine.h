// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITABufferEngine_h
#define vtkOITABufferEngine_h

#include "Private/ABuffer/vtkOITABufferResolver.h"
#include "Private/ABuffer/vtkOITABufferShaders.h"
#include "Private/ABuffer/vtkOITABufferVolumes.h"
#include "Private/ABuffer/vtkOITFragmentStore.h"
#include "Private/ABuffer/vtkOITNodeRegions.h"
#include "Private/ABuffer/vtkOITSolidDepth.h"
#include "Private/ABuffer/vtkOITTrial.h"
#include "Private/Deferred/vtkOITDeferredText.h"
#include "Private/Deferred/vtkOITLights.h"
#include "Private/Engine/vtkOITEngine.h"
#include "Private/Engine/vtkOITGather.h"
#include "Private/Frame/vtkOITBands.h"
#include "Private/GL/vtkOITDepthCopy.h"

class vtkFloatArray;
class vtkProp;

/// The A-buffer: see vtkOITABufferPass.
class vtkOITABufferEngine : public vtkOITEngine
{
public:
  std::string GetAlgorithmName(const vtkOITSettings& settings) const override;
  std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const override;
  std::string FindMissingIn(const vtkOITFrame& frame) const override;
  bool MixesVolumes() const override { return true; }
  bool UsesStorage(const vtkOITCapabilities&, const vtkOITSettings&) const override { return true; }
  bool SortsLight() const override { return true; }
  vtkOITFailure Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
    vtkOITGeometry& geometry, vtkOITStatistics& statistics) override;
  std::int64_t GetSizeInBytes() const override;
  void Release() override;

  /// Reads the fragments of the last frame back, as vtkOITABufferPass::GetFragments() describes
  /// them. Empty, or one line that says why there are none.
  std::string ReadFragments(vtkFloatArray* fragments) const;
  /// There is no frame to read back any more.
  void ForgetFrame() { this->NumberOfFragments = 0; }

private:
  void ChooseCapture(const Task& task);
  void ChooseShaders(const Task& task);
  void ChooseShading(const Task& task);
  std::int64_t GetLargestPool(const Task& task) const;
  void DrawSolidDepth(const Task& task);
  vtkOITFailure DrawBands(const Task& task);
  vtkOITFailure DrawBand(const Task& task, std::int64_t& needed);
  void ChooseRegions(const Task& task);
  std::int64_t FindNodesOfRegions(const Task& task) const;
  vtkOITFailure Capture(const Task& task);
  vtkOITFailure BeginBand(const Task& task);
  void SetUniforms(const Task& task, vtkShaderProgram* program, vtkProp* prop);
  vtkOITFailure Resolve(const Task& task, vtkOITFragmentStore::Counters& counters);
  void AddStatistics(const Task& task, const vtkOITFragmentStore::Counters& counters);

  vtkOITFragmentStore Store;
  vtkOITNodeRegions Regions; // of its pool
  vtkOITDepthCopy DepthCopy;
  vtkOITSolidDepth SolidDepth;
  vtkOITTrial Trial; // of leaving out hidden fragments
  vtkOITGather Gather;
  vtkOITABufferShaders Shaders;
  vtkOITABufferResolver Resolver;
  vtkOITABufferVolumes Volumes;
  vtkOITBands Bands;

  vtkOITRectangle Band;
  int NumberOfDraws = 0; // in this geometry pass
  bool HasDepthCopy = false;
  vtkOITFailure DepthCopyFailure;
  bool HasSolidDepth = false; // Gather tests against it instead of the framebuffer's
  bool HeadInTarget = false;  // list heads by framebuffer fetch instead of image atomics
  bool HeadInTargetWorks = true;
  vtkOITDeferredText DeferredText;
  vtkOITLights Lights;
  bool Defers = false;      // shading, in this frame or the last one
  bool HasDrawn = false;    // a frame
  bool HasSpecular = false; // a material has reflected lights so far
  bool HasPhysical = false; // a material had physically based rendering so far
  bool IsWhole = false;     // the last frame was drawn in one band, which the store still holds
  std::int64_t NumberOfFragments = 0; // of the last frame
};

#endif
