// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITBucketPeelingPass
 * @brief   exact transparency by a bucket sort of depths, several layers per peel
 *
 * Divides the depth range of a pixel into buckets and peels up to 8 layers in three geometry
 * passes. For contexts without framebuffer fetch and storage buffers, where memory is plentiful.
 * docs/vtkOITBucketPeelingPass.md has a picture, the stages and the limits.
 *
 * Bucket depth peeling (Liu, Huang, Liu and Wu, Efficient depth peeling via bucket sort, HPG 2009).
 * One peel:
 *
 * 1. ADAPTIVE only: a geometry pass divides a pixel's depth range into 1024 bins and sets a bit for
 *    each bin that has a fragment, in 8 integer buffers by the logical operation OR. A screen pass
 *    makes each non-empty bin a bucket, up to 32; with more, neighbours share one.
 * 2. A geometry pass captures depths by MAX blending into the 32 channels of 8 RGBA32F buffers: the
 *    nearest depth of each of 32 equal buckets (UNIFORM), of each bucket of step 1 (ADAPTIVE), or
 *    the nearest and the farthest depth of each of 16 equal buckets (PAIRS). A screen pass leaves
 *    out the empty buckets.
 * 3. Two geometry passes sum up the colours of four captured depths each, as groups of coincident
 *    fragments, and find the nearest and the farthest fragment that was not captured.
 * 4. A screen pass blends the captured layers up to the nearest fragment that was not captured,
 *    `C += T α c`, `T -= T α`, in float32. The next peel divides the depths that are left into
 *    smaller buckets. So two layers in one bucket cost another peel, but no layer is lost.
 *
 * Buckets divide eye depth. The first peel starts from the range of the projected bounds of the
 * props, or, with DepthRange EXACT, from the range of each pixel, found by one more geometry pass.
 * A range of size 0 is one bucket.
 *
 * With MaximumNumberOfPeels 1 the method is the paper's single shot: one peel, with all 32 captured
 * depths in 8 colour passes. Layers that shared a bucket are then left out and counted by
 * GetNumberOfLostFragments(), and GetExact() is false. Difference from the paper: colours are
 * summed in float32, each at a known depth, instead of being kept as the maximum of packed bits.
 * That costs geometry passes, but never mixes two colours.
 *
 * Geometry passes: 3 per peel (ADAPTIVE 4) of up to 8 layers; at most N peels for N layers. Single
 * shot: 10 (ADAPTIVE 11). DepthRange EXACT: one more. Memory: 440 bytes per pixel, ADAPTIVE 696; 48
 * more where shaders cannot read the framebuffer. Needs OpenGL 3.2 with
 * ARB_explicit_attrib_location.
 *
 * Exact: yes, with TransmittanceThreshold 0 and no limit on the number of peels; otherwise within
 * GetErrorBound(). Limits: a prop whose mapper does not support vtkOpenGLRenderPass is not drawn.
 *
 * @sa vtkOITPeelingPass
 */

#ifndef vtkOITBucketPeelingPass_h
#define vtkOITBucketPeelingPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPeelingPass.h"

class VTKOIT_EXPORT vtkOITBucketPeelingPass : public vtkOITPeelingPass
{
public:
  static vtkOITBucketPeelingPass* New();
  vtkTypeMacro(vtkOITBucketPeelingPass, vtkOITPeelingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModeType
  {
    UNIFORM = 0, ///< 32 equal buckets
    PAIRS = 1,   ///< 16 equal buckets, two depths each
    ADAPTIVE = 2 ///< up to 32 buckets where fragments are
  };

  /// UNIFORM (default), PAIRS or ADAPTIVE.
  ///@{
  virtual void SetMode(int mode);
  vtkGetMacro(Mode, int);
  ///@}

  enum DepthRangeType
  {
    BOUNDS = 0, ///< of the props' bounds
    EXACT = 1   ///< of each pixel, one more geometry pass
  };

  /// The depths that the first peel divides: BOUNDS (default) or EXACT.
  ///@{
  virtual void SetDepthRange(int range);
  vtkGetMacro(DepthRange, int);
  ///@}

protected:
  vtkOITBucketPeelingPass();
  ~vtkOITBucketPeelingPass() override;

  vtkOITSettings MakeSettings(const vtkOITCapabilities& capabilities) const override;

  int Mode = UNIFORM;
  int DepthRange = BOUNDS;

private:
  vtkOITBucketPeelingPass(const vtkOITBucketPeelingPass&) = delete;
  void operator=(const vtkOITBucketPeelingPass&) = delete;
};

#endif
