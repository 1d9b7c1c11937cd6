// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The right answer for one pixel, in double precision, straight from the definition.
 *
 * Layers are sorted by their window depth. Layers of bit-equal depth form a group, whatever the
 * order in which they were drawn:
 *
 *     group opacity  O = 1 - product of (1 - a)
 *     group colour   O * sum(a c) / sum(a)
 *
 * Groups are composited from near to far, C += T * group colour, T -= T * O, and the result goes
 * over what the framebuffer holds: C + T * destination, for colour and alpha alike (the result is
 * premultiplied).
 */

#ifndef ReferenceCompositor_h
#define ReferenceCompositor_h

#include "Rig/Layer.h"

#include <glm/vec4.hpp>

#include <vector>

namespace vtkOITTest
{
class ReferenceCompositor
{
public:
  /// The pixel that the layers give over a destination pixel (premultiplied RGBA).
  static glm::dvec4 Composite(std::vector<Layer> layers, const glm::dvec4& destination);

  /// How far the pixel may be from Composite() because fragments were rounded to the storage
  /// format and the sums are made in float32: the sum over the layers of |dC/dx| times the
  /// largest rounding error of x, for x the layer's colour and opacity.
  static Tolerance RoundingBound(
    std::vector<Layer> layers, const glm::dvec4& destination, Storage storage);

  /// The same for any stack of up to so many layers with colours in [0,1]. The derivatives weighted
  /// with the opacities sum up to at most 1 for the colours, the opacities' effect on colour, and
  /// their effect on alpha, each; so 2 and 1 relative errors of the format.
  static Tolerance RoundingBoundOfAnyStack(int numberOfLayers, Storage storage);
};
}

#endif
