// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITEngine_h
#define vtkOITEngine_h

#include "Private/Frame/vtkOITFailure.h"

#include <cstdint>
#include <string>

class vtkOITCapabilities;
class vtkOITGeometry;
struct vtkOITFrame;
struct vtkOITSettings;
struct vtkOITStatistics;

/**
 * Draws the translucent props of a frame by one method. An engine knows nothing of render passes,
 * of the factory and of other engines; it keeps from frame to frame what it needs on the context.
 */
class vtkOITEngine
{
public:
  virtual ~vtkOITEngine() = default;

  /// As in the literature.
  virtual std::string GetAlgorithmName(const vtkOITSettings& settings) const = 0;

  /// Empty, or one line that says what the context lacks for this method.
  virtual std::string FindMissing(
    const vtkOITCapabilities& capabilities, const vtkOITSettings& settings) const = 0;

  /// The same for a frame that the context could draw otherwise. Default: nothing is missing.
  virtual std::string FindMissingIn(const vtkOITFrame&) const { return {}; }

  /// Whether it uses image units or storage buffers, so that they are saved.
  virtual bool UsesStorage(const vtkOITCapabilities&, const vtkOITSettings&) const { return false; }

  /// Whether it draws the frame's volumes between the props, too.
  virtual bool MixesVolumes() const { return false; }
  /// Whether props that add light get their place among the others (vtkOITFrame::HasLight).
  virtual bool SortsLight() const { return false; }
  /// Whether it approximates, so that nobody wants another method in its place.
  virtual bool IsPreview() const { return false; }

  /// Draws the props inside of the frame's rectangle over its target, and adds to the statistics.
  /// Changes the state that vtkOITSavedState restores. When it fails, it has drawn nothing where
  /// the failure says so, and everything elsewhere.
  virtual vtkOITFailure Draw(const vtkOITFrame& frame, const vtkOITSettings& settings,
    vtkOITGeometry& geometry, vtkOITStatistics& statistics) = 0;

  /// What it holds on the context.
  virtual std::int64_t GetSizeInBytes() const = 0;
  virtual void Release() = 0;

protected:
  /// A frame that is being drawn: what Draw() was given.
  struct Task
  {
    const vtkOITFrame& Frame;
    const vtkOITSettings& Settings;
    vtkOITGeometry& Geometry;
    vtkOITStatistics& Statistics;
  };
};

#endif
