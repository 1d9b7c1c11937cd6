// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITDualDepthPeelingPass
 * @brief   exact transparency by peeling from the front and from the back at once
 *
 * Peels up to three layers from either side in a geometry pass; its memory depends on the number of
 * pixels only. It also draws where the A-buffer cannot. docs/vtkOITDualDepthPeelingPass.md has a
 * picture, the stages and the limits.
 *
 * Dual depth peeling (Bavoil and Myers, Order independent transparency with dual depth peeling,
 * NVIDIA 2008):
 *
 * 1. A geometry pass finds the nearest and the farthest layer of each pixel among those that are
 *    left. A screen pass blends the front layer under those in front of it, `C += T α c`,
 *    `T -= T α`, and the back layer over those behind it, `C += α (c - C)`, in float32.
 * 2. The hardware's depth test rejects fragments outside of the layers peeled so far from one side
 *    before they are shaded. Peeling ends when no pixel has layers left between the two sides.
 * 3. The two halves are composited, front over back.
 *
 * Where shaders can read the framebuffer (EXT_shader_framebuffer_fetch), a geometry pass inserts
 * fragments into buffers for one to three layers from each side, as many as the depth complexity of
 * the last frame calls for. When the first pass has all layers, it is composited at once, and
 * nothing is kept from peel to peel. Elsewhere, as in the paper, a geometry pass finds the depths
 * of the two layers by MAX blending of (-z, z) in float32, and the next one sums up their colours:
 * one geometry pass more.
 *
 * Differences from the paper and from vtkDualDepthPeelingPass: colours accumulate in float32, not
 * in 8 bits; peeling ends when no depths are left, not when the colour of the back layer vanishes,
 * so a nearly transparent outermost layer does not end it; depths are compared exactly, so layers
 * one unit in the last place apart are two layers; all coincident fragments are counted, as a group
 * with the mean of their colours weighted by opacity, instead of the one with the largest colour.
 *
 * Geometry passes: ⌈N/6⌉ for N layers where shaders can read the framebuffer; ⌈N/2⌉ with float
 * colours, and in a frame with more layers than the last; elsewhere ⌈N/2⌉ + 1. Memory: 104, 136 or
 * 168 bytes per pixel for one to three layers from each side, 136 with float colours; elsewhere
 * 200. Needs OpenGL 3.2 with ARB_explicit_attrib_location.
 *
 * NumberOfFragments counts the fragments that pass the depth test; where layers are kept in
 * buffers, also those that TransmittanceThreshold skips.
 *
 * Exact: yes, with TransmittanceThreshold 0 and no limit on the number of peels; otherwise within
 * GetErrorBound(). Layers that are kept in buffers have half-float colours in [0, 65504] by
 * default: an error of at most 2^-11 of each, once more with each coincident fragment.
 * FragmentPrecision FLOAT keeps colours of any size and sign as they are. Limits: a prop whose
 * mapper does not support vtkOpenGLRenderPass is not drawn.
 *
 * @sa vtkOITPeelingPass
 */

#ifndef vtkOITDualDepthPeelingPass_h
#define vtkOITDualDepthPeelingPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPeelingPass.h"

class VTKOIT_EXPORT vtkOITDualDepthPeelingPass : public vtkOITPeelingPass
{
public:
  static vtkOITDualDepthPeelingPass* New();
  vtkTypeMacro(vtkOITDualDepthPeelingPass, vtkOITPeelingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkOITDualDepthPeelingPass();
  ~vtkOITDualDepthPeelingPass() override;

private:
  vtkOITDualDepthPeelingPass(const vtkOITDualDepthPeelingPass&) = delete;
  void operator=(const vtkOITDualDepthPeelingPass&) = delete;
};

#endif
