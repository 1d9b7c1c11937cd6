// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITSettings_h
#define vtkOITSettings_h

#include "vtkType.h"

#include <cstdint>

/// The properties of a pass as one value, for a frame. Their meaning is that of the passes'
/// properties of these names.
struct vtkOITSettings
{
  double TransmittanceThreshold = 0.0;
  bool FloatColor = false;      // FragmentPrecision
  bool LastOnTop = false;       // CoincidentLayers
  std::int64_t BufferLimit = 0; // MaximumBufferSize, bytes; 0: none
  int MaximumNumberOfPeels = 0;
  double OcclusionRatio = 0.0;
  bool UseOcclusionQuery = true;
  bool SkipHiddenFragments = true;
  /// Whether the A-buffer lights fragments after it has sorted them.
  enum class Deferral
  {
    Never,
    WhereItPays,
    Always
  };
  Deferral DeferShading = Deferral::Never;
  bool SkipInvisibleProps = false;
  bool SkipSorting = false;
  bool ReuseFrames = false;

  /// Of single methods.
  ///@{
  int NumberOfLayersPerPass = 8; // multi-layer peeling
  int Synchronization = 0;       // vtkOITMultiLayerPeelingPass::SynchronizationType
  int BucketMode = 0;            // vtkOITBucketPeelingPass::ModeType
  bool HasExactDepthRange = false;
  int WeightedMode = 0; // vtkOITWeightedPass::ModeType
  ///@}

  vtkMTimeType Time = 0; // when one of them was changed last
};

#endif
