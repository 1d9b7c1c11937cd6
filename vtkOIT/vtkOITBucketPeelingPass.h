// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITBucketPeelingPass
 * @brief   exact transparency by bucket sort of depths, several layers a peel
 *
 * Bucket depth peeling (Liu, Huang, Liu and Wu, Efficient depth peeling via bucket sort, HPG 2009):
 *
 * 1. ADAPTIVE only: a geometry pass sets a bit for each of 1024 bins of a pixel's depth range that
 *    has a fragment, in 8 integer buffers by the logical operation OR. A screen pass makes each
 *    non-empty bin a bucket, up to 32; with more, neighbours share one.
 * 2. A geometry pass captures depths: the 32 channels of 8 RGBA32F buffers keep the nearest depth
 * of 32 equal buckets (UNIFORM) or of those of step 1 (ADAPTIVE), or the nearest and the farthest
 * of 16 equal buckets (PAIRS), by MAX blending. A screen pass sorts out the empty ones.
 * 3. Two geometry passes sum up the colours of four captured depths each, as groups of coincident
 *    fragments, and find the nearest and the farthest fragment that was not captured.
 * 4. A screen pass blends the captured layers up to the nearest fragment that was not captured,
 *    `C += T α c`, `T -= T α`, in float32. The next peel divides what is left into buckets anew:
 *    smaller ones, between the bounds of each pixel. So collisions cost peels, never layers.
 *
 * Buckets divide eye depth. The first peel has the range of the projected bounds of the props, or,
 * with DepthRange EXACT, that of each pixel, found by one more geometry pass. A range of size 0 is
 * one bucket.
 *
 * With MaximumNumberOfPeels 1 it is the paper's single shot: one peel, with all 32 captured depths
 * in 8 colour passes. What collided is left out and counted, GetExact() is false then. Differences
 * from the paper: colours are summed up in float32, each of a known depth, instead of being kept as
 * the maximum of packed bits; that costs geometry passes, and no colour is mixed of two.
 *
 * Geometry passes: 3 a peel (ADAPTIVE 4), up to 8 layers each; at most N peels for N layers. Single
 * shot: 10 (ADAPTIVE 11). DepthRange EXACT: one more. Memory: 440 bytes per pixel, ADAPTIVE 696; 48
 * more where shaders cannot read the framebuffer. Needs GL 3.2 with ARB_explicit_attrib_location.
 *
 * Exact: yes, with TransmittanceThreshold 0 and no limit on the number of peels; otherwise within
 * GetErrorBound(). Limits: a prop whose mapper knows nothing of vtkOpenGLRenderPass draws nothing.
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
  vtkSetClampMacro(Mode, int, UNIFORM, ADAPTIVE);
  vtkGetMacro(Mode, int);
  ///@}

  enum DepthRangeType
  {
    BOUNDS = 0, ///< of the props' bounds
    EXACT = 1   ///< of each pixel, one more geometry pass
  };

  /// The depths that the first peel divides: BOUNDS (default) or EXACT.
  ///@{
  vtkSetClampMacro(DepthRange, int, BOUNDS, EXACT);
  vtkGetMacro(DepthRange, int);
  ///@}

protected:
  vtkOITBucketPeelingPass();
  ~vtkOITBucketPeelingPass() override;

  const char* GetOwnAlgorithmName() override { return "bucket depth peeling"; }
  void RenderTranslucent(vtkOITFrame& frame) override;

  int Mode = UNIFORM;
  int DepthRange = BOUNDS;

private:
  vtkOITBucketPeelingPass(const vtkOITBucketPeelingPass&) = delete;
  void operator=(const vtkOITBucketPeelingPass&) = delete;
};

#endif
