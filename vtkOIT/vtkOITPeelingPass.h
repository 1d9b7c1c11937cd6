// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITPeelingPass
 * @brief   base class of the passes that draw the props once for every few layers
 *
 * What all peeling methods share:
 *
 * 1. The opaque depth is copied, so that the hardware tests against it while layers are gathered
 *    into buffers of the pass.
 * 2. A geometry pass gathers the layers of one peel. A screen pass (Resolve) blends them in float32
 *    with those of earlier peels, and notes which part of the pixel's depths is left.
 * 3. A screen pass (Mask) writes a depth buffer by which the hardware rejects, before they are
 *    shaded, fragments that are peeled already and all fragments of finished pixels. An occlusion
 *    query counts the pixels that are not finished. Props that had no fragment left in a peel are
 *    not drawn again.
 * 4. Steps 2 and 3 are repeated until no pixel has layers left. Layers that MaximumNumberOfPeels or
 *    OcclusionRatio cut off are blended in their place as one group, weighted by opacity, in one
 *    more geometry pass.
 * 5. The result is composited over what the framebuffer holds.
 *
 * Queries do not stall the GPU: peels before the one that was the last in the previous frame read
 * their results only when these are available, and only that peel waits for its result. Where
 * layers are kept in buffers (vtkOITDualDepthPeelingPass) and the first peel had all of them in the
 * previous frame, it is composited at once, after its statistics were read.
 *
 * Coincident fragments, whose float32 window depths are equal to the bit, form a group with the
 * opacity `1 - Π(1 - α_i)` and the mean of their colours weighted by opacity.
 *
 * Multisampled framebuffers are left to the A-buffer, see vtkOITPass.
 *
 * @sa vtkOITDepthPeelingPass vtkOITDualDepthPeelingPass vtkOITMultiLayerPeelingPass
 * vtkOITBucketPeelingPass
 */

#ifndef vtkOITPeelingPass_h
#define vtkOITPeelingPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPass.h"

#include <memory> // for the engine

class VTKOIT_EXPORT vtkOITPeelingPass : public vtkOITPass
{
public:
  vtkTypeMacro(vtkOITPeelingPass, vtkOITPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// On (default): peeling ends when an occlusion query has found no pixel with layers left. Off:
  /// nothing is asked, and every frame has MaximumNumberOfPeels peels, 4 when that is 0; what they
  /// leave is blended as one group (Bavoil and Myers 2008, Running the sample).
  ///@{
  vtkSetMacro(UseOcclusionQuery, bool);
  vtkGetMacro(UseOcclusionQuery, bool);
  vtkBooleanMacro(UseOcclusionQuery, bool);
  ///@}

  /// Peels of the last frame, of its bands together; those that only prepare and the one that
  /// blends the rest included.
  int GetNumberOfPeels() const;

  /// Fragments of the last frame that were dropped because the method could not tell them apart.
  vtkTypeInt64 GetNumberOfLostFragments() const;

protected:
  explicit vtkOITPeelingPass(std::unique_ptr<vtkOITEngine> engine);
  ~vtkOITPeelingPass() override;

  vtkOITSettings MakeSettings(const vtkOITCapabilities& capabilities) const override;

  bool UseOcclusionQuery = true;

private:
  vtkOITPeelingPass(const vtkOITPeelingPass&) = delete;
  void operator=(const vtkOITPeelingPass&) = delete;
};

#endif
