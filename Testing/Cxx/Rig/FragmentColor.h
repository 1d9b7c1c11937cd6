// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Fragments of any colour: of any size and sign, and not a number. A vtkProperty takes [0, 1] only.
 */

#ifndef FragmentColor_h
#define FragmentColor_h

#include "Rig/Rig.h"

#include "vtkActor.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

namespace vtkOITTest
{
/// Makes every fragment of the actor this colour and opacity, whatever its property says.
inline void SetFragmentColor(vtkActor* actor, const glm::vec4& color)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  shaders->AddFragmentShaderReplacement(
    "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  gl_FragData[0] = testColor;\n", false);
  shaders->GetFragmentCustomUniforms()->SetUniform4f("testColor", &color.r);
  actor->ForceTranslucentOn();
}

/// A quad over the rectangle whose fragments have the layer's colour as it is.
inline vtkActor* AddQuadOfAnyColor(Rig& rig, const Layer& layer, const PixelRectangle& rectangle)
{
  vtkActor* actor = rig.AddQuad({ layer.Depth, glm::vec4(0.5f) }, rectangle);
  SetFragmentColor(actor, layer.Color);
  return actor;
}

/// The same over the whole viewport for each of the layers.
inline void AddStackOfAnyColor(Rig& rig, const std::vector<Layer>& layers)
{
  for (const Layer& layer : layers)
  {
    AddQuadOfAnyColor(rig, layer, rig.GetFullRectangle());
  }
}
}

#endif
