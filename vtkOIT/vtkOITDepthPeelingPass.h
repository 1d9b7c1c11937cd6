// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITDepthPeelingPass
 * @brief   exact transparency by peeling the nearest layer, again and again
 *
 * The simplest exact method, to compare others with. docs/vtkOITDepthPeelingPass.md has a picture,
 * the stages and the limits.
 *
 * Depth peeling (Mammen, Transparency and antialiasing algorithms implemented with the virtual
 * pixel maps technique, IEEE CG&A 9(4), 1989; Everitt, Interactive order-independent transparency,
 * NVIDIA 2001):
 *
 * 1. A first geometry pass finds the depth of the nearest layer of each pixel.
 * 2. Each further geometry pass sums up the fragments at that depth, and finds the next depth
 *    behind it. A screen pass blends the layer under those in front of it, `C += T α c`,
 *    `T -= T α`, in float32.
 * 3. The hardware's depth test (GL_GEQUAL, against the layer peeled last) rejects the fragments in
 *    front of it. Peeling ends when no pixel has a layer left.
 *
 * Differences from the papers: depths are compared as the float32 values that the shaders see, not
 * with a depth texture of another format, so no layer is lost or peeled twice by rounding; the next
 * depth is found by MAX blending, so all coincident fragments are counted.
 *
 * Geometry passes: N + 1 for N layers. Memory: 88 bytes per pixel, 136 where shaders cannot read
 * the framebuffer. Needs OpenGL 3.2 with ARB_explicit_attrib_location.
 *
 * Exact: yes, with TransmittanceThreshold 0 and no limit on the number of peels; otherwise within
 * GetErrorBound(). Limits: a prop whose mapper does not support vtkOpenGLRenderPass is not drawn.
 *
 * @sa vtkOITPeelingPass
 */

#ifndef vtkOITDepthPeelingPass_h
#define vtkOITDepthPeelingPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPeelingPass.h"

class VTKOIT_EXPORT vtkOITDepthPeelingPass : public vtkOITPeelingPass
{
public:
  static vtkOITDepthPeelingPass* New();
  vtkTypeMacro(vtkOITDepthPeelingPass, vtkOITPeelingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkOITDepthPeelingPass();
  ~vtkOITDepthPeelingPass() override;

private:
  vtkOITDepthPeelingPass(const vtkOITDepthPeelingPass&) = delete;
  void operator=(const vtkOITDepthPeelingPass&) = delete;
};

#endif
