// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOITDeferredText_h
#define vtkOITDeferredText_h

#include "Private/Engine/vtkOITReplacements.h"

class vtkRenderer;

/**
 * Takes the lighting out of the shaders of VTK's mappers, so that their text does not depend on
 * lights, and leaves what is needed to light their fragments later.
 *
 * The mark of the lighting is taken away before a mapper puts it in. Afterwards the variables that
 * it would have been computed from are kept in oitAmbient, oitDiffuse, oitSpecular, oitPower and
 * oitNormal, OIT_CAPTURES is defined, and the colour becomes white, for the textures that VTK
 * multiplies in behind the lighting. A shader without lighting keeps its colour. Of physically based
 * rendering the emission, the diffuse part of the albedo, the reflectance, the roughness and the normal
 * are kept in those, oitOcclusion and the reflectance at grazing angles in oitGrazing
 * (OIT_CAPTURES_PHYSICAL); what VTK has put in for lights is cut out afterwards.
 *
 * Props whose lighting is more than that keep it, see CanDefer().
 */
class vtkOITDeferredText : public vtkOITReplacements
{
public:
  void Before(std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) const override;
  void After(std::string& fragmentShader) const override;

  /// Whether props with physically based rendering may be lit later, too. Default: no.
  void SetTakesPhysical(bool takes) { this->TakesPhysical = takes; }

  /// Whether a prop may be lit later: not with anisotropy, a clear coat or a tint of edges, shader
  /// replacements, other passes that change its shaders, points and lines of some width, or mappers that
  /// are not known. What is lit by an image is found out later, by its text.
  bool CanDefer(vtkAbstractMapper* mapper, vtkProp* prop) const;

  /// Whether a prop may have specular light.
  static bool IsReflecting(vtkProp* prop);
  /// Whether a prop has physically based rendering.
  static bool IsPhysical(vtkProp* prop);

private:
  bool TakesPhysical = false;
};

#endif
