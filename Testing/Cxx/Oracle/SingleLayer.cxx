// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Oracle/SingleLayer.h"

#include "Oracle/ReferenceCompositor.h"

#include "vtkActor.h"
#include "vtkProperty.h"

#include <glm/vector_relational.hpp>

namespace vtkOITTest
{
//------------------------------------------------------------------------------
void CheckSingleLayer(Report& report, Rig& rig, const Setup& setup, const std::string& what,
  vtkActor* actor, float opacity, int minimumVisible, int minimumHidden)
{
  actor->VisibilityOff();
  const Image without = rig.Render();
  actor->VisibilityOn();
  actor->GetProperty()->SetOpacity(1.0);
  actor->ForceOpaqueOn();
  const Image opaque = rig.Render();
  actor->ForceOpaqueOff();
  actor->GetProperty()->SetOpacity(opacity);
  const Image image = rig.Render();

  int visible = 0;
  for (std::size_t i = 0; i < opaque.Pixels.size(); ++i)
  {
    visible += glm::any(glm::notEqual(opaque.Pixels[i], without.Pixels[i])) ? 1 : 0;
  }
  const int hidden = static_cast<int>(opaque.Pixels.size()) - visible;
  report.Check(visible >= minimumVisible && hidden >= minimumHidden,
    what + ": the scene tests little, " + std::to_string(visible) + " pixels show the prop and " +
      std::to_string(hidden) + " do not");
  report.Compare(
    what, image,
    [&](int x, int y)
    {
      const double a = opacity;
      return a * glm::dvec4(opaque.At(x, y)) + (1.0 - a) * glm::dvec4(without.At(x, y));
    },
    ReferenceCompositor::RoundingBoundOfAnyStack(1, setup.FragmentStorage));
}
}
