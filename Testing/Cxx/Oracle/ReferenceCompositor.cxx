// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Oracle/ReferenceCompositor.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vtkOITTest
{
namespace
{
void SortByDepth(std::vector<Layer>& layers)
{
  std::stable_sort(
    layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.Depth < b.Depth; });
}

/// Index after the last layer of the group that starts at first.
std::size_t EndOfGroup(const std::vector<Layer>& layers, std::size_t first)
{
  std::size_t end = first + 1;
  while (end < layers.size() && layers[end].Depth == layers[first].Depth)
  {
    ++end;
  }
  return end;
}

/// Largest rounding error of a value in the storage format; the property is a float32 as it is.
double RoundingError(double value, Storage storage)
{
  // A half has 11 significant bits, and steps of 2^-24 below 2^-14.
  return storage == Storage::Half
    ? std::max(std::abs(value) * std::ldexp(1.0, -11), std::ldexp(1.0, -25))
    : 0.0;
}
}

//------------------------------------------------------------------------------
glm::dvec4 ReferenceCompositor::Composite(std::vector<Layer> layers, const glm::dvec4& destination)
{
  SortByDepth(layers);
  glm::dvec3 color(0.0);
  double transmittance = 1.0;
  for (std::size_t first = 0, end = 0; first < layers.size(); first = end)
  {
    end = EndOfGroup(layers, first);
    double groupTransmittance = 1.0;
    double weight = 0.0;
    glm::dvec3 weighted(0.0);
    for (std::size_t i = first; i < end; ++i)
    {
      const glm::dvec4 c(layers[i].Color);
      groupTransmittance *= 1.0 - c.a;
      weight += c.a;
      weighted += c.a * glm::dvec3(c);
    }
    if (weight > 0.0)
    {
      color += transmittance * (1.0 - groupTransmittance) / weight * weighted;
    }
    transmittance *= groupTransmittance;
  }
  return glm::dvec4(color, 1.0 - transmittance) + transmittance * destination;
}

//------------------------------------------------------------------------------
Tolerance ReferenceCompositor::RoundingBound(
  std::vector<Layer> layers, const glm::dvec4& destination, Storage storage)
{
  SortByDepth(layers);
  double low = std::min({ destination.r, destination.g, destination.b });
  double high = std::max({ destination.r, destination.g, destination.b });
  for (const Layer& layer : layers)
  {
    low = std::min({ low, double(layer.Color.r), double(layer.Color.g), double(layer.Color.b) });
    high = std::max({ high, double(layer.Color.r), double(layer.Color.g), double(layer.Color.b) });
  }
  const double range = high - low;
  const double largest = std::max(std::abs(low), std::abs(high));

  // Transmittance of everything behind a group: alpha's derivative needs it.
  std::vector<double> behind(layers.size() + 1, 1.0);
  for (std::size_t i = layers.size(); i-- > 0;)
  {
    behind[i] = behind[i + 1] * (1.0 - layers[i].Color.a);
  }

  Tolerance bound;
  double inFront = 1.0;
  for (std::size_t first = 0, end = 0; first < layers.size(); first = end)
  {
    end = EndOfGroup(layers, first);
    double groupTransmittance = 1.0;
    for (std::size_t i = first; i < end; ++i)
    {
      const double opacity = layers[i].Color.a;
      double others = 1.0;
      for (std::size_t j = first; j < end; ++j)
      {
        others *= j == i ? 1.0 : 1.0 - layers[j].Color.a;
      }
      groupTransmittance *= 1.0 - opacity;
      const double opacityError = RoundingError(opacity, storage);
      // In a group an opacity also shifts the weights of the colours, by at most the range.
      const double shift = end - first > 1 ? 2.0 : 1.0;
      bound.Color +=
        inFront * (opacity * RoundingError(largest, storage) + shift * range * opacityError);
      bound.Alpha += inFront * others * behind[end] * opacityError;
    }
    inFront *= groupTransmittance;
  }
  // Float32 sums in the resolve: a few roundings of 2^-24 a layer that mostly cancel. They do not
  // where T - T a is rounded the same way each time, because T a changes by less than a step from
  // layer to layer: for opacities up to 2^-12. Half a step of T, 2^-25, is lost each time then.
  const auto faint = std::count_if(layers.begin(), layers.end(),
    [](const Layer& layer) { return layer.Color.a > 0.0f && layer.Color.a <= 1.0f / 4096; });
  const double sums =
    2e-6 * (1.0 + double(layers.size()) / 1000.0) + std::ldexp(double(faint), -25);
  return bound + Tolerance{ sums * std::max(largest, 1.0), sums };
}

//------------------------------------------------------------------------------
Tolerance ReferenceCompositor::RoundingBoundOfAnyStack(int numberOfLayers, Storage storage)
{
  const double sums = 2e-6 * (1.0 + numberOfLayers / 1000.0);
  const double relative = RoundingError(1.0, storage);
  return { sums + 2.0 * relative, sums + relative };
}
}
