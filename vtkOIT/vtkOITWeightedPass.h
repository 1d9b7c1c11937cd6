// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOITWeightedPass
 * @brief   previews in one geometry pass: sums over the fragments of a pixel instead of an order
 *
 * Fast and not exact: the order of the layers is not known. docs/vtkOITWeightedPass.md has
 * pictures of the three modes beside the exact one.
 *
 * 1. A geometry pass adds up, in float32, weight times colour, weight, opacity and count of the
 *    fragments of each pixel.
 * 2. A screen pass makes one layer of the sums and composites it over what the framebuffer holds.
 *
 * The modes, for n fragments with colours c, opacities α and weights w over a background C_bg:
 *
 * - AVERAGE: `C (1 - (1-A)^n) + C_bg (1-A)^n`, that is n equal layers of the mean colour
 *   `C = Σ αc / Σ α` and the mean opacity `A = Σ α / n` (Bavoil and Myers, Order independent
 *   transparency with dual depth peeling, NVIDIA 2008, Weighted average).
 * - SUM: `Σ αc + C_bg (1 - Σ α)` (there, Weighted sum; after Meshkin, Sort-independent alpha
 *   blending, GDC 2007). Too dark or too bright for opacities above 0.2; the background counts
 *   negative where Σ α is above 1.
 * - BLENDED: `Σ wαc / Σ wα (1 - Π(1-α)) + C_bg Π(1-α)`, where the weight w falls with depth
 *   (McGuire and Bavoil, Weighted blended order-independent transparency, JCGT 2(2), 2013,
 *   equation (10)). The depth is the eye depth relative to the interval of the translucent props'
 *   bounds, so the weights use their whole range in every scene.
 *
 * Geometry passes: 1. Memory: 36 bytes per pixel and a copy of the depth buffer. Needs OpenGL 3.2
 * with ARB_explicit_attrib_location.
 *
 * Exact: only where no pixel has more than one layer; GetExact() is true only then, and
 * GetErrorBound() is 1 otherwise. AVERAGE and BLENDED have the right colour where all layers of a
 * pixel have one colour. AVERAGE has the right alpha where all layers have one opacity, BLENDED
 * always.
 *
 * @sa vtkOITPass
 */

#ifndef vtkOITWeightedPass_h
#define vtkOITWeightedPass_h

#include "vtkOITModule.h" // for the export macro
#include "vtkOITPass.h"

class VTKOIT_EXPORT vtkOITWeightedPass : public vtkOITPass
{
public:
  static vtkOITWeightedPass* New();
  vtkTypeMacro(vtkOITWeightedPass, vtkOITPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModeType
  {
    AVERAGE = 0, ///< weighted average
    SUM = 1,     ///< weighted sum
    BLENDED = 2  ///< weighted blended, with a weight that falls with depth
  };

  /// AVERAGE (default), SUM or BLENDED.
  ///@{
  virtual void SetMode(int mode);
  vtkGetMacro(Mode, int);
  ///@}

protected:
  vtkOITWeightedPass();
  ~vtkOITWeightedPass() override;

  vtkOITSettings MakeSettings(const vtkOITCapabilities& capabilities) const override;

  int Mode = AVERAGE;

private:
  vtkOITWeightedPass(const vtkOITWeightedPass&) = delete;
  void operator=(const vtkOITWeightedPass&) = delete;
};

#endif
