// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITABufferVolumes_h
#define vtkOITABufferVolumes_h

#include "Private/ABuffer/vtkOITABufferShaders.h"
#include "Private/Frame/vtkOITFailure.h"
#include "Private/Volume/vtkOITVolumeGather.h"

class vtkOITFragmentStore;
struct vtkOITFrame;
struct vtkOITStatistics;

/// Draws the volumes of a frame along the sorted lists of a store.
class vtkOITABufferVolumes
{
public:
  /// The texts of the lists from now on.
  void SetShaders(const vtkOITABufferShaders& shaders);

  /// Draws them inside of the store's rectangle over the frame's target; their rays end at a
  /// transmittance of at most the threshold. Volumes that cannot be drawn so are left out.
  void Draw(const vtkOITFrame& frame, const vtkOITFragmentStore& store, float threshold);

  /// Those that were left out, over all, which is not exact.
  void DrawFailed(const vtkOITFrame& frame, const vtkOITFragmentStore& store,
    vtkOITStatistics& statistics) const;

private:
  vtkOITVolumeGather Gather;
  vtkOITFailure Failure; // of the last Draw()
};

#endif
