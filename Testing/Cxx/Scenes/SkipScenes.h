// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Scenes of which it is known what needs no sorting.
 */

#ifndef SkipScenes_h
#define SkipScenes_h

#include "Scenes/SolidProps.h"

#include <functional>
#include <string>
#include <vector>

namespace vtkOITTest
{
constexpr int Any = -1;

struct SkipScene
{
  std::string Name;
  std::function<void(Rig&)> Build;
  int Invisible = 0; // props that are left out
  int Blended = 0;
  int Sorted = 0;
  int Passes = Any; // of frames without sorted props
  int Layers = 4;   // at most, at a pixel
};

std::vector<SkipScene> GetInvisibleScenes();
std::vector<SkipScene> GetFlatScenes();
std::vector<SkipScene> GetClosedScenes();
/// Deep ones, of which some props have no known order.
std::vector<SkipScene> GetPartialScenes();
}

#endif
