// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOITScreenRectangle.h"

#include "vtkOITCompatibility.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace
{
/// Mappers that draw nothing outside of their bounds but the width of points and lines.
bool StaysInBounds(vtkMapper* mapper)
{
  static const std::array<std::string, 5> names = { "vtkOpenGLPolyDataMapper", "vtkDataSetMapper",
    "vtkCompositePolyDataMapper", "vtkCompositePolyDataMapper2", "vtkPolyDataMapper" };
  return mapper && std::find(names.begin(), names.end(), mapper->GetClassName()) != names.end();
}

bool MovesVertices(vtkShaderProperty* shader)
{
  return shader &&
    (shader->HasVertexShaderCode() || shader->HasGeometryShaderCode() ||
      shader->GetNumberOfShaderReplacements() > 0);
}

/// Pixels that points and lines add around the bounds; negative when there is no limit.
double FindMargin(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || !StaysInBounds(actor->GetMapper()) || MovesVertices(actor->GetShaderProperty()) ||
    !vtkOITIsInWorldCoordinates(actor))
  {
    return -1.0;
  }
  vtkProperty* property = actor->GetProperty();
  return std::max<double>(property->GetLineWidth(), property->GetPointSize());
}

glm::dmat4 FindProjection(vtkRenderer* renderer)
{
  vtkMatrix4x4* matrix = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1.0, 1.0);
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

struct Extent
{
  glm::dvec2 Lower{ std::numeric_limits<double>::max() };
  glm::dvec2 Upper{ std::numeric_limits<double>::lowest() };

  void Add(const glm::dvec2& pixel, double margin)
  {
    this->Lower = glm::dvec2(
      std::min(this->Lower.x, pixel.x - margin), std::min(this->Lower.y, pixel.y - margin));
    this->Upper = glm::dvec2(
      std::max(this->Upper.x, pixel.x + margin), std::max(this->Upper.y, pixel.y + margin));
  }
};

/// False when a corner lies at or behind the camera's plane, where the projection has no limit.
bool AddBounds(const glm::dmat4& projection, const double bounds[6],
  const vtkOITRectangle& viewport, double margin, Extent& extent)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 clip = projection *
      glm::dvec4(bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)], bounds[4 + (corner >> 2)], 1);
    if (!(clip.w > 1e-9 * std::abs(clip.z)) || !std::isfinite(clip.x) || !std::isfinite(clip.y))
    {
      return false;
    }
    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
    extent.Add(glm::dvec2(viewport.X + 0.5 * (ndc.x + 1.0) * viewport.Width,
                 viewport.Y + 0.5 * (ndc.y + 1.0) * viewport.Height),
      margin);
  }
  return true;
}
}

//------------------------------------------------------------------------------
vtkOITRectangle vtkOITFindScreenRectangle(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props, const vtkOITRectangle& viewport)
{
  const glm::dmat4 projection = FindProjection(renderer);
  Extent extent;
  for (vtkProp* prop : props)
  {
    const double propMargin = FindMargin(prop);
    const double* bounds = propMargin < 0.0 ? nullptr : prop->GetBounds();
    if (!bounds)
    {
      return viewport;
    }
    if (!vtkBoundingBox::IsValid(bounds))
    {
      continue; // empty data
    }
    // Two pixels: one for rounding outwards, one for rasterisation rules and float vertices.
    if (!AddBounds(projection, bounds, viewport, propMargin + 2.0, extent))
    {
      return viewport;
    }
  }
  if (extent.Lower.x > extent.Upper.x)
  {
    return {};
  }

  const auto clampTo = [](double value, int lower, int size)
  { return static_cast<int>(std::clamp<double>(value, lower, lower + size)); };
  const int x0 = clampTo(std::floor(extent.Lower.x), viewport.X, viewport.Width);
  const int y0 = clampTo(std::floor(extent.Lower.y), viewport.Y, viewport.Height);
  const int x1 = clampTo(std::ceil(extent.Upper.x), viewport.X, viewport.Width);
  const int y1 = clampTo(std::ceil(extent.Upper.y), viewport.Y, viewport.Height);
  return { x0, y0, x1 - x0, y1 - y0 };
}
