// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITAutoPass
 * @brief   exact transparency by the cheapest method for a scene, without the work it does not need
 *
 * The default choice. docs/vtkOITAutoPass.md has a picture and says what is skipped, and when.
 * One frame:
 *
 * 1. Props that cannot be seen are left out: empty ones, those outside of the view, and those of
 *    opacity 0 (SkipInvisibleProps).
 * 2. When nothing has changed since the last frame, its layer of all translucent props is
 *    composited again (ReuseFrames). Changes are detected in the camera, the viewport, the lights,
 *    the modification times of the props and of all that they are made from, and in the depth of
 *    the opaque geometry, which is compared pixel by pixel. The layer is kept from the second
 *    unchanged frame on, so a moving camera costs nothing more.
 * 3. Props that need no sorting are blended (SkipSorting). These are groups of props, separate on
 *    the screen from all others, in which each prop is proven to be convex, flat or closed, and any
 *    two props that overlap have an order that follows from their bounds, or one lies inside of the
 *    other. They are drawn back to front, of closed props the far faces before the near faces:
 *    into the framebuffer where no pixel has more than one layer, otherwise into a float32 layer.
 *    Where a few of such a group have no order, such as two that cross, these are sorted by an
 *    A-buffer of their own, in turns with the others, if that costs less than sorting all of them.
 *    Where shaders can read the framebuffer, up to 3 layers are drawn into the framebuffer and the
 *    float32 layer at once.
 * 4. All other props are sorted by the A-buffer, in bands when its fragments do not fit into
 *    memory. Where the A-buffer cannot run, dual depth peeling draws them.
 *
 * GetAlgorithmName() names the method that drew the frame, GetAlgorithmReason() says why, and
 * GetSkipSummary() says what was skipped.
 *
 * Geometry passes: 0 when a frame is reused; 1 for blending, 2 or more with closed props, and one for
 * each turn of blending and sorting; 1 for the
 * A-buffer; about N/6 or N/2 for N layers by dual depth peeling. Memory per pixel: 16 bytes where
 * props are blended, 24 where frames are reused, otherwise that of the method. All of it stays
 * within MaximumBufferSize. Needs OpenGL 3.2 with ARB_explicit_attrib_location, and for the
 * A-buffer OpenGL 4.4.
 *
 * Exact: as the method that sorts. Blending adds no error: orders are proven up to the resolution
 * of float32 coordinates. NumberOfFragments and MaximumDepthComplexity are negative (unknown) in
 * frames in which props were blended.
 *
 * @sa vtkOITABufferPass vtkOITDualDepthPeelingPass
 */

#ifndef vtkOITAutoPass_h
#define vtkOITAutoPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPass.h"

#include <memory> // for the private parts

class VTKOIT_EXPORT vtkOITAutoPass : public vtkOITPass
{
public:
  static vtkOITAutoPass* New();
  vtkTypeMacro(vtkOITAutoPass, vtkOITPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// Leave out props that leave no trace. Lossless. Default on.
  ///@{
  vtkSetMacro(SkipInvisibleProps, bool);
  vtkGetMacro(SkipInvisibleProps, bool);
  vtkBooleanMacro(SkipInvisibleProps, bool);
  ///@}

  /// Blend props whose order is proven. Lossless up to the rounding of stored fragments, which is
  /// saved. Default on.
  ///@{
  vtkSetMacro(SkipSorting, bool);
  vtkGetMacro(SkipSorting, bool);
  vtkBooleanMacro(SkipSorting, bool);
  ///@}

  /// Let the A-buffer leave out fragments behind those of opacity 1, where that pays: see
  /// vtkOITABufferPass::SetSkipHiddenFragments(). Lossless. Default on.
  ///@{
  vtkSetMacro(SkipHiddenFragments, bool);
  vtkGetMacro(SkipHiddenFragments, bool);
  vtkBooleanMacro(SkipHiddenFragments, bool);
  ///@}

  /// Composite the last frame's layer again when nothing has changed. Lossless up to 2^-23.
  /// Default on.
  ///@{
  vtkSetMacro(ReuseFrames, bool);
  vtkGetMacro(ReuseFrames, bool);
  vtkBooleanMacro(ReuseFrames, bool);
  ///@}

  /// Let the A-buffer light fragments after it has sorted them, where there are many lights: see
  /// vtkOITDeferredPeelingPass. That is from 5 directional or 2 positional lights on, and until there
  /// are half as many, so that lights that come and go seldom compile shaders. Within one step of 255
  /// of what it is without, and 32 bytes for a fragment instead of 16. Default on.
  ///@{
  vtkSetMacro(DeferShading, bool);
  vtkGetMacro(DeferShading, bool);
  vtkBooleanMacro(DeferShading, bool);
  ///@}

  /// What the last frame did without, and why; one line, empty for nothing.
  std::string GetSkipSummary() const;

  /// Why the last frame was drawn by the method of GetAlgorithmName(); one line.
  std::string GetAlgorithmReason() const;

  /// Deprecated: GetAlgorithmReason(). Warns once, goes after the next release.
  std::string GetChoice() const;

  /// The limit in bytes that holds: MaximumBufferSize, or when that is 0 (default) a quarter of the
  /// memory of the context of the last frame, at most 1 GiB.
  vtkTypeInt64 GetBufferLimit() const;

protected:
  vtkOITAutoPass();
  ~vtkOITAutoPass() override;

  std::string GetOwnAlgorithmName() const override { return "automatic choice"; }
  vtkOITSettings MakeSettings(const vtkOITCapabilities& capabilities) const override;
  vtkOITPlan MakePlan(const vtkOITFrame& frame, const vtkOITSettings& settings) override;

  bool SkipInvisibleProps = true;
  bool SkipSorting = true;
  bool SkipHiddenFragments = true;
  bool ReuseFrames = true;
  bool DeferShading = true;

private:
  vtkOITAutoPass(const vtkOITAutoPass&) = delete;
  void operator=(const vtkOITAutoPass&) = delete;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
