// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITSorters_h
#define vtkOITSorters_h

#include <cstdint>
#include <memory>
#include <string>

class vtkOITCapabilities;
class vtkOITEngine;
class vtkOITGeometry;
class vtkOITSavedState;
struct vtkOITFrame;
struct vtkOITSettings;
struct vtkOITStatistics;

/**
 * The engines that can draw a frame whose order is not known, best first: that of a pass's own
 * method, the A-buffer, dual depth peeling. The next one draws where one cannot run, and what is
 * left of a frame in which one has failed; after the last one VTK blends unsorted, which is not
 * exact. All are kept from frame to frame, and all get the same settings.
 *
 * The A-buffer is the best of all wherever it runs, also when its fragments do not fit into the
 * memory: then it draws the scene once for each of its bands, but each fragment in one of them
 * only. docs/costs.md has what was measured.
 */
class vtkOITSorters
{
public:
  /// `own`: of the pass's method; nullptr for the best one.
  explicit vtkOITSorters(vtkOITEngine* own);
  ~vtkOITSorters();

  /// Empty when one of them runs in a context, otherwise what the best one lacks. Of the own one
  /// only, when there is one.
  std::string FindMissing(const vtkOITCapabilities& capabilities, const vtkOITSettings& settings);

  /// Whether one of them can sort props that add light in this frame, and may take the place of the
  /// own one.
  bool SortsLight(const vtkOITFrame& frame, const vtkOITSettings& settings);

  /// Draws the props inside of the frame's rectangle over its target. The statistics tell by which
  /// method, and why.
  void Draw(const vtkOITFrame& frame, const vtkOITSettings& settings, vtkOITGeometry& geometry,
    vtkOITSavedState& saved, vtkOITStatistics& statistics);

  std::int64_t GetSizeInBytes() const;
  void Release();

private:
  static constexpr int Count = 3;
  vtkOITEngine* Get(int which);
  void ReleaseOthers(const vtkOITEngine* used);
  bool HasOne(bool (vtkOITEngine::*ability)() const, const vtkOITFrame& frame,
    const vtkOITSettings& settings);
  static void DrawUnsorted(
    const vtkOITFrame& frame, vtkOITGeometry& geometry, const vtkOITSavedState& saved);
  static void DrawVolumesOver(
    const vtkOITFrame& frame, const vtkOITSavedState& saved, vtkOITStatistics& statistics);

  vtkOITEngine* Own;
  std::unique_ptr<vtkOITEngine> Others[2]; // made when first needed
};

#endif
