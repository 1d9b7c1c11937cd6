// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITDualDepthPeelingPass
 * @brief   exact transparency by peeling the nearest and the farthest layer at once
 *
 * Dual depth peeling (Bavoil and Myers, Order independent transparency with dual depth peeling,
 * NVIDIA 2008):
 *
 * 1. A first geometry pass finds the nearest and the farthest depth of each pixel by MAX blending
 * of
 *    (-z, z) in float32.
 * 2. Each further one sums up the fragments at these two depths, and finds the nearest and farthest
 *    depth of those between. A screen pass blends the front layer under those in front,
 *    `C += T α c`, `T -= T α`, and the back layer over those behind, `C += α (c - C)`, in float32.
 * 3. The hardware's depth test rejects what is behind the back layer. Peeling ends when no pixel
 * has layers left between.
 * 4. The two halves are composited, front over back.
 *
 * Differences from the paper and from vtkDualDepthPeelingPass: colours accumulate in float32, not
 * in 8 bits; peeling ends by depths, not by the colour of back layers, so a faint outermost layer
 * ends nothing; depths are compared exactly, so layers one unit in the last place apart are two;
 * colours are added instead of kept as a maximum, so coincident fragments are all counted, and
 * colours may be of any size and sign.
 *
 * Where shaders can read the framebuffer (EXT_shader_framebuffer_fetch), the two nearest and the
 * two farthest layers are peeled at once: a register more, and half the geometry passes.
 *
 * Geometry passes: ⌈N/4⌉ + 1 for N layers where shaders can read the framebuffer, otherwise
 * ⌈N/2⌉ + 1; at most ⌊N/2⌋ + 2 in any case. Memory: 168 bytes per pixel, otherwise 200. Needs
 * GL 3.2 with ARB_explicit_attrib_location.
 *
 * Exact: yes, with TransmittanceThreshold 0 and no limit on the number of peels; otherwise within
 * GetErrorBound(). Limits: a prop whose mapper knows nothing of vtkOpenGLRenderPass draws nothing.
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

  void RenderTranslucent(vtkOITFrame& frame) override;
  const char* GetOwnAlgorithmName() override { return "dual depth peeling"; }

private:
  void ChooseLayersPerSide();

  bool KeepsLayers = false; // of the pixels, because shaders can read the framebuffer
  int LayersPerSide = 3;    // then, of a peel
  int FramesWithFewer = 0;  // in a row

  vtkOITDualDepthPeelingPass(const vtkOITDualDepthPeelingPass&) = delete;
  void operator=(const vtkOITDualDepthPeelingPass&) = delete;
};

#endif
