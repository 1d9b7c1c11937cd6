// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITBucketPeelingPass
 * @brief   exact transparency by a bucket sort of depths, or an inexact single shot
 *
 * Divides the depths of a pixel into buckets, so that a geometry pass tells several fragments apart. To
 * the end it takes up to four layers in a geometry pass; as a single shot it draws the scene once or
 * twice, whatever the depth. For contexts without framebuffer fetch and storage buffers, where memory
 * is plentiful. docs/vtkOITBucketPeelingPass.md has a picture, the stages and the limits.
 *
 * Bucket depth peeling (Liu, Huang, Liu and Wu, Efficient depth peeling via bucket sort, HPG 2009).
 *
 * To the end. Two geometry passes or more:
 *
 * 1. The first finds the nearest and the farthest depth of each pixel, and counts its fragments.
 * 2. Each further one sums up the colours at four known depths, the nearest three and the farthest,
 *    as groups of coincident fragments, and finds by MAX blending the nearest and the farthest
 *    depth of each of four buckets between them.
 * 3. A screen pass blends what was summed up: from the front as far as no other fragment lies before
 *    it, from the back as far as none lies behind, `C += T α c`, `T -= T α`, in float32. It chooses
 *    the next four depths among those that are known, and divides the depths behind them so that
 *    each of the first buckets gets one fragment, if they are spread evenly. ADAPTIVE: gaps between
 *    known depths are left out.
 *
 * Single shot, with MaximumNumberOfPeels 1, after one more pass with DepthRange EXACT:
 *
 * 1. UNIFORM: a geometry pass keeps the nearest fragment of each of 24 equal buckets; PAIRS: the
 *    nearest and the farthest of each of 12. Colour and opacity are packed, below the place in the
 *    bucket, into a positive normal float, so that MAX blending keeps those of one fragment. In the
 *    eight alpha channels sums over all fragments tell which buckets those were in that were not
 *    kept, and their colour. A screen pass blends the buckets in order.
 * 2. ADAPTIVE: a geometry pass finds the nearest and the farthest depth of each of 12 buckets and
 *    counts the fragments in each; a screen pass gives each known depth a slot, and the other
 *    fragments of a bucket slots between; a second geometry pass writes colours into the slots, as
 *    floats with up to 8 slots in the pixel, of 15 bits with up to 16, otherwise of 8; a screen pass
 *    blends them.
 *
 * A single shot is exact where all slots of an ADAPTIVE one hold one fragment each in more than 8
 * bits, which the counts prove. Otherwise GetExact() is false, and GetErrorBound() is 1: no bound.
 * GetNumberOfLostFragments() counts those that no channel has kept. Coincident fragments share one.
 * Where mismatched: an ADAPTIVE slot of two fragments has the larger of each word of theirs.
 * Colours below 0 are 0 in a single shot.
 *
 * Buckets divide eye depth, of the projected bounds of the props, or, with DepthRange EXACT, of each
 * pixel. A range of size 0 is one bucket.
 *
 * Geometry passes for N layers: at most N/2 + 1, N/4 + 2 where layers are spread evenly. Single
 * shot: 1 (ADAPTIVE 2); DepthRange EXACT: one more. Memory: 232 bytes per pixel, 96 more where
 * shaders cannot read the framebuffer; single shot 184 (ADAPTIVE 376), 48 more there. Needs OpenGL
 * 3.2 with ARB_explicit_attrib_location and ARB_shader_bit_encoding.
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
    UNIFORM = 0, ///< single shot: 24 equal buckets
    PAIRS = 1,   ///< single shot: 12 equal buckets, two fragments each
    ADAPTIVE = 2 ///< single shot: up to 32 slots where fragments are
  };

  /// UNIFORM (default), PAIRS or ADAPTIVE. To the end UNIFORM and PAIRS are the same.
  ///@{
  virtual void SetMode(int mode);
  vtkGetMacro(Mode, int);
  ///@}

  enum DepthRangeType
  {
    BOUNDS = 0, ///< of the props' bounds
    EXACT = 1   ///< of each pixel, one more geometry pass
  };

  /// The depths that a single shot divides: BOUNDS (default) or EXACT. To the end they are exact.
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
