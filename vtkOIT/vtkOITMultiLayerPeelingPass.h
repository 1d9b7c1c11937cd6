// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITMultiLayerPeelingPass
 * @brief   exact transparency by peeling 4, 8 or 16 layers at once, sorted in the fragment shader
 *
 * Each geometry pass peels the K nearest layers that are left. Its memory depends on the number of
 * pixels only. docs/vtkOITMultiLayerPeelingPass.md has a picture, the stages and the limits.
 *
 * Multi-layer depth peeling (Liu, Wei and Xu, Multi-layer depth peeling via fragment sort,
 * Microsoft Research MSR-TR-2006-81, 2006):
 *
 * 1. Each pixel has slots for K layers, in up to 8 buffers of 16 bytes (equation (1) of the paper).
 *    With K = 4 and 8 a slot takes 16 bytes: 12 for depth and a colour in half floats, 4 for what
 *    tells coincident fragments apart. With K = 16 it takes 8 bytes: 4 for depth, 4 for a colour of
 *    8 bits per channel.
 * 2. A geometry pass inserts each fragment behind the layer peeled last into the slots, which stay
 *    sorted by depth (table 2 of the paper). A fragment that does not fit in marks its pixel.
 * 3. A screen pass blends the layers front to back, `C += T α c`, `T -= T α`, in float32. Pixels
 *    that are not marked are finished.
 *
 * Fragments are ordered by depth and, where it is equal, by draw and primitive. So coincident
 * fragments are neither lost nor peeled twice, also where their group continues in the next peel.
 *
 * Differences from the paper: a fragment that is in a slot already is recognised by depth, draw and
 * primitive, not by a product of differences, which underflows for close layers; colours are kept
 * in integer buffers, never as the bits of a float that may not be a number.
 *
 * Geometry passes: ⌈N/K⌉ for N layers with FRAMEBUFFER_FETCH or INTERLOCK. TEXTURE_BARRIER repeats
 * each until it changes nothing: 2 ⌈N/K⌉ at best, K + 2 times ⌈N/K⌉ at most. Memory: 216 bytes per
 * pixel with K = 8 and 16, 152 with K = 4; 80 more where shaders cannot read the framebuffer. Needs
 * EXT_shader_framebuffer_fetch, ARB_fragment_shader_interlock or ARB_texture_barrier, with
 * ARB_shader_bit_encoding (OpenGL 3.3).
 *
 * Exact: with K = 4 and 8 yes, with TransmittanceThreshold 0 and no limit on the number of peels;
 * colours and opacities are half floats, an error of at most 2^-11 of each, whatever
 * FragmentPrecision says. With K = 16 colours have 8 bits: GetErrorBound() says what that can
 * change, and coincident fragments beyond the 16th of a peel are lost and counted.
 *
 * @sa vtkOITPeelingPass
 */

#ifndef vtkOITMultiLayerPeelingPass_h
#define vtkOITMultiLayerPeelingPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPeelingPass.h"

class VTKOIT_EXPORT vtkOITMultiLayerPeelingPass : public vtkOITPeelingPass
{
public:
  static vtkOITMultiLayerPeelingPass* New();
  vtkTypeMacro(vtkOITMultiLayerPeelingPass, vtkOITPeelingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Layers peeled in a geometry pass: 4, 8 (default) or 16; others are refused.
  ///@{
  void SetNumberOfLayersPerPass(int layers);
  vtkGetMacro(NumberOfLayersPerPass, int);
  ///@}

  /// How fragments of one pixel are kept from overwriting each other's layers.
  enum SynchronizationType
  {
    AUTOMATIC = 0,         ///< the first of the others that the context has
    FRAMEBUFFER_FETCH = 1, ///< EXT_shader_framebuffer_fetch
    INTERLOCK = 2,         ///< ARB_fragment_shader_interlock
    TEXTURE_BARRIER = 3    ///< not at all: repeated until nothing changes; not with 16 layers
  };

  /// Only HALF: FLOAT is refused, because layers keep half floats.
  void SetFragmentPrecision(int precision) override;

  /// AUTOMATIC (default), FRAMEBUFFER_FETCH, INTERLOCK or TEXTURE_BARRIER. What the context lacks
  /// is reported, see vtkOITPass::GetMissingCapability().
  ///@{
  virtual void SetSynchronization(int synchronization);
  vtkGetMacro(Synchronization, int);
  ///@}

protected:
  vtkOITMultiLayerPeelingPass();
  ~vtkOITMultiLayerPeelingPass() override;

  vtkOITSettings MakeSettings(const vtkOITCapabilities& capabilities) const override;

  int NumberOfLayersPerPass = 8;
  int Synchronization = AUTOMATIC;

private:
  vtkOITMultiLayerPeelingPass(const vtkOITMultiLayerPeelingPass&) = delete;
  void operator=(const vtkOITMultiLayerPeelingPass&) = delete;
};

#endif
