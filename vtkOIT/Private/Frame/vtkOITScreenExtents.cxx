// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Frame/vtkOITScreenExtents.h"

#include "Private/Frame/vtkOITCompatibility.h"
#include "Private/Frame/vtkOITIsCalled.h"
#include "Private/Frame/vtkOITPropInput.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace
{
/// Mappers that draw nothing outside of their bounds but the width of points and lines.
bool StaysInBounds(vtkMapper* mapper)
{
  static constexpr std::array<const char*, 5> names = { "vtkOpenGLPolyDataMapper",
    "vtkDataSetMapper", "vtkCompositePolyDataMapper", "vtkCompositePolyDataMapper2",
    "vtkPolyDataMapper" };
  return vtkOITIsCalledOneOf(mapper, names);
}

/// Bounds know nothing of a perspective transformation.
bool IsAffine(vtkMatrix4x4* matrix)
{
  return matrix->GetElement(3, 0) == 0.0 && matrix->GetElement(3, 1) == 0.0 &&
    matrix->GetElement(3, 2) == 0.0 && matrix->GetElement(3, 3) == 1.0;
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
  if (auto* volume = vtkVolume::SafeDownCast(prop))
  {
    return vtkOITIsInWorldCoordinates(volume) ? 0.0 : -1.0;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || !StaysInBounds(actor->GetMapper()) || MovesVertices(actor->GetShaderProperty()) ||
    !vtkOITIsInWorldCoordinates(actor) || !IsAffine(actor->GetMatrix()))
  {
    return -1.0;
  }
  vtkProperty* property = actor->GetProperty();
  return std::max<double>(property->GetLineWidth(), property->GetPointSize());
}

struct Extent
{
  glm::dvec3 Lower{ std::numeric_limits<double>::max() };
  glm::dvec3 Upper{ std::numeric_limits<double>::lowest() };

  void Add(const glm::dvec3& point, double margin)
  {
    const glm::dvec3 margins(margin, margin, 0.0);
    this->Lower = glm::min(this->Lower, point - margins);
    this->Upper = glm::max(this->Upper, point + margins);
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
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    extent.Add(glm::dvec3(viewport.X + 0.5 * (ndc.x + 1.0) * viewport.Width,
                 viewport.Y + 0.5 * (ndc.y + 1.0) * viewport.Height, 0.5 * (ndc.z + 1.0)),
      margin);
  }
  return true;
}

vtkOITRectangle ClipTo(const vtkOITRectangle& viewport, const Extent& extent)
{
  const auto clampTo = [](double value, int lower, int size)
  { return static_cast<int>(std::clamp<double>(value, lower, lower + size)); };
  const int x0 = clampTo(std::floor(extent.Lower.x), viewport.X, viewport.Width);
  const int y0 = clampTo(std::floor(extent.Lower.y), viewport.Y, viewport.Height);
  const int x1 = clampTo(std::ceil(extent.Upper.x), viewport.X, viewport.Width);
  const int y1 = clampTo(std::ceil(extent.Upper.y), viewport.Y, viewport.Height);
  return { x0, y0, x1 - x0, y1 - y0 };
}

vtkOITScreenExtent FindExtent(
  vtkProp* prop, const glm::dmat4& projection, const vtkOITRectangle& viewport)
{
  vtkOITScreenExtent result;
  result.Rectangle = viewport;
  const double propMargin = FindMargin(prop);
  double bounds[6];
  if (propMargin < 0.0 || !vtkOITGetBounds(prop, bounds))
  {
    return result;
  }
  if (!vtkBoundingBox::IsValid(bounds))
  {
    result.Rectangle = {}; // empty data
    result.IsBounded = true;
    return result;
  }
  // Two pixels: one for rounding outwards, one for rasterisation rules and float vertices.
  Extent extent;
  if (AddBounds(projection, bounds, viewport, propMargin + 2.0, extent))
  {
    result.Rectangle = ClipTo(viewport, extent);
    result.Nearest = extent.Lower.z;
    result.Farthest = extent.Upper.z;
    result.IsBounded = true;
    if (result.Farthest < 0.0 || result.Nearest > 1.0)
    {
      result.Rectangle = {}; // before the near or behind the far clipping plane
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
glm::dmat4 vtkOITFindProjection(vtkRenderer* renderer)
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

//------------------------------------------------------------------------------
std::vector<vtkOITScreenExtent> vtkOITFindScreenExtents(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props, const vtkOITRectangle& viewport)
{
  const glm::dmat4 projection = vtkOITFindProjection(renderer);
  std::vector<vtkOITScreenExtent> extents;
  extents.reserve(props.size());
  std::transform(props.begin(), props.end(), std::back_inserter(extents),
    [&](vtkProp* prop) { return FindExtent(prop, projection, viewport); });
  return extents;
}

//------------------------------------------------------------------------------
vtkOITRectangle vtkOITFindScreenRectangle(const std::vector<vtkOITScreenExtent>& extents)
{
  vtkOITRectangle rectangle;
  for (const vtkOITScreenExtent& extent : extents)
  {
    rectangle = rectangle.Unite(extent.Rectangle);
  }
  return rectangle;
}
