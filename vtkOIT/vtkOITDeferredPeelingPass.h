// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITDeferredPeelingPass
 * @brief   exact transparency whose layers are lit after they were sorted: for many lights
 *
 * Shaders of VTK's mappers compute all lights for each fragment, and are made anew for each number
 * of lights. Here they keep what a fragment is made of, its material, and the fragments of a pixel
 * are lit on the screen, front to back, as far as they are seen.
 * docs/vtkOITDeferredPeelingPass.md has a picture, the stages and the limits.
 *
 * After deferred depth peeling: each peel has a layer as a G-buffer, which is lit on the screen and
 * blended under those in front (PEELING). With A_BUFFER, the default, all layers are had at once. One
 * frame of that:
 *
 * 1. Gather: as vtkOITABufferPass does, in one geometry pass, but a fragment has its ambient,
 *    diffuse and specular colour, specular power and normal instead of a shaded colour.
 * 2. Lists are sorted by depth, up to 64 fragments by networks in registers, as vtkOITABufferPass does;
 *    others, with coincident fragments, or in the first frames, in memory.
 * 3. A pixel goes through its list front to back, lights a fragment and composites it, `C += T α c`,
 *    `T -= T α` in float32, until the transmittance is at most TransmittanceThreshold. The lights
 *    are in a buffer: adding, moving or removing one compiles no shader.
 *
 * With PEELING a geometry pass sums up the materials of the nearest layer that is left, and finds the
 * depth of the next one; peeling ends when an occlusion query has found no pixel with layers left.
 * Coincident fragments are lit as one material, the mean weighted by opacity: not exact, and noted,
 * where their normals or specular powers differ. With CoincidentLayers LAST_ON_TOP it is depth peeling,
 * and mappers light.
 *
 * Light is VTK's: headlights, directional and positional lights with attenuation and cone, ambient,
 * diffuse and specular, normals turned to the viewer; within one step of 255 of vtkOITABufferPass.
 * A_BUFFER: so is physically based rendering, with its textures of colour, normal, occlusion, roughness
 * and metal, and emission. What cannot be lit later is shaded in the geometry pass, as VTK does it, prop
 * by prop: light by images, anisotropy, clear coats and tinted edges of physically based rendering (all of
 * that with PEELING), props with shader replacements, or whose shaders other render passes change, points
 * and lines of more than 2 pixels, spheres and tubes, and mappers that are not known. So is everything in
 * frames with volumes between the layers, with emissive Gaussians, in multisampled framebuffers, and with
 * FragmentPrecision FLOAT.
 *
 * A_BUFFER: geometry passes and needs as vtkOITABufferPass; memory: 4 bytes per pixel, 32 bytes per
 * fragment. PEELING: N + 1 geometry passes for N layers; needs as vtkOITDepthPeelingPass; memory: 152
 * bytes per pixel, 200 where shaders cannot read the framebuffer. 64 bytes per light. Exact: yes, with TransmittanceThreshold 0; otherwise within GetErrorBound().
 * Colours are kept as half floats, specular ones to 2^-10 of their largest channel, normals to
 * 2^-15.
 *
 * @sa vtkOITPass vtkOITABufferPass
 */

#ifndef vtkOITDeferredPeelingPass_h
#define vtkOITDeferredPeelingPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPeelingPass.h"

class vtkOITDeferredEngine;

class VTKOIT_EXPORT vtkOITDeferredPeelingPass : public vtkOITPeelingPass
{
public:
  static vtkOITDeferredPeelingPass* New();
  vtkTypeMacro(vtkOITDeferredPeelingPass, vtkOITPeelingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModeType
  {
    PEELING = 0, ///< one layer after another, each lit as it is peeled
    A_BUFFER = 1 ///< all layers at once
  };

  /// A_BUFFER (default) or PEELING.
  ///@{
  virtual void SetMode(int mode);
  vtkGetMacro(Mode, int);
  ///@}

protected:
  vtkOITDeferredPeelingPass();
  ~vtkOITDeferredPeelingPass() override;

  vtkOITSettings MakeSettings(const vtkOITCapabilities& capabilities) const override;

  int Mode = A_BUFFER;

private:
  vtkOITDeferredPeelingPass(const vtkOITDeferredPeelingPass&) = delete;
  void operator=(const vtkOITDeferredPeelingPass&) = delete;

  vtkOITDeferredEngine* Engine;
};

#endif
