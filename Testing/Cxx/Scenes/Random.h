// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Random numbers, orders and layers that are the same on every machine.
 */

#ifndef Random_h
#define Random_h

#include "Rig/Layer.h"

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace vtkOITTest
{
class Random
{
public:
  explicit Random(unsigned int seed)
    : Engine(seed)
  {
  }

  /// In [0, 1). The standard's distributions differ between libraries.
  double Uniform() { return this->Engine() / 4294967296.0; }
  int Below(int bound) { return static_cast<int>(this->Uniform() * bound); }

  template <typename Value>
  void Shuffle(std::vector<Value>& values)
  {
    for (std::size_t i = values.size(); i > 1; --i)
    {
      std::swap(values[i - 1], values[this->Below(static_cast<int>(i))]);
    }
  }

  /// Distinct depths in [0.1, 0.9], shuffled. Multiples of 2^-24, which no step of the
  /// transformation rounds.
  std::vector<float> Depths(int count)
  {
    std::vector<float> depths(count);
    for (int i = 0; i < count; ++i)
    {
      const double depth = 0.1 + 0.8 * (i + 0.5) / count;
      depths[i] = static_cast<float>(std::ldexp(std::round(std::ldexp(depth, 24)), -24));
    }
    this->Shuffle(depths);
    return depths;
  }

  /// Layers at distinct depths with any colour and opacity, shuffled.
  std::vector<Layer> Layers(int count)
  {
    std::vector<Layer> layers;
    for (const float depth : this->Depths(count))
    {
      const glm::dvec4 color(
        this->Uniform(), this->Uniform(), this->Uniform(), 0.02 + 0.9 * this->Uniform());
      layers.push_back({ depth, glm::vec4(color) });
    }
    return layers;
  }

private:
  std::mt19937 Engine;
};

/// Layers of one colour at the given depths.
inline std::vector<Layer> EqualLayers(const std::vector<float>& depths, const glm::vec4& color)
{
  std::vector<Layer> layers;
  for (const float depth : depths)
  {
    layers.push_back({ depth, color });
  }
  return layers;
}
}

#endif
